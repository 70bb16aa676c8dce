//! The derivatives as power series of the time: before the body has turned by much, the closed forms cancel.

use core::array::from_fn;

use super::columns::{Columns, dot};
use super::inertia::PAIRS;
use super::momentum::{MomentumFlow, cross};

/// Up to this angle, rad, the series is used; it then leaves out what is below 1e-16.
const SHORT: f64 = 0.05;

const ORDER: usize = 9;

/// A column for each component of ω(0) and each element of the tensor.
const COLUMNS: usize = 9;

/// The rates of a motion in its labelled axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShortSeries {
    /// How long it is used, units of the elements.
    span: f64,
}

/// The coefficients of a power series in time.
type Series<T> = [T; ORDER + 1];

impl ShortSeries {
    pub(super) fn of(flow: &MomentumFlow) -> Self {
        let inverse = flow.inverse;
        let omega = [0, 1, 2].map(|k| inverse[k] * flow.start[k]);
        // |ω|, or |i2 − i3|/i1 |ω| and the like of a tensor that is no body's
        let ratio = [0, 1, 2].iter().fold(1.0, |most: f64, &k| {
            let (j, l) = ((k + 1) % 3, (k + 2) % 3);
            most.max((1.0 / inverse[j] - 1.0 / inverse[l]).abs() * inverse[k])
        });
        Self { span: SHORT / (ratio * dot(&omega, &omega).sqrt()) }
    }

    pub(super) fn covers(&self, time: f64) -> bool {
        time.abs() <= self.span
    }

    /// L̇ = L × ω, and its derivatives: δL̇ = δL × ω + L × δω, θ̇ = θ × ω + δω, δω = I⁻¹ (δL − δI ω).
    pub(super) fn at(flow: &MomentumFlow, time: f64) -> Columns {
        let inverse = flow.inverse;
        let zero = [0.0; 3];
        let (mut l, mut omega): (Series<[f64; 3]>, Series<[f64; 3]>) = ([zero; ORDER + 1], [zero; ORDER + 1]);
        let mut delta_l: Series<[[f64; 3]; COLUMNS]> = [[zero; COLUMNS]; ORDER + 1];
        let (mut delta_omega, mut theta) = (delta_l, delta_l);
        l[0] = flow.start;
        omega[0] = scaled(&inverse, &l[0]);
        for k in 0..3 {
            delta_l[0][k][k] = 1.0 / inverse[k];
        }
        for (p, pair) in PAIRS.iter().enumerate() {
            delta_l[0][3 + p] = applied(*pair, &omega[0]);
        }
        for n in 0..=ORDER {
            if n > 0 {
                let over = 1.0 / n as f64;
                // Σ aⱼ × bₙ₋₁₋ⱼ
                let sum = |term: &dyn Fn(usize, usize) -> [f64; 3]| {
                    (0..n).fold(zero, |sum, j| added(&sum, 1.0, &term(j, n - 1 - j)))
                };
                let rate = sum(&|j, k| cross(&l[j], &omega[k]));
                let rates: [[[f64; 3]; 2]; COLUMNS] = from_fn(|column| {
                    let momentum = sum(&|j, k| {
                        added(&cross(&delta_l[j][column], &omega[k]), 1.0, &cross(&l[j], &delta_omega[k][column]))
                    });
                    let turned = sum(&|j, k| cross(&theta[j][column], &omega[k]));
                    [momentum, added(&turned, 1.0, &delta_omega[n - 1][column])]
                });
                l[n] = rate.map(|x| over * x);
                omega[n] = scaled(&inverse, &l[n]);
                for (column, [momentum, turn]) in rates.into_iter().enumerate() {
                    delta_l[n][column] = momentum.map(|x| over * x);
                    theta[n][column] = turn.map(|x| over * x);
                }
            }
            for column in 0..COLUMNS {
                let mut momentum = delta_l[n][column];
                if column >= 3 {
                    momentum = added(&momentum, -1.0, &applied(PAIRS[column - 3], &omega[n]));
                }
                delta_omega[n][column] = scaled(&inverse, &momentum);
            }
        }
        let (turn, omega) = (summed(&theta, time), summed(&delta_omega, time));
        let by_omega = |of: &[[f64; 3]; COLUMNS]| [0, 1, 2].map(|i| [0, 1, 2].map(|k| of[k][i]));
        let by_inertia =
            |of: &[[f64; 3]; COLUMNS]| [0, 1, 2].map(|i| [0, 1, 2, 3, 4, 5].map(|p| of[3 + p][i]));
        Columns {
            turn_by_omega: by_omega(&turn),
            omega_by_omega: by_omega(&omega),
            turn_by_inertia: by_inertia(&turn),
            omega_by_inertia: by_inertia(&omega),
        }
    }
}

fn summed(series: &Series<[[f64; 3]; COLUMNS]>, time: f64) -> [[f64; 3]; COLUMNS] {
    let mut sum = [[0.0; 3]; COLUMNS];
    for term in series.iter().rev() {
        for (sum, term) in sum.iter_mut().zip(term) {
            for (sum, term) in sum.iter_mut().zip(term) {
                *sum = *sum * time + term;
            }
        }
    }
    sum
}

/// δI v of a unit change of one element.
fn applied([j, k]: [usize; 2], v: &[f64; 3]) -> [f64; 3] {
    let mut image = [0.0; 3];
    image[j] = v[k];
    image[k] = v[j];
    image
}

fn scaled(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// a + x b
fn added(a: &[f64; 3], x: f64, b: &[f64; 3]) -> [f64; 3] {
    [a[0] + x * b[0], a[1] + x * b[1], a[2] + x * b[2]]
}
