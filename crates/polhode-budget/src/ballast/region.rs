//! Parts of what ballast may be: of places, of the sums of sizes in them, and of centres.

use super::chart::{Chart, Part};

/// Part of what ballast may be: what is in each part of each site, and between which values each coordinate of the centre is.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Region {
    /// The sites in their order, then parts of them.
    pub(super) cells: Vec<Cell>,
    pub(super) boxes: Vec<[f64; 2]>,
}

/// Part of a site.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) site: usize,
    /// In the coordinates of the site.
    pub(super) part: Part,
    /// What covers it.
    pub(super) chart: Chart,
    /// From which to which of the sums of the site.
    pub(super) sums: [usize; 2],
    /// From which to which mass, kg.
    pub(super) masses: [f64; 2],
    /// The cells that it is parted into.
    pub(super) parts: Vec<usize>,
}

impl Region {
    /// The cells that are not parted, with their places.
    pub(super) fn leaves(&self) -> impl Iterator<Item = (usize, &Cell)> {
        self.cells.iter().enumerate().filter(|(_, cell)| cell.parts.is_empty())
    }

    /// What each cell is a part of.
    pub(super) fn owners(&self) -> Vec<Option<usize>> {
        let mut owners = vec![None; self.cells.len()];
        for (k, cell) in self.cells.iter().enumerate() {
            cell.parts.iter().for_each(|part| owners[*part] = Some(k));
        }
        owners
    }

    /// The sum over the leaves of each cell.
    pub(super) fn summed(&self, of_leaves: impl Iterator<Item = (usize, f64)>) -> Vec<f64> {
        let mut sums = vec![0.0; self.cells.len()];
        of_leaves.for_each(|(cell, value)| sums[cell] += value);
        // Parts stand behind what they are parts of.
        for k in (0..self.cells.len()).rev() {
            let parts: f64 = self.cells[k].parts.iter().map(|part| sums[*part]).sum();
            sums[k] += parts;
        }
        sums
    }

    /// Whether nothing is in it.
    pub(super) fn is_empty(&self) -> bool {
        self.cells.iter().any(|cell| cell.sums[0] > cell.sums[1])
            || self.boxes.iter().any(|[low, high]| low > high)
    }
}
