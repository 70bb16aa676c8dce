//! Ballast near ballast: pieces in place of what a region has, moved and weighed anew.

use super::problem::{Column, Problem};
use super::region::{Cell, Region};
use super::relaxation::{Placed, Until, Work};
use super::row::{Functional, weights};
use super::sums::Pieces;

/// How far pieces may move in each step, as a part of their site: moments of places in between are wrong by the square.
const REACHES: [(f64, Until); 4] =
    [(0.3, Until::Roughly), (0.1, Until::Roughly), (0.03, Until::Roughly), (0.01, Until::Solved)];

/// A piece farther from where it is best, as a part of its site, is not moved there.
const SETTLED: f64 = 0.1;

/// How far pieces at one place are moved apart, as a part of their site.
const SPREAD: f64 = 0.4;

/// So many pieces of a part of a site have places of their own; of more, those of one place are one,
const FEW: u64 = 12;

/// but so many.
const SINGLES: u64 = 2;

/// How many pieces of a size each place gets, by what is left of its mass: whole ones, then one by one where most is left.
fn dealt(size: f64, count: u64, left: &mut [f64]) -> Vec<u64> {
    let mut counts = vec![0; left.len()];
    let mut rest = count;
    for (own, left) in counts.iter_mut().zip(left.iter_mut()) {
        *own = ((*left / size).max(0.0).floor() as u64).min(rest);
        *left -= *own as f64 * size;
        rest -= *own;
    }
    while rest > 0 {
        let Some(at) = (0..left.len()).max_by(|i, j| left[*i].total_cmp(&left[*j])) else { break };
        // Where pieces are more than their mass, all that are over are at one place.
        let over = if left[at] > 0.0 { 1 } else { rest };
        counts[at] += over;
        left[at] -= over as f64 * size;
        rest -= over;
    }
    counts
}

impl Problem {
    /// Pieces of the sizes that sites have, few or many, in place of what a region has.
    pub(super) fn in_pieces(&self, region: &Region, placed: &[Placed], many: bool) -> Vec<(Column, f64)> {
        let mut all = Vec::new();
        for (k, cell) in region.leaves() {
            let own: Vec<_> = placed.iter().filter(|piece| piece.cell == k && piece.mass > 0.0).collect();
            let total: f64 = own.iter().map(|piece| piece.mass).sum();
            let Some(sums) = self.sums[cell.site].as_ref().filter(|_| self.has_free_pieces(cell.site)) else {
                all.extend(own.iter().map(|piece| (piece.column, piece.mass)));
                continue;
            };
            let Some(pieces) = sums.pieces(sums.near(total, cell.sums), many) else { continue };
            let is_few = pieces.iter().map(|one| one.count).sum::<u64>() <= FEW;
            let mut left: Vec<f64> = own.iter().map(|piece| piece.mass).collect();
            for Pieces { size, count } in pieces {
                for (count, piece) in dealt(size, count, &mut left).into_iter().zip(&own) {
                    let at = self.charts[cell.site].nearest(piece.column.at);
                    let singles = if is_few { count } else { count.min(SINGLES) };
                    let stack = (count > singles).then_some((count - singles) as f64 * size);
                    let all_of_it = stack.into_iter().chain((0..singles).map(|_| size));
                    all.extend(all_of_it.map(|mass| (Column { at, ..piece.column }, mass)));
                }
            }
        }
        all
    }

    /// Pieces moved near their places, and weighed anew where any mass will do, such that limits are met with the least mass.
    pub(super) fn moved(&self, pieces: &[(Column, f64)], work: &mut Work) -> Option<Vec<(Column, f64)>> {
        let (mut pieces, mut is_solved) = (pieces.to_vec(), false);
        for (reach, until) in REACHES {
            let region = self.around(&pieces, reach);
            let mut own = Work::new(work.left);
            let relaxed = self.relaxed(&region, &mut own, until);
            (work.left, work.is_spent) = (own.left, own.is_spent);
            let Some(placed) = relaxed.and_then(|relaxed| relaxed.pieces) else {
                is_solved = false;
                continue;
            };
            is_solved = true;
            pieces.clear();
            // A piece is at a point, or in parts of a part of a site.
            let owners = region.owners();
            let is_of = |k: usize, piece: &&Placed| piece.cell == k || owners[piece.cell] == Some(k);
            for (k, cell) in region.cells.iter().enumerate() {
                let is_piece = match owners[k] {
                    None => cell.chart.is_point(),
                    Some(owner) => owners[owner].is_none(),
                };
                if !is_piece {
                    continue;
                }
                let own = placed.iter().filter(|piece| is_of(k, piece));
                let total: f64 = own.clone().map(|piece| piece.mass).sum();
                if total > 0.0 {
                    let mean = |k: usize| own.clone().map(|p| p.mass / total * p.column.at[k]).sum();
                    let at = self.charts[cell.site].nearest(core::array::from_fn(mean));
                    pieces.push((Column { site: cell.site, at }, total));
                }
            }
        }
        is_solved.then_some(pieces)
    }

    /// Pieces at one place moved apart, to either side: what they have in common does not say to which each is to go.
    pub(super) fn spread(&self, pieces: &[(Column, f64)]) -> Vec<(Column, f64)> {
        let mut spread = pieces.to_vec();
        for (k, (column, _)) in pieces.iter().enumerate().filter(|(_, (of, _))| self.has_free_pieces(of.site))
        {
            let chart = &self.charts[column.site];
            let before = pieces[..k].iter().filter(|(other, _)| other == column).count();
            if let (1.., Some(along)) = (before, chart.freedoms(column.at).first()) {
                let by = if before % 2 == 1 { SPREAD } else { -SPREAD };
                spread[k].0.at = chart.nearest(core::array::from_fn(|k| column.at[k] + by * along[k]));
            }
        }
        spread
    }

    /// Pieces on lines, discs and circles, each where a price is least about it.
    pub(super) fn settled(&self, pieces: &[(Column, f64)], price: &Functional) -> Vec<(Column, f64)> {
        let settled = |(column, mass): &(Column, f64)| {
            let chart = &self.charts[column.site];
            let at = chart.least_about(price, self.origin, column.at);
            let at = if chart.are_near(at, column.at, SETTLED) { at } else { column.at };
            (Column { at, ..*column }, *mass)
        };
        pieces.iter().map(settled).collect()
    }

    /// Each piece in a part of its site about it; of other sites, points that take any mass.
    fn around(&self, pieces: &[(Column, f64)], reach: f64) -> Region {
        let mut cells: Vec<Cell> = (0..self.charts.len()).map(|site| self.cell(site, self.cap)).collect();
        for (site, chart) in self.charts.iter().enumerate() {
            let own: Vec<_> = pieces.iter().filter(|(column, _)| column.site == site).collect();
            let has_sizes = self.sums[site].is_some();
            if chart.is_point() {
                if has_sizes {
                    cells[site].masses = [own.iter().map(|(_, mass)| mass).sum(); 2];
                }
                continue;
            }
            if own.is_empty() {
                cells[site].masses = [0.0; 2];
            }
            for (column, mass) in own {
                let place = cells.len();
                cells[site].parts.push(place);
                let masses = if has_sizes { [*mass; 2] } else { cells[site].masses };
                let part = Cell { masses: [0.0, self.cap], parts: Vec::new(), ..cells[site].clone() };
                let charts = chart.about(column.at, reach);
                let parts = (1..=charts.len()).map(|k| place + k).collect();
                cells.push(Cell { masses, parts, ..part.clone() });
                cells.extend(charts.into_iter().map(|chart| Cell { chart, ..part.clone() }));
            }
        }
        let total: f64 = pieces.iter().map(|(_, mass)| mass).sum();
        let boxes = self.boxes(2.0 * total);
        let boxes = self.center(pieces).into_iter().zip(boxes).map(|(at, [low, high])| {
            let half = reach * (high - low);
            [at - half, at + half]
        });
        Region { boxes: boxes.collect(), cells }
    }

    /// By how much moments in a cell are beside those of pieces in it, as a part of what limits are made of: the most of all limits.
    pub(super) fn apart(&self, region: &Region, placed: &[Placed], cell: usize) -> f64 {
        let own: Vec<Placed> = placed.iter().filter(|piece| piece.cell == cell).copied().collect();
        let pieces = self.in_pieces(region, &own, false);
        let of = |row: &Functional, column: &Column| row.at(&weights(self.local(column.at))).middle();
        let beside = |row: &Functional| {
            let own: f64 = own.iter().map(|p| p.mass * of(row, &p.column)).sum();
            let other: f64 = pieces.iter().map(|(column, mass)| mass * of(row, column)).sum();
            let size: f64 = placed.iter().map(|p| (p.mass * of(row, &p.column)).abs()).sum();
            (own - other).abs() / (size + row.constant.size()).max(f64::MIN_POSITIVE)
        };
        let functions = self.functions();
        functions.iter().map(beside).fold(0.0, f64::max)
    }
}
