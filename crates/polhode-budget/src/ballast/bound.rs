//! Least ballast of any masses by column generation, and a lower bound from duality.
//!
//! Every limit is a condition f = β + Σ m a(r) ≥ 0 (or = 0) on lots of mass m at r. A linear limit
//! is such a condition. A cone is replaced by its tangents. A product about the centre of mass is
//! replaced by the two sides of its McCormick envelope. Let y be any dual variables of the
//! conditions, not negative where f ≥ 0. All ballast that meets the limits satisfies
//!
//! ```text
//! Σ m ≥ Σ m − y·f = −y·β + Σ m d(r),  d(r) = 1 − y·a(r)
//! ```
//!
//! The reduced cost d is quadratic in r, so its minimum on each site is known in closed form. If
//! site k takes at most Mₖ, any dual variable πₖ ≥ 0 gives mₖ dₖ ≥ mₖ (dₖ + πₖ) − πₖ Mₖ. The total
//! ballast is at most M, because heavier ballast is not of interest. Therefore
//!
//! ```text
//! Σ m ≥ −y·β − Σ πₖ Mₖ + M min(0, d₁ + π₁, d₂ + π₂, …)
//! ```
//!
//! is a lower bound for any y and π. The duals of the last linear program make it tight. With 0 in
//! place of the first Σ m, the left side is 0; if the right side is positive, no ballast up to M
//! meets the limits.
//!
//! A product about the centre of mass c is P = ∫ (u·r − a) (v·r − b) dm − M′ (u·c − a) (v·c − b)
//! for any a and b. M′ is the mass of body and ballast. With ballast of at most M, u·c and v·c are
//! between the values that they have if all ballast is at the farthest points of the sites. If a
//! and b are both lower ends or both upper ends of these ranges, the last term is not positive, and
//! P is at most the integral. If one is a lower end and one an upper end, P is at least the
//! integral (McCormick, Math. Program. 10, 1976, 147).

use super::problem::{Lot, Problem, total};
use super::row::{Functional, Moments, Row, weights};

/// Threshold of the reduced cost. Columns are added while one has a reduced cost below minus this.
const REDUCED_COST: f64 = 1e-11;

/// Relative change of the mass at which column generation ends: without products, and with
/// products.
const SAME: [f64; 2] = [1e-12, 1e-6];

/// Threshold for inconsistent limits: violation of their sum, relative to its terms.
const INCONSISTENT: f64 = 1e-9;

/// Relative rounding error of the terms of the bound.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Largest number of rounds of column generation.
const ROUNDS: usize = 60;

impl Problem {
    /// Returns light ballast of any masses, and a lower bound on all ballast.
    ///
    /// The search starts from `near` and from fixed points of the sites. The bound is infinite if
    /// no ballast up to the cap meets the limits. The bound does not hold if products are limited.
    pub(super) fn relaxed(&self, near: &[Lot]) -> (Vec<Lot>, f64) {
        let mut pool = self.seeds();
        let mut lots: Vec<Lot> = near.iter().map(|lot| Lot { size: None, ..*lot }).collect();
        let (mut cuts, mut last, mut bound): (Vec<Row>, f64, f64) = (Vec::new(), -1.0, 0.0);
        let has_products = self.has_products();
        for _ in 0..ROUNDS {
            // Tangents of products hold only near their ballast, so a local search comes first.
            if has_products {
                lots = self.local_minimum([self.merged(&lots), pool.clone()].concat()).0;
            }
            lots.extend(&pool);
            let rows = [self.tangents(&lots), cuts.clone()].concat();
            let step = self.step(&lots, &rows, f64::INFINITY);
            // d(r) and −y·β
            let cost = if step.is_feasible { Functional::MASS } else { Functional::ZERO };
            let reduced = rows.iter().zip(&step.duals).fold(cost, |sum, (row, y)| sum.plus(-y, &row.of));
            let tolerance =
                if step.is_feasible { REDUCED_COST } else { 1e-6 * reduced.constant.abs() / self.cap };
            let (before, mut least) = (pool.len() + cuts.len(), 0.0_f64);
            for (site, chart) in self.charts.iter().enumerate().filter(|(site, _)| self.most[*site] > 0.0) {
                let (at, value) = chart.least(&reduced);
                let value = value + step.site_duals[site];
                least = least.min(value);
                if value < -tolerance && !chart.is_point() {
                    pool.push(Lot { site, at, mass: 0.0, size: None });
                }
            }
            let of_sites = step.site_duals.iter().zip(&self.most).filter(|(dual, _)| **dual > 0.0);
            let of_sites: f64 = of_sites.map(|(dual, most)| dual * most).sum();
            // −y·β − Σ πₖ Mₖ + M min(0, d₁ + π₁, …)
            let value =
                reduced.constant - of_sites + self.cap * least - self.rounding(&cost, &rows, &step.duals);
            let (most, slack) =
                if step.is_feasible { (self.cap, self.cap) } else { (0.0, reduced.size + of_sites) };
            if value > most + INCONSISTENT * slack {
                bound = f64::INFINITY;
            } else if step.is_feasible {
                bound = bound.max(value);
            }
            let new = self.cuts(&step.lots).into_iter();
            cuts.extend(new.filter(|row| self.value(row, &step.lots)[0] < -REDUCED_COST * row.scale));
            lots = if has_products { lots } else { step.lots };
            lots.retain(|lot| lot.mass > 0.0);
            // With products, columns are added only as long as the mass changes.
            let is_complete = pool.len() + cuts.len() == before || has_products;
            if is_complete && (total(&lots) - last).abs() <= SAME[usize::from(has_products)] * last {
                break;
            }
            last = total(&lots);
        }
        (lots, bound)
    }

    /// Returns an upper bound on the rounding error of the bound, from the sum of all its terms.
    fn rounding(&self, cost: &Functional, rows: &[Row], duals: &[f64]) -> f64 {
        let farthest: Vec<_> = self.charts.iter().map(|chart| weights(chart.extent())).collect();
        let terms = |of: &Functional| {
            let at = |w: &Moments| of.by.iter().zip(w).map(|(a, w)| (a * w).abs()).sum::<f64>();
            of.size.max(of.constant.abs()) + self.cap * farthest.iter().map(at).fold(0.0, f64::max)
        };
        let of_rows = rows.iter().zip(duals).map(|(row, y)| y.abs() * terms(&row.of));
        ROUNDING * (terms(cost) + of_rows.sum::<f64>())
    }

    /// Returns a bound rounded up to a multiple of the common unit of all sizes.
    ///
    /// The bound itself is returned if a site takes any mass, or the sizes have no common unit.
    pub(super) fn attainable(&self, bound: f64) -> f64 {
        let sizes = || self.sizes.iter().flatten();
        let most = sizes().copied().fold(0.0, f64::max);
        // Euclid's algorithm; a remainder of the order of rounding counts as 0.
        let unit = sizes().fold(0.0, |unit: f64, size| {
            let (mut a, mut b) = (*size, unit);
            while b > 1e-9 * most {
                (a, b) = (b, (a - (a / b).round() * b).abs());
            }
            a
        });
        let is_multiple = |size: &f64| (size / unit - (size / unit).round()).abs() < 1e-9;
        let is_sized = |(sizes, most): (&Vec<f64>, &f64)| !sizes.is_empty() || *most == 0.0;
        let has_unit = self.sizes.iter().zip(&self.most).all(is_sized) && sizes().all(is_multiple);
        // With more multiples, the rounding error is no longer small compared with one unit.
        let count = bound / unit;
        if has_unit && count < 1e6 { (count * (1.0 - 1e-9)).ceil() * unit } else { bound }
    }
}
