//! Pieces of given sizes from ballast of any mass: what is least without sizes, with room in the limits for what rounding to pieces changes.

use super::interval::Interval;
use super::problem::{Column, Problem};
use super::relaxation::Placed;
use super::row::{Functional, Kind, weights};
use super::search::Search;

/// How well the least of any mass is known, as a part of it.
const ROUGH: f64 = 1e-4;

/// The room that is tried first, in pieces of each site.
const FIRST: f64 = 0.5;

/// How often it is halved until it leaves some ballast, and how often the mass is raised.
const TRIES: usize = 6;

/// No more than this part of the effort.
const SHARE: usize = 12;

/// No more than this part of what is between two limits is left as room.
const WIDE: f64 = 0.45;

impl Problem {
    /// The same with any mass at lines, discs and circles, and limits so much narrower as pieces at them may change: room is in the greatest piece of each.
    fn without_sizes(&self, room: f64) -> Self {
        let mut problem = self.clone();
        let free = || (0..self.charts.len()).filter(|site| self.has_free_pieces(*site));
        let changed = |of: &dyn Fn([Interval; 10]) -> f64| {
            let most = |site: usize| {
                let seeds = self.charts[site].seeds();
                let most = seeds.into_iter().map(|at| of(weights(self.local(at))));
                most.fold(0.0, f64::max) * self.sizes[site].last().copied().unwrap_or_default()
            };
            room * free().map(most).sum::<f64>()
        };
        for block in &mut problem.blocks {
            let size = |row: &Functional, w: [Interval; 10]| row.at(&w).middle().abs();
            match block.kind {
                Kind::Positive => block.rows.iter_mut().for_each(|row| {
                    let by = changed(&|w| size(row, w));
                    row.constant = row.constant - Interval::from(by);
                }),
                Kind::Cone => {
                    let by = changed(&|w| block.rows.iter().map(|row| size(row, w)).sum());
                    if let Some(row) = block.rows.first_mut() {
                        row.constant = row.constant - Interval::from(by);
                    }
                }
                Kind::Zero => {}
            }
        }
        for product in &mut problem.products {
            let [u, v] = product.axes;
            let by = changed(&|w| Functional::second(u, v).at(&w).middle().abs());
            let by = match (product.least, product.most) {
                (Some(least), Some(most)) => by.min(WIDE * (most - least)),
                _ => by,
            };
            product.least = product.least.map(|least| least + by);
            product.most = product.most.map(|most| most - by);
        }
        for site in free() {
            problem.sizes[site].clear();
            problem.sums[site] = None;
        }
        problem.totals = None;
        problem
    }
}

impl Search<'_> {
    /// Looks for pieces near what is least without sizes.
    pub(super) fn guide(&mut self) {
        let problem = self.problem;
        if !(0..problem.charts.len()).any(|site| problem.has_free_pieces(site)) {
            return;
        }
        let total = |pieces: &[(Column, f64)]| pieces.iter().map(|(_, mass)| mass).sum::<f64>();
        let Some(least) = self.with_room(0.0) else { return };
        let none = total(&least);
        self.round(&least, 1.0);
        let (mut room, mut wider) = (FIRST, None);
        for _ in 0..TRIES {
            wider = self.with_room(room);
            if wider.is_some() {
                break;
            }
            room *= 0.5;
        }
        if let Some(wider) = &wider {
            self.round(wider, 1.0);
        }
        let per_room = wider.map_or(f64::INFINITY, |wider| (total(&wider) - none) / room);
        // As much room as there is at the least masses that pieces can have.
        let sizes = problem.sizes.iter().flatten().copied();
        let mut step = sizes.fold(f64::INFINITY, f64::min);
        let mut mass = problem.attainable(none);
        for _ in 0..TRIES {
            if mass >= self.limit() || self.work.left < self.effort / 2 {
                break;
            }
            let room = if per_room > 0.0 { (mass - none) / per_room } else { 0.0 };
            let found = if room > 0.0 { self.with_room(room) } else { Some(least.clone()) };
            if let Some(found) = found {
                self.round(&found, mass / total(&found));
            }
            mass = problem.attainable(mass + step);
            step *= 2.0;
        }
    }

    /// The least with so much room, of any masses.
    fn with_room(&mut self, room: f64) -> Option<Vec<(Column, f64)>> {
        let problem = self.problem.without_sizes(room);
        let outcome = Search::new(&problem, ROUGH, self.work.left.min(self.effort / SHARE)).run();
        self.work.left -= outcome.effort;
        outcome.found
    }

    /// Looks for pieces near ballast of any masses, of so much more.
    fn round(&mut self, found: &[(Column, f64)], more: f64) {
        let placed =
            |(column, mass): &(Column, f64)| Placed { cell: column.site, column: *column, mass: more * mass };
        let placed: Vec<Placed> = found.iter().map(placed).collect();
        let region = self.problem.root(self.problem.cap);
        for many in [false, true] {
            let pieces = self.problem.in_pieces(&region, &placed, many);
            self.offer_near(&pieces, None);
        }
    }
}
