//! Comparison of first-order errors with random draws.

use polhode::body::MassProperties;
use polhode::math::Frame;

use crate::draws::Draws;
use crate::estimate::{Estimate, NUMBERS};
use polhode::math::Body;

/// Errors of the ten numbers and the principal moments, to first order and from draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Numbers in the order of [`NUMBERS`], then i1, i2, i3.
    pub numbers: Vec<ComparedNumber>,
    /// Covariance of the ten numbers over the draws.
    pub covariance: [[f64; 10]; 10],
    /// Number of draws.
    pub draws: usize,
    /// Number of draws in which some part had to be moved to be possible.
    pub moved: usize,
}

/// Number with its errors to first order and from draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedNumber {
    pub name: &'static str,
    pub unit: &'static str,
    /// Value for the list as given.
    pub value: f64,
    /// Standard deviation to first order.
    pub first_order_sd: f64,
    /// Mean of the draws.
    pub mean: f64,
    /// Standard error of the mean.
    pub mean_error: f64,
    /// Standard deviation of the draws.
    pub sd: f64,
    /// Standard error of `sd`, from the fourth moment of the draws.
    pub sd_error: f64,
}

/// Significance threshold, in standard errors. By chance, a difference exceeds it about once in
/// 16,000 times.
const SIGNIFICANT: f64 = 4.0;
/// Rounding error of the draws, relative to the mass, the distance of the centre or the greatest
/// moment. Smaller standard deviations count as 0.
const ROUNDING: f64 = 1e-13;

impl ComparedNumber {
    /// Returns the mean of the draws minus the value for the list as given.
    pub fn bias(&self) -> f64 {
        self.mean - self.value
    }

    /// Returns true if the mean or the standard deviation of the draws differs significantly from
    /// first order. The difference must exceed four standard errors plus rounding.
    pub fn differs(&self) -> bool {
        let rounding = ROUNDING * self.value.abs();
        let beyond = |difference: f64, error: f64| difference.abs() > SIGNIFICANT * error + rounding;
        beyond(self.bias(), self.mean_error) || beyond(self.sd - self.first_order_sd, self.sd_error)
    }
}

impl Draws {
    /// Compares the draws with the first-order estimate of the same list and basis.
    pub fn compare(&self, estimate: &Estimate<Body>) -> Comparison {
        let count = self.bodies.len() as f64;
        let value = numbers(&estimate.properties);
        // Differences from the value itself, so that small errors of large numbers keep their
        // digits.
        let differences: Vec<[f64; 13]> = self
            .bodies
            .iter()
            .map(|body| {
                let drawn = numbers(body);
                core::array::from_fn(|k| drawn[k] - value[k])
            })
            .collect();
        let average = |of: &dyn Fn(&[f64; 13]) -> f64| differences.iter().map(of).sum::<f64>() / count;
        let bias: [f64; 13] = core::array::from_fn(|k| average(&|d| d[k]));
        let unbiased = count / (count - 1.0);
        let covariance = core::array::from_fn(|i| {
            core::array::from_fn(|j| unbiased * average(&|d| (d[i] - bias[i]) * (d[j] - bias[j])))
        });
        let moments = estimate.principal().moment_covariance;
        let [_, x, y, z, _, _, _, _, _, _, _, _, greatest] = value;
        let length = x.abs().max(y.abs()).max(z.abs());
        let scale = |k: usize| [value[0].abs(), length, greatest][usize::from(k > 0) + usize::from(k > 3)];
        let beyond_rounding = |k: usize, sd: f64| if sd > ROUNDING * scale(k) { sd } else { 0.0 };
        let compared = (0..13).map(|k| {
            let (name, unit) = NUMBERS.get(k).copied().unwrap_or(MOMENTS[k.saturating_sub(10)]);
            let power = |n: i32| average(&|d| (d[k] - bias[k]).powi(n));
            let (second, fourth) = (power(2), power(4));
            let sd = beyond_rounding(k, (unbiased * second).sqrt());
            let bias = if sd > 0.0 { bias[k] } else { 0.0 };
            ComparedNumber {
                name,
                unit,
                value: value[k],
                first_order_sd: if k < 10 { estimate.sd(k) } else { moments[k - 10][k - 10].max(0.0).sqrt() },
                mean: value[k] + bias,
                mean_error: sd / count.sqrt(),
                sd,
                // var(s²) = (μ₄ − μ₂²)/n, and s² = 2 s δs
                sd_error: if sd > 0.0 {
                    ((fourth - second * second).max(0.0) / count).sqrt() / (2.0 * sd)
                } else {
                    0.0
                },
            }
        });
        Comparison { numbers: compared.collect(), covariance, draws: self.bodies.len(), moved: self.moved }
    }
}

const MOMENTS: [(&str, &str); 3] = [("i1", "kg·m²"), ("i2", "kg·m²"), ("i3", "kg·m²")];

/// Returns the ten numbers and the three principal moments.
fn numbers<F: Frame>(body: &MassProperties<F>) -> [f64; 13] {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    let [i1, i2, i3] = body.principal().moments();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz, i1, i2, i3]
}
