//! First order beside draws.

use polhode::body::MassProperties;
use polhode::math::Frame;

use crate::draws::Draws;
use crate::estimate::{Estimate, NUMBERS};
use polhode::math::Body;

/// What first order says of the ten numbers and of the principal moments, and what draws do.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// In the order of [`NUMBERS`], then i1, i2, i3.
    pub numbers: Vec<ComparedNumber>,
    /// Covariance of the ten numbers, of the draws.
    pub covariance: [[f64; 10]; 10],
    /// How many draws there are.
    pub draws: usize,
    /// Of how many some part had to be moved to be possible.
    pub moved: usize,
}

/// A number by first order and by draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedNumber {
    /// What it is.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Of the list as it is given.
    pub value: f64,
    /// Standard deviation to first order.
    pub first_order_sd: f64,
    /// Mean of the draws.
    pub mean: f64,
    /// Its standard error.
    pub mean_error: f64,
    /// Standard deviation of the draws.
    pub sd: f64,
    /// Its standard error, by the draws' fourth moment.
    pub sd_error: f64,
}

/// Standard errors by which draws differ from first order by chance once in some 16,000 times.
const SIGNIFICANT: f64 = 4.0;
/// A standard deviation below this part of the mass, the centre's distance or the greatest moment is rounding of the draws.
const ROUNDING: f64 = 1e-13;

impl ComparedNumber {
    /// By how much the mean of the draws is beside the number.
    pub fn bias(&self) -> f64 {
        self.mean - self.value
    }

    /// Whether the draws' mean or standard deviation is beside first order by more than chance makes it: by four standard errors, and by more than rounding.
    pub fn differs(&self) -> bool {
        let rounding = ROUNDING * self.value.abs();
        let beyond = |difference: f64, error: f64| difference.abs() > SIGNIFICANT * error + rounding;
        beyond(self.bias(), self.mean_error) || beyond(self.sd - self.first_order_sd, self.sd_error)
    }
}

impl Draws {
    /// How the draws differ from what first order says of the same list and basis.
    pub fn compare(&self, estimate: &Estimate<Body>) -> Comparison {
        let count = self.bodies.len() as f64;
        let value = numbers(&estimate.properties);
        // Differences from the number itself, so that small errors of large numbers keep their digits.
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

/// The ten numbers and the principal moments.
fn numbers<F: Frame>(body: &MassProperties<F>) -> [f64; 13] {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    let [i1, i2, i3] = body.principal().moments();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz, i1, i2, i3]
}
