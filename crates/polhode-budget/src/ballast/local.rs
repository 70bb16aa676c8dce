//! Local search by sequential linear programming with a trust region.

use super::chart::{At, Quadratic};
use super::problem::{Lot, Problem, total};
use super::row::Row;
use super::simplex::{Inequality, Program, Solution};

/// Solution of one linear program.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) is_feasible: bool,
    pub(super) lots: Vec<Lot>,
    /// Dual variables of the rows, kg per unit of each.
    pub(super) duals: Vec<f64>,
    /// Dual variables of the largest mass of each site.
    pub(super) site_duals: Vec<f64>,
}

/// Initial radius of the trust region, relative to the sites and to the mass of the body.
const FIRST_RADIUS: f64 = 0.3;

/// Least radius of the trust region: for steps that meet the limits, and for steps that do not.
const LEAST_RADIUS: [f64; 2] = [1e-10, 1e-5];

/// Convergence threshold: relative decrease of the mass in a step.
const LIGHTER: f64 = 1e-14;

/// Largest number of cone tangents that are kept from earlier steps.
const CUTS: usize = 12;

/// Penalty of a violated limit, as a multiple of its dual variable.
const PENALTY: f64 = 4.0;

/// Largest number of steps.
const STEPS: usize = 100;

/// Distance below which lots are merged, relative to their site.
const NEAR: f64 = 1e-2;

impl Problem {
    /// Returns the lightest ballast that meets linearized conditions within a trust region.
    ///
    /// The variables are the changes of the masses and places of the lots. If the radius is
    /// infinite, places stay.
    pub(super) fn step(&self, lots: &[Lot], rows: &[Row], radius: f64) -> Step {
        let mut moves: Vec<(usize, Option<At>, [f64; 2])> = Vec::new();
        for (k, lot) in lots.iter().enumerate() {
            let mass = radius * self.mass;
            if lot.size.is_none() {
                moves.push((k, None, [-lot.mass.min(mass), mass]));
            }
            if radius.is_finite() && lot.mass > 0.0 {
                let directions = self.charts[lot.site].directions(lot.at, radius).into_iter();
                moves.extend(directions.map(|(along, range)| (k, Some(along), range)));
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
            let quadratics: Vec<Quadratic> =
                self.charts.iter().map(|chart| chart.quadratic(&row.of)).collect();
            let [value, noise] = self.value(row, lots);
            let inside = if row.is_zero { 0.0 } else { noise };
            add((value - inside) / row.scale, row.is_zero, &|lot, along| {
                let (quadratic, [s, t]) = (&quadratics[lot.site], quadratics[lot.site].gradient(lot.at));
                along.map_or_else(|| quadratic.value(lot.at), |[a, b]| lot.mass * (a * s + b * t)) / row.scale
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
        let Solution { is_feasible, x, mut duals } = program.solve();
        let mut changed = lots.to_vec();
        for ((k, along, [low, _]), x) in moves.iter().zip(&x) {
            let lot = &mut changed[*k];
            match along {
                None => lot.mass = (lot.mass + (low + x)).max(0.0),
                Some([a, b]) => lot.at = [lot.at[0] + a * (low + x), lot.at[1] + b * (low + x)],
            }
        }
        changed.iter_mut().for_each(|lot| lot.at = self.charts[lot.site].nearest(lot.at));
        let mut site_duals = vec![0.0; self.most.len()];
        for (site, dual) in limited.iter().zip(duals.split_off(rows.len())) {
            site_duals[*site] = dual / self.most[*site];
        }
        duals.iter_mut().zip(rows).for_each(|(dual, row)| *dual /= row.scale);
        Step { is_feasible, lots: changed, duals, site_duals }
    }

    /// Returns a local minimum of the mass and the violation of the limits, with the violation.
    pub(super) fn local_minimum(&self, mut lots: Vec<Lot>) -> (Vec<Lot>, f64) {
        let (mut now, mut radius, mut weight) = (self.violation(&lots), FIRST_RADIUS, 0.0_f64);
        let mut cuts: Vec<Row> = Vec::new();
        let has_masses = lots.iter().any(|lot| lot.size.is_none());
        let moves = has_masses || lots.iter().any(|lot| !self.charts[lot.site].is_point());
        for _ in 0..if moves { STEPS } else { 0 } {
            if now == 0.0 && !has_masses {
                break;
            }
            let rows = [&self.tangents(&lots)[..], &cuts].concat();
            let step = self.step(&lots, &rows, radius);
            cuts.extend(self.cuts(&step.lots));
            cuts.drain(..cuts.len().saturating_sub(CUTS));
            let duals = rows.iter().zip(&step.duals).map(|(row, dual)| dual.abs() * row.scale);
            weight = duals.fold(total(&lots).max(weight / PENALTY), f64::max) * PENALTY;
            let merit = |lots: &[Lot], violation: f64| {
                if step.is_feasible { total(lots) / weight + violation } else { violation }
            };
            let next = self.violation(&step.lots);
            let is_better = merit(&step.lots, next) < merit(&lots, now);
            let is_least =
                now == 0.0 && step.is_feasible && total(&step.lots) >= total(&lots) * (1.0 - LIGHTER);
            if is_better {
                (lots, now) = (step.lots, next);
            }
            radius *= if is_better { 2.0 } else { 0.25 };
            if is_least || radius < LEAST_RADIUS[usize::from(!step.is_feasible)] {
                break;
            }
        }
        lots.retain(|lot| lot.mass > 0.0);
        (lots, now)
    }

    /// Returns the lots with near ones merged at their centre of mass, and without negligible ones.
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
