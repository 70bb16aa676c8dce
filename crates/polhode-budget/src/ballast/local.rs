//! Local search by sequential linear programming.

use super::chart::{At, Planar};
use super::problem::{Lot, Problem, total};
use super::row::Row;
use super::simplex::{Inequality, Program, Solution};

/// The solution of one program.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) is_feasible: bool,
    pub(super) lots: Vec<Lot>,
    /// Prices of the rows, kg per unit of each.
    pub(super) prices: Vec<f64>,
    /// Prices of the most mass of each site.
    pub(super) of_sites: Vec<f64>,
}

/// How far the first step goes, as a part of the sites and of the mass of the body.
const REACH: f64 = 0.3;

/// The search ends where steps shorter than this make nothing better; where no step meets the limits, than the other.
const SHORTEST: [f64; 2] = [1e-10, 1e-5];

/// The search ends where a step is lighter by less than this part.
const LIGHTER: f64 = 1e-14;

/// The most tangents of cones that are kept besides those where ballast is.
const CUTS: usize = 12;

/// A broken limit costs this many times its price.
const PENALTY: f64 = 4.0;

/// The most steps.
const STEPS: usize = 100;

/// Lots of any mass that are nearer than this part of their site become one.
const NEAR: f64 = 1e-2;

impl Problem {
    /// Returns the lightest ballast that meets rows, linear in the masses and places of lots, which change by no more than a
    /// reach. If that is infinite, places stay.
    pub(super) fn step(&self, lots: &[Lot], rows: &[Row], reach: f64) -> Step {
        let mut moves: Vec<(usize, Option<At>, [f64; 2])> = Vec::new();
        for (k, lot) in lots.iter().enumerate() {
            let mass = reach * self.mass;
            if lot.size.is_none() {
                moves.push((k, None, [-lot.mass.min(mass), mass]));
            }
            if reach.is_finite() && lot.mass > 0.0 {
                let freedoms = self.charts[lot.site].freedoms(lot.at, reach).into_iter();
                moves.extend(freedoms.map(|(along, range)| (k, Some(along), range)));
            }
        }
        let mut program = Program {
            cost: moves.iter().map(|(_, along, _)| if along.is_none() { 1.0 } else { 0.0 }).collect(),
            upper: moves.iter().map(|(.., [low, high])| high - low).collect(),
            rows: Vec::new(),
        };
        let mut add = |value: f64, is_zero: bool, by: &dyn Fn(&Lot, Option<At>) -> f64| {
            let by: Vec<f64> = moves.iter().map(|(k, along, _)| by(&lots[*k], *along)).collect();
            let from_low: f64 = by.iter().zip(&moves).map(|(by, (.., [low, _]))| by * low).sum();
            program.rows.push(Inequality { by, constant: value + from_low, is_zero });
        };
        for row in rows {
            let planars: Vec<Planar> = self.charts.iter().map(|chart| chart.planar(&row.of)).collect();
            let [value, noise] = self.value(row, lots);
            let inside = if row.is_zero { 0.0 } else { noise };
            add((value - inside) / row.scale, row.is_zero, &|lot, along| {
                let (planar, [s, t]) = (&planars[lot.site], planars[lot.site].gradient(lot.at));
                along.map_or_else(|| planar.value(lot.at), |[a, b]| lot.mass * (a * s + b * t)) / row.scale
            });
        }
        let is_limited = |site: &usize| self.most[*site] > 0.0 && self.most[*site].is_finite();
        let limited: Vec<usize> = (0..self.most.len()).filter(is_limited).collect();
        for site in &limited {
            let own = lots.iter().filter(|lot| lot.site == *site).map(|lot| lot.mass).sum::<f64>();
            add(1.0 - own / self.most[*site], false, &|lot, along| {
                if lot.site == *site && along.is_none() { -self.most[*site].recip() } else { 0.0 }
            });
        }
        let Solution { is_feasible, x, mut prices } = program.solve();
        let mut changed = lots.to_vec();
        for ((k, along, [low, _]), x) in moves.iter().zip(&x) {
            let lot = &mut changed[*k];
            match along {
                None => lot.mass = (lot.mass + (low + x)).max(0.0),
                Some([a, b]) => lot.at = [lot.at[0] + a * (low + x), lot.at[1] + b * (low + x)],
            }
        }
        changed.iter_mut().for_each(|lot| lot.at = self.charts[lot.site].nearest(lot.at));
        let mut of_sites = vec![0.0; self.most.len()];
        for (site, price) in limited.iter().zip(prices.split_off(rows.len())) {
            of_sites[*site] = price / self.most[*site];
        }
        prices.iter_mut().zip(rows).for_each(|(price, row)| *price /= row.scale);
        Step { is_feasible, lots: changed, prices, of_sites }
    }

    /// Returns ballast near some that breaks limits less or is lighter, and by how much it breaks them.
    pub(super) fn improved(&self, mut lots: Vec<Lot>) -> (Vec<Lot>, f64) {
        let (mut now, mut reach, mut weight) = (self.broken(&lots), REACH, 0.0_f64);
        let mut cuts: Vec<Row> = Vec::new();
        let has_masses = lots.iter().any(|lot| lot.size.is_none());
        let moves = has_masses || lots.iter().any(|lot| !self.charts[lot.site].is_point());
        for _ in 0..if moves { STEPS } else { 0 } {
            if now == 0.0 && !has_masses {
                break;
            }
            let rows = [&self.tangents(&lots)[..], &cuts].concat();
            let step = self.step(&lots, &rows, reach);
            cuts.extend(self.cuts(&step.lots));
            cuts.drain(..cuts.len().saturating_sub(CUTS));
            let prices = rows.iter().zip(&step.prices).map(|(row, price)| price.abs() * row.scale);
            weight = prices.fold(total(&lots).max(weight / PENALTY), f64::max) * PENALTY;
            let merit = |lots: &[Lot], broken: f64| {
                if step.is_feasible { total(lots) / weight + broken } else { broken }
            };
            let next = self.broken(&step.lots);
            let is_better = merit(&step.lots, next) < merit(&lots, now);
            let is_least =
                now == 0.0 && step.is_feasible && total(&step.lots) >= total(&lots) * (1.0 - LIGHTER);
            if is_better {
                (lots, now) = (step.lots, next);
            }
            reach *= if is_better { 2.0 } else { 0.25 };
            if is_least || reach < SHORTEST[usize::from(!step.is_feasible)] {
                break;
            }
        }
        lots.retain(|lot| lot.mass > 0.0);
        (lots, now)
    }

    /// Returns the lots with those that are near each other as one at their centre of mass, without the least.
    pub(super) fn merged(&self, lots: &[Lot]) -> Vec<Lot> {
        let mut merged: Vec<Lot> = Vec::with_capacity(lots.len());
        let least = 1e-6 * total(lots);
        for lot in lots.iter().filter(|lot| lot.mass > least) {
            let is_near = |other: &&mut Lot| {
                let far = (other.at[0] - lot.at[0]).hypot(other.at[1] - lot.at[1]);
                other.site == lot.site && far < NEAR
            };
            match merged.iter_mut().find(is_near) {
                None => merged.push(*lot),
                Some(other) => {
                    let share = lot.mass / (other.mass + lot.mass);
                    let at = core::array::from_fn(|k| other.at[k] + share * (lot.at[k] - other.at[k]));
                    *other =
                        Lot { at: self.charts[lot.site].nearest(at), mass: other.mass + lot.mass, ..*lot };
                }
            }
        }
        merged
    }
}
