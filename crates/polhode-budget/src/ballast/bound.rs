//! The least ballast of any masses, and a lower bound.
//!
//! Every limit is a condition f = β + Σ m a(r) ≥ 0 (or = 0) on lots of the mass m at r: as it is, if it is linear; each
//! tangent of a cone; and the tangent of a product with what it leaves out. Take any prices y of the conditions, not
//! negative where f ≥ 0. Then each ballast that meets all limits has
//!
//! ```text
//! Σ m ≥ Σ m − y·f = −y·β + Σ m d(r),  d(r) = 1 − y·a(r)
//! ```
//!
//! d is quadratic in r, and its least value on each site is known in closed form. Of a site that takes up to Mₖ, any price πₖ
//! that is not negative gives mₖ dₖ ≥ mₖ (dₖ + πₖ) − πₖ Mₖ. All ballast together is no more than a mass M, as heavier is not
//! looked for. So
//!
//! ```text
//! Σ m ≥ −y·β − Σ πₖ Mₖ + M min(0, d₁ + π₁, d₂ + π₂, …)
//! ```
//!
//! is a lower bound for any prices; those of the last linear program make it tight. Without the first Σ m the left side is
//! 0, and if the right side is positive, there is no ballast up to M.
//!
//! A product about the centre of mass c is P = ∫ (u·r − a) (v·r − b) dm − M′ (u·c − a) (v·c − b) for any a and b, with M′ the
//! mass of body and ballast. With ballast up to M, u·c and v·c are between the values that they have with all of it at the
//! farthest points of the sites. With a and b the two lower or the two upper of these, the last term is positive, and
//! P is no greater than the integral; with a lower and an upper one, no less (McCormick, Math. Program. 10, 1976, 147).

use super::problem::{Lot, Problem, total};
use super::row::{Functional, Row};

/// Places are added until none would make ballast lighter by more than this part of its mass.
const PRICE: f64 = 1e-11;

/// Ballast is the same if it is lighter by less than this part: with linear conditions, and with products.
const SAME: [f64; 2] = [1e-12, 1e-6];

/// A bound is rounded by less than this part of its terms.
const ROUNDING: f64 = 1e-9;

/// The most rounds.
const ROUNDS: usize = 60;

impl Problem {
    /// Returns the least ballast of any masses near some, with places added where prices say that it becomes lighter; and a lower
    /// bound on all, infinite if there is none, which holds unless products are limited.
    pub(super) fn solved(&self, near: &[Lot]) -> (Vec<Lot>, f64) {
        let mut pool = self.seeds();
        let mut lots: Vec<Lot> = near.iter().map(|lot| Lot { size: None, ..*lot }).collect();
        let (mut cuts, mut last, mut bound): (Vec<Row>, f64, f64) = (Vec::new(), -1.0, 0.0);
        let has_products = self.has_products();
        for _ in 0..ROUNDS {
            // The tangents of products are not limits: a local search comes first.
            if has_products {
                lots = self.improved([self.merged(&lots), pool.clone()].concat()).0;
            }
            lots.extend(&pool);
            let rows = [self.tangents(&lots), cuts.clone()].concat();
            let step = self.step(&lots, &rows, f64::INFINITY);
            let start = if step.is_feasible { Functional::MASS } else { Functional::ZERO };
            let price =
                rows.iter().zip(&step.prices).fold(start, |sum, (row, price)| sum.plus(-price, &row.of));
            let tolerance = if step.is_feasible { PRICE } else { 1e-6 * price.constant.abs() / self.cap };
            let (before, mut worst) = (pool.len() + cuts.len(), 0.0_f64);
            for (site, chart) in self.charts.iter().enumerate().filter(|(site, _)| self.most[*site] > 0.0) {
                let (at, least) = chart.least(&price);
                let least = least + step.of_sites[site];
                worst = worst.min(least);
                if least < -tolerance && !chart.is_point() {
                    pool.push(Lot { site, at, mass: 0.0, size: None });
                }
            }
            let of_sites = step.of_sites.iter().zip(&self.most).filter(|(price, _)| **price > 0.0);
            let own =
                price.constant - of_sites.map(|(price, most)| price * most).sum::<f64>() + self.cap * worst;
            let is_none =
                own > if step.is_feasible { self.cap * (1.0 + ROUNDING) } else { ROUNDING * price.size };
            bound = match (is_none, step.is_feasible) {
                (true, _) => f64::INFINITY,
                (false, true) => bound.max(own),
                (false, false) => bound,
            };
            let new = self.cuts(&step.lots).into_iter();
            cuts.extend(new.filter(|row| self.value(row, &step.lots)[0] < -PRICE * row.scale));
            lots = if has_products { lots } else { step.lots };
            lots.retain(|lot| lot.mass > 0.0);
            // Where products are limited, places are added only as long as that helps.
            let is_complete = pool.len() + cuts.len() == before || has_products;
            if is_complete && (total(&lots) - last).abs() <= SAME[usize::from(has_products)] * last {
                break;
            }
            last = total(&lots);
        }
        (lots, bound)
    }

    /// Returns the least multiple of a common unit of all sizes that is not below a bound, if all sites have sizes.
    pub(super) fn attainable(&self, bound: f64) -> f64 {
        let sizes = || self.sizes.iter().flatten();
        let most = sizes().copied().fold(0.0, f64::max);
        // Euclid's algorithm; a remainder below rounding is none.
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
        // The error of more multiples is not small beside one.
        let count = bound / unit;
        if has_unit && count < 1e6 { (count * (1.0 - 1e-9)).ceil() * unit } else { bound }
    }
}
