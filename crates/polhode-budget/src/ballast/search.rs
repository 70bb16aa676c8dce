//! Starts of the local search, and exchanges of pieces of given sizes.

use super::problem::{Lot, Problem, ROUNDING, total};

/// Masses of the ballast that starts have at a single place where products are limited, as parts of the body.
const ALONE: [f64; 3] = [0.2, 2.0, 20.0];

/// The most exchanges; one in which lots move counts as this many for each of them.
const WORK: usize = 500_000;
const MOVES: usize = 16;

/// Shares of the least piece from which on a remainder is one.
const SHARES: [f64; 3] = [1.0, 0.5, 0.0];

/// More pieces at one place move together, but a few.
const FEW: f64 = 12.0;
const SINGLES: usize = 2;

/// Exchanges at three sites are tried after no more than this many at two.
const TRIPLES: usize = 5_000;

/// Changes of the mass below this part are none.
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
            // Heavy ballast is tried if no other was found.
            if search.best.is_some() && (search.limit() == 0.0 || part > ALONE[0]) {
                break;
            }
            let (lots, _) = problem.solved(&start);
            if problem.sizes.iter().all(Vec::is_empty) {
                for lots in [problem.merged(&lots), lots] {
                    search.offer(&problem.improved(lots).0);
                }
                continue;
            }
            for share in SHARES {
                search.exchange(problem.in_pieces(&lots, share));
            }
        }
        search.best
    }

    /// Takes ballast that meets all limits and is lighter than what was found, or has fewer lots.
    fn offer(&mut self, lots: &[Lot]) {
        let fewer = self.best.as_ref().is_some_and(|best| lots.len() < best.len());
        let limit = self.limit() * if fewer { 1.0 + 2.0 * SAME } else { 1.0 };
        if total(lots) < limit && self.problem.is_met(lots) {
            self.best = Some(lots.to_vec());
        }
    }

    /// Returns the mass below which ballast is lighter than what was found.
    fn limit(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| total(best) * (1.0 - SAME))
    }

    /// Exchanges pieces at up to two sites, or three of points, as long as limits are broken less, or are met and ballast becomes
    /// lighter. Exchanges are tried by the mass of all pieces if limits are met, and otherwise by how much they are broken.
    fn exchange(&mut self, start: Vec<Lot>) {
        let problem = self.problem;
        let (mut lots, mut broken) = problem.improved(start);
        let seeds = problem.seeds().into_iter();
        let free: Vec<Lot> = seeds.filter(|lot| problem.sizes[lot.site].is_empty()).collect();
        let moves = !lots.iter().all(|lot| lot.size.is_some() && problem.charts[lot.site].is_point());
        'better: loop {
            if broken == 0.0 {
                self.offer(&lots);
            }
            let limit = self.limit();
            let key = |lots: &[Lot]| {
                let sized: f64 = lots.iter().filter(|lot| lot.size.is_some()).map(|lot| lot.mass).sum();
                (sized < limit).then(|| if broken == 0.0 { sized } else { problem.broken(lots) })
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
                    let next = problem.improved([&trial[..], &free].concat());
                    if if next.1 == 0.0 { total(&next.0) < limit } else { next.1 < 0.9 * broken } {
                        (lots, broken) = next;
                        continue 'better;
                    }
                }
            }
            return;
        }
    }
}

impl Problem {
    /// Returns pieces in place of masses: the largest sizes first, and one of the least for a share of it.
    fn in_pieces(&self, lots: &[Lot], share: f64) -> Vec<Lot> {
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

    /// Returns what exchanges of a piece at each site, from one on, give: a piece or none is taken away, and another put
    /// where limits are then broken least.
    fn exchanged(&self, lots: &[Lot], from: usize) -> Vec<(usize, Vec<Lot>)> {
        let mut all = Vec::new();
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
                if let Some(size) = puts {
                    places.extend(lots.iter().filter(|lot| lot.site == site).map(|lot| lot.at));
                    let put = |at| [&lots[..], &[Lot { site, at, mass: size, size: puts }]].concat();
                    let broken = |lots: &Vec<Lot>| self.broken(lots);
                    let best = places.into_iter().map(put).min_by(|a, b| broken(a).total_cmp(&broken(b)));
                    lots = best.unwrap_or(lots);
                }
                if takes != puts && self.fits(&lots) {
                    all.push((site + usize::from(self.charts[site].is_point()), lots));
                }
            }
        }
        all
    }
}
