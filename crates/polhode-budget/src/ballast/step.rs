//! How a region is split.

use super::problem::Problem;
use super::proof::Branch;
use super::region::{Cell, Region};
use super::relaxation::Placed;
use super::row::Functional;

/// A region of centres narrower than this part of the first is not split.
const NARROW: f64 = 1e-9;

/// How a region is split.
#[derive(Clone, Copy)]
pub(super) enum Step {
    /// Into two.
    Split(Branch),
    /// A part of a site in it into two.
    Part { cell: usize, axis: usize, at: f64 },
}

/// What splits regions: of what question, and the first of them.
#[derive(Clone, Copy)]
pub(super) struct Splitting<'a> {
    pub(super) problem: &'a Problem,
    pub(super) first: &'a Region,
}

impl Splitting<'_> {
    /// Where a region is to be split: at a sum between two that there are; in a part of a site, whose moments are farthest from those of pieces in it; or across the centre by which a broken product is bounded least well.
    pub(super) fn step(&self, region: &Region, placed: &[Placed]) -> Option<Step> {
        let problem = self.problem;
        let totals = region.summed(placed.iter().map(|piece| (piece.cell, piece.mass)));
        let between = region.cells.iter().enumerate().filter_map(|(k, cell)| {
            let (sums, [least, most]) = (problem.sums[cell.site].as_ref()?, cell.sums);
            let above = sums.first_from(totals[k]).clamp(least.min(most) + 1, most.max(least + 1));
            let (low, high) = (sums.at(above - 1)[1], sums.at(above)[0]);
            let beside = (totals[k] - low).abs().min((high - totals[k]).abs());
            let is_between = totals[k] > low && totals[k] < high && beside > 1e-7 * high;
            (least < most && is_between).then_some((beside, Branch::Sum { cell: k, index: above - 1 }))
        });
        let between = between.max_by(|a, b| a.0.total_cmp(&b.0));
        let center = self.across(region, placed);
        if let Some((beside, branch)) = between {
            // As a part of all ballast: fine sizes matter less than products.
            let total: f64 = placed.iter().map(|piece| piece.mass).sum();
            return match center {
                Some((broken, step)) if broken * total > beside => Some(step),
                _ => Some(Step::Split(branch)),
            };
        }
        let free = region.leaves().filter(|(_, cell)| problem.has_free_pieces(cell.site));
        let apart = free.map(|(k, cell)| (problem.apart(region, placed, k), k, cell));
        let apart = apart.filter(|(by, ..)| *by > 1e-9).max_by(|a, b| a.0.total_cmp(&b.0));
        match (apart, center) {
            (Some((by, k, cell)), center) if center.is_none_or(|(broken, _)| by > broken) => {
                let own = placed.iter().filter(|piece| piece.cell == k);
                let own: Vec<_> = own.map(|piece| (piece.column.at, piece.mass)).collect();
                let parting = problem.parting(cell, &own);
                parting.map(|(axis, at)| Step::Part { cell: k, axis, at }).or(center.map(|(_, step)| step))
            }
            (_, center) => center.map(|(_, step)| step),
        }
    }

    /// Across which centre a region is to be split, and by how much the worst product there is broken, as a part of its size.
    fn across(&self, region: &Region, placed: &[Placed]) -> Option<(f64, Step)> {
        let problem = self.problem;
        let pieces: Vec<_> = placed.iter().map(|piece| (piece.column, piece.mass)).collect();
        let broken = problem.broken_products(&pieces);
        let worst = problem.products.iter().zip(&broken).filter(|(_, by)| **by > 0.0);
        let (product, by) = worst.max_by(|a, b| a.1.total_cmp(b.1))?;
        let [i, j] = product.coordinates;
        let coordinate = if self.wide(region, i) >= self.wide(region, j) { i } else { j };
        let [low, high] = region.boxes[coordinate];
        let width = high - low;
        let at = problem.center(&pieces)[coordinate].clamp(low + 0.2 * width, high - 0.2 * width);
        let size = Functional::second(product.axes[0], product.axes[1]);
        let size = size.added_to(problem.whole(product.basis)).size;
        (self.wide(region, coordinate) > NARROW)
            .then_some((*by / size.max(f64::MIN_POSITIVE), Step::Split(Branch::Center { coordinate, at })))
    }

    /// How wide a coordinate of the centre is, as a part of what it is in all.
    fn wide(&self, region: &Region, k: usize) -> f64 {
        let whole = self.first.boxes[k][1] - self.first.boxes[k][0];
        if whole > 0.0 { (region.boxes[k][1] - region.boxes[k][0]) / whole } else { 0.0 }
    }

    /// Where a region of which nothing is known is split.
    pub(super) fn middle(&self, region: &Region) -> Option<Step> {
        let sums = region.leaves().filter(|(_, cell)| cell.sums[0] < cell.sums[1]);
        if let Some((cell, of)) = sums.max_by_key(|(_, cell)| cell.sums[1] - cell.sums[0]) {
            let [least, most] = of.sums;
            return Some(Step::Split(Branch::Sum { cell, index: (least + most - 1) / 2 }));
        }
        let center = (0..region.boxes.len()).map(|k| (self.wide(region, k), k));
        let center = center.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(wide, _)| *wide > NARROW);
        let free = region
            .leaves()
            .filter(|(_, cell)| self.problem.has_free_pieces(cell.site) && cell.masses[1] > 0.0);
        let parting = |(k, cell): (usize, &Cell)| {
            let (axis, at) = self.problem.parting(cell, &[])?;
            let part = cell.chart.size() / self.problem.charts[cell.site].size();
            Some((part, Step::Part { cell: k, axis, at }))
        };
        let part = free.filter_map(parting).max_by(|a, b| a.0.total_cmp(&b.0));
        match (center, part) {
            (Some((wide, _)), Some((part, step))) if part > wide => Some(step),
            (Some((_, coordinate)), _) => {
                let [low, high] = region.boxes[coordinate];
                Some(Step::Split(Branch::Center { coordinate, at: 0.5 * low + 0.5 * high }))
            }
            (None, part) => part.map(|(_, step)| step),
        }
    }
}
