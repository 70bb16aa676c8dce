//! How regions are parted, and how tight they can be.

use super::problem::Problem;
use super::proof::Branch;
use super::region::{Cell, Region};

impl Problem {
    /// All of a site.
    pub(super) fn cell(&self, site: usize, cap: f64) -> Cell {
        let chart = &self.charts[site];
        let mut cell = Cell {
            site,
            part: chart.whole(),
            chart: chart.clone(),
            sums: [0; 2],
            masses: [0.0, self.most[site]],
            parts: Vec::new(),
        };
        if let Some(sums) = &self.sums[site] {
            cell.sums = [0, sums.last_to(cap).unwrap_or(0)];
        }
        self.weigh(&mut cell);
        cell
    }

    /// Takes the masses from the sums.
    pub(super) fn weigh(&self, cell: &mut Cell) {
        if let Some(sums) = &self.sums[cell.site] {
            cell.masses = [sums.at(cell.sums[0])[0], sums.at(cell.sums[1])[1]];
        }
    }

    pub(super) fn split(&self, region: &Region, branch: Branch) -> [Region; 2] {
        let [mut below, mut above] = [region.clone(), region.clone()];
        match branch {
            Branch::Sum { cell, index } => {
                below.cells[cell].sums[1] = below.cells[cell].sums[1].min(index);
                above.cells[cell].sums[0] = above.cells[cell].sums[0].max(index + 1);
                self.tighten(&mut below);
                self.tighten(&mut above);
            }
            Branch::Center { coordinate, at } => {
                below.boxes[coordinate][1] = below.boxes[coordinate][1].min(at);
                above.boxes[coordinate][0] = above.boxes[coordinate][0].max(at);
            }
        }
        [below, above]
    }

    /// The same with a cell parted where a coordinate has a value.
    pub(super) fn parted(&self, region: &Region, cell: usize, axis: usize, at: f64) -> Region {
        let mut region = region.clone();
        let whole = region.cells[cell].clone();
        for end in [1, 0] {
            let mut part = Cell { sums: [0, whole.sums[1]], ..whole.clone() };
            part.part[axis][end] = at;
            part.chart = self.charts[part.site].covering(&part.part);
            let place = region.cells.len();
            region.cells[cell].parts.push(place);
            region.cells.push(part);
        }
        self.tighten(&mut region);
        region
    }

    /// Leaves out sums that cells cannot have because of those that they are parts of, or that are parts of them.
    pub(super) fn tighten(&self, region: &mut Region) {
        loop {
            let before = region.cells.clone();
            for (k, whole) in before.iter().enumerate().filter(|(_, cell)| !cell.parts.is_empty()) {
                let Some(sums) = &self.sums[whole.site] else { continue };
                let [own_least, own_most] = [sums.at(whole.sums[0])[0], sums.at(whole.sums[1])[1]];
                let of = |end: usize| -> Vec<f64> {
                    whole.parts.iter().map(|part| sums.at(before[*part].sums[end])[end]).collect()
                };
                let (leasts, mosts) = (of(0), of(1));
                let (least, most) = (leasts.iter().sum::<f64>(), mosts.iter().sum::<f64>());
                let narrow = |cell: &mut Cell, least: f64, most: f64| {
                    cell.sums[0] = cell.sums[0].max(sums.first_from(least - ROUNDING * own_most));
                    let last = sums.last_to(most + ROUNDING * own_most);
                    match last {
                        Some(last) => cell.sums[1] = cell.sums[1].min(last),
                        None => cell.sums = [1, 0],
                    }
                };
                narrow(&mut region.cells[k], least, most);
                for ((part, its_least), its_most) in whole.parts.iter().zip(leasts).zip(mosts) {
                    let cell = &mut region.cells[*part];
                    narrow(cell, own_least - (most - its_most), own_most - (least - its_least));
                }
            }
            if region.is_empty() || region.cells.iter().zip(&before).all(|(a, b)| a.sums == b.sums) {
                break;
            }
        }
        region.cells.iter_mut().for_each(|cell| self.weigh(cell));
    }

    /// Where a cell is to be parted for points of it: across the coordinate in which they are farthest from each other, near their middle; `None` if it is too narrow.
    pub(super) fn parting(&self, cell: &Cell, points: &[([f64; 3], f64)]) -> Option<(usize, f64)> {
        let chart = &self.charts[cell.site];
        let of = |axis: usize| {
            let [low, high] = cell.part[axis];
            let value = |at: [f64; 3]| chart.coordinates(at)[axis].clamp(low, high);
            let total: f64 = points.iter().map(|(_, mass)| mass).sum();
            let mean = points.iter().map(|(at, mass)| mass * value(*at)).sum::<f64>() / total;
            let spread = points.iter().map(|(at, mass)| mass * (value(*at) - mean).powi(2)).sum::<f64>();
            // Where points are at one place, the wider side.
            let width = high - low;
            let mean = if mean.is_finite() { mean } else { 0.5 * low + 0.5 * high };
            let at = mean.clamp(low + 0.3 * width, high - 0.3 * width);
            (width > NARROW).then_some((
                spread / total.max(f64::MIN_POSITIVE) + 0.02 * width * width,
                axis,
                at,
            ))
        };
        let best = [0, 1].into_iter().filter_map(of).max_by(|a, b| a.0.total_cmp(&b.0));
        best.map(|(_, axis, at)| (axis, at))
    }
}

/// More than differences of sums are wrong by, as a part of the greatest.
const ROUNDING: f64 = 1e-13;

/// A part narrower than this part of its site is not parted.
const NARROW: f64 = 1e-9;
