//! Multistart of the local search, and exchanges of pieces of given sizes.

use super::problem::{Lot, Problem, ROUNDING, total};

/// Masses of starts at a single place, in masses of the body. They are used if products are
/// limited.
const ALONE: [f64; 3] = [0.2, 2.0, 20.0];

/// Largest number of exchanges. An exchange in which lots move counts as `MOVES` for each lot.
const WORK: usize = 500_000;
const MOVES: usize = 16;

/// Remainders that are rounded up to one piece, relative to the least piece.
const SHARES: [f64; 3] = [1.0, 0.5, 0.0];

/// Largest number of pieces at one place that move singly. Of more pieces, all but `SINGLES` move
/// together.
const FEW: f64 = 12.0;
const SINGLES: usize = 2;

/// Largest number of exchanges at two sites after which exchanges at three sites are tried.
const TRIPLES: usize = 5_000;

/// Relative difference below which masses are equal.
const SAME: f64 = 1e-10;

pub(super) struct Search<'a> {
    problem: &'a Problem,
    work: usize,
    best: Option<Vec<Lot>>,
}

impl<'a> Search<'a> {
    /// Returns the lightest ballast that the search finds.
    pub(super) fn best(problem: &'a Problem) -> Option<Vec<Lot>> {
        let mut search = Self { problem, work: 0, best: None };
        search.offer(&[]);
        let mut starts = vec![(0.0, Vec::new())];
        for part in ALONE.into_iter().filter(|_| problem.has_products()) {
            let mass = |site: usize| (part * problem.mass).min(problem.most[site]);
            let seeds = problem.seeds().into_iter();
            starts.extend(seeds.map(|lot| (part, vec![Lot { mass: mass(lot.site), ..lot }])));
        }
        for (part, start) in starts {
            // Heavy starts are tried only if no lighter one succeeded.
            if search.best.is_some() && (search.limit() == 0.0 || part > ALONE[0]) {
                break;
            }
            let (lots, _) = problem.relaxed(&start);
            if problem.sizes.iter().all(Vec::is_empty) {
                for lots in [problem.merged(&lots), lots] {
                    search.offer(&problem.local_minimum(lots).0);
                }
                continue;
            }
            for share in SHARES {
                search.exchange(problem.rounded(&lots, share));
            }
        }
        // The best pieces may be far from the best arbitrary masses.
        if problem.sizes.iter().any(|sizes| !sizes.is_empty()) {
            search.exchange(Vec::new());
        }
        search.best
    }

    /// Replaces the incumbent by ballast that meets all limits and is lighter, or has fewer lots.
    fn offer(&mut self, lots: &[Lot]) {
        let fewer = self.best.as_ref().is_some_and(|best| lots.len() < best.len());
        let limit = self.limit() * if fewer { 1.0 + 2.0 * SAME } else { 1.0 };
        if total(lots) < limit && self.problem.is_met(lots) {
            self.best = Some(lots.to_vec());
        }
    }

    /// Returns the mass below which ballast is lighter than the incumbent.
    fn limit(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| total(best) * (1.0 - SAME))
    }

    /// Exchanges pieces at up to two sites, or three if all are points, as long as that helps.
    ///
    /// An exchange helps if it lowers the violation, or meets the limits with a lower mass. If the
    /// limits are met, exchanges are tried in the order of the mass of all pieces. Otherwise, they
    /// are tried in the order of the violation.
    fn exchange(&mut self, start: Vec<Lot>) {
        let problem = self.problem;
        let (mut lots, mut violation) = problem.local_minimum(start);
        let seeds = problem.seeds().into_iter();
        let free: Vec<Lot> = seeds.filter(|lot| problem.sizes[lot.site].is_empty()).collect();
        let moves = !lots.iter().all(|lot| lot.size.is_some() && problem.charts[lot.site].is_point());
        'better: loop {
            if violation == 0.0 {
                self.offer(&lots);
            }
            let limit = self.limit();
            let key = |lots: &[Lot]| {
                let sized: f64 = lots.iter().filter(|lot| lot.size.is_some()).map(|lot| lot.mass).sum();
                (sized < limit).then(|| if violation == 0.0 { sized } else { problem.violation(lots) })
            };
            let mut all = vec![(0, lots.clone())];
            for depth in 0..3 {
                if depth == 2 && (moves || all.len() > TRIPLES) {
                    break;
                }
                all = all.iter().flat_map(|(site, one)| problem.exchanged(one, *site)).collect();
                self.work += all.len();
                let keyed = all.iter().filter_map(|(_, lots)| Some((key(lots)?, lots)));
                let mut tried: Vec<(f64, &Vec<Lot>)> = keyed.collect();
                tried.sort_by(|a, b| a.0.total_cmp(&b.0));
                for (_, trial) in tried {
                    self.work += if moves { MOVES * trial.len() } else { 0 };
                    if self.work > WORK {
                        return;
                    }
                    let next = problem.local_minimum([&trial[..], &free].concat());
                    let helps = if next.1 == 0.0 { total(&next.0) < limit } else { next.1 < 0.9 * violation };
                    if helps {
                        (lots, violation) = next;
                        continue 'better;
                    }
                }
            }
            return;
        }
    }
}

impl Problem {
    /// Returns lots whose masses are replaced by pieces, the largest sizes first.
    ///
    /// A remainder of at least `share` of the least size is rounded up to one piece.
    fn rounded(&self, lots: &[Lot], share: f64) -> Vec<Lot> {
        let mut all: Vec<Lot> = Vec::new();
        for lot in lots {
            let sizes = &self.sizes[lot.site];
            if sizes.is_empty() {
                all.push(*lot);
            }
            if self.charts[lot.site].is_point() {
                let target = (1.5 - share) * lot.mass;
                let beside = |mass: &f64| (mass - target).abs();
                let nearest = sizes.iter().copied().min_by(|a, b| beside(a).total_cmp(&beside(b)));
                let nearest = nearest.filter(|size| 2.0 * target > *size);
                all.extend(nearest.map(|mass| Lot { mass, size: Some(mass), ..*lot }));
                continue;
            }
            let mut rest = lot.mass;
            for (k, size) in sizes.iter().enumerate().rev() {
                let over = if k == 0 { 1.0 - share } else { ROUNDING };
                let count = (rest / size + over).floor();
                rest -= count * size;
                let singles = if count > FEW { SINGLES } else { count as usize };
                let pile = (count - singles as f64) * size;
                let masses = core::iter::once(pile).chain((0..singles).map(|_| *size));
                all.extend(masses.filter(|mass| *mass > 0.0).map(|mass| Lot {
                    mass,
                    size: Some(*size),
                    ..*lot
                }));
            }
        }
        all
    }

    /// Returns the results of all exchanges of one piece, at the sites from `from` on.
    ///
    /// A piece or none is removed, and another or none is added where the violation is then least.
    /// Each of a few places is tried if there is at most one piece next to sites for any mass. Each
    /// result has the first site for a further exchange.
    fn exchanged(&self, lots: &[Lot], from: usize) -> Vec<(usize, Vec<Lot>)> {
        let mut all = Vec::new();
        let pieces = lots.iter().filter(|lot| lot.size.is_some()).count();
        let tries_places = pieces <= 1 && self.sizes.iter().any(Vec::is_empty);
        for (site, sizes) in self.sizes.iter().enumerate().skip(from) {
            let choices = || sizes.iter().copied().map(Some).chain([None]);
            for (takes, puts) in choices().flat_map(|takes| choices().map(move |puts| (takes, puts))) {
                let mut lots = lots.to_vec();
                let mut places = self.charts[site].seeds();
                if let Some(size) = takes {
                    let own = (0..lots.len()).filter(|k| lots[*k].site == site && lots[*k].size == takes);
                    let least = own.min_by(|i, j| lots[*i].mass.total_cmp(&lots[*j].mass));
                    let Some(least) = least.filter(|_| takes != puts) else { continue };
                    places.push(lots[least].at);
                    lots[least].mass -= size;
                    lots.retain(|lot| lot.size.is_none_or(|size| lot.mass > 0.5 * size));
                }
                let mut results = vec![lots];
                if let Some(size) = puts {
                    let lots = &results[0];
                    places.extend(lots.iter().filter(|lot| lot.site == site).map(|lot| lot.at));
                    let put = |at| [&lots[..], &[Lot { site, at, mass: size, size: puts }]].concat();
                    let mut put: Vec<Vec<Lot>> = places.into_iter().map(put).collect();
                    // The violation without the other masses does not tell which place is best.
                    if !tries_places {
                        put.sort_by(|a, b| self.violation(a).total_cmp(&self.violation(b)));
                        put.truncate(1);
                    }
                    results = put;
                }
                results.retain(|lots| takes != puts && self.fits(lots));
                let next = site + usize::from(self.charts[site].is_point());
                all.extend(results.into_iter().map(|lots| (next, lots)));
            }
        }
        all
    }
}
