//! Derivatives as power series in time, for small rotations of the body. There the closed forms
//! suffer from cancellation.

use super::columns::{Columns, ToBody, dot};
use super::momentum::{MomentumFlow, PAIRS};

/// Rotation angle, rad, up to which the series is used. Its truncation error is then below 1e-15.
const SHORT: f64 = 0.1;

const ORDER: usize = 11;

/// Number of columns: three components of ω(0) and six elements of the tensor.
const COLUMNS: usize = 9;

/// Range of the power series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShortSeries {
    /// Largest |t|, in time units of the elements.
    span: f64,
}

/// One vector per column, stored component by component.
type Vectors = [[f64; COLUMNS]; 3];

impl ShortSeries {
    pub(super) fn of(flow: &MomentumFlow) -> Self {
        let inverse = flow.inverse;
        let omega = [0, 1, 2].map(|k| inverse[k] * flow.start[k]);
        // |ω|, or |i2 − i3|/i1 |ω| and its permutations for a tensor that is not a physical inertia
        let ratio = [0, 1, 2].iter().fold(1.0, |most: f64, &k| {
            let (j, l) = ((k + 1) % 3, (k + 2) % 3);
            most.max((1.0 / inverse[j] - 1.0 / inverse[l]).abs() * inverse[k])
        });
        Self { span: SHORT / (ratio * dot(&omega, &omega).sqrt()) }
    }

    pub(super) fn covers(&self, time: f64) -> bool {
        time.abs() <= self.span
    }

    /// Evaluates the series that follow from L̇ = L × ω and its variations: δL̇ = δL × ω + L × δω,
    /// θ̇ = θ × ω + δω, δω = I⁻¹ (δL − δI ω).
    #[cold]
    #[inline(never)]
    pub(super) fn at(&self, flow: &MomentumFlow, to_body: &ToBody, time: f64) -> Columns {
        let inverse = flow.inverse;
        let none = [[[0.0; COLUMNS]; 3]; ORDER + 1];
        let (mut delta_l, mut delta_omega, mut theta) = (none, none, none);
        let (mut l, mut omega) = ([[0.0; 3]; ORDER + 1], [[0.0; 3]; ORDER + 1]);
        l[0] = flow.start;
        omega[0] = [0, 1, 2].map(|k| inverse[k] * flow.start[k]);
        for k in 0..3 {
            delta_l[0][k][k] = 1.0 / inverse[k];
        }
        // order 0: δω = 0 except for the columns of ω(0)
        take_levers(&mut delta_l[0], 1.0, &omega[0]);
        for (k, row) in delta_omega[0].iter_mut().enumerate() {
            row[k] = 1.0;
        }
        for n in 1..=ORDER {
            let over = 1.0 / n as f64;
            let (mut rate, mut momentum, mut turn) = ([0.0; 3], [[0.0; COLUMNS]; 3], delta_omega[n - 1]);
            for j in 0..n {
                let (w, l, with) = (&omega[n - 1 - j], &l[j], &delta_omega[n - 1 - j]);
                let (delta, turned) = (&delta_l[j], &theta[j]);
                for (x, y, z) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                    rate[x] += l[y] * w[z] - l[z] * w[y];
                    for k in 0..COLUMNS {
                        momentum[x][k] += (delta[y][k] * w[z] - delta[z][k] * w[y])
                            + (l[y] * with[z][k] - l[z] * with[y][k]);
                        turn[x][k] += turned[y][k] * w[z] - turned[z][k] * w[y];
                    }
                }
            }
            for x in 0..3 {
                l[n][x] = over * rate[x];
                omega[n][x] = inverse[x] * l[n][x];
                for k in 0..COLUMNS {
                    delta_l[n][x][k] = over * momentum[x][k];
                    theta[n][x][k] = over * turn[x][k];
                }
            }
            let mut rest = delta_l[n];
            take_levers(&mut rest, -1.0, &omega[n]);
            for x in 0..3 {
                for k in 0..COLUMNS {
                    delta_omega[n][x][k] = inverse[x] * rest[x][k];
                }
            }
        }
        let mut columns = Columns { by_omega: [[0.0; 3]; 6], by_tensor: [[0.0; 6]; 6] };
        for (half, series) in [theta, delta_omega].iter().enumerate() {
            let sum = summed(series, time);
            for (x, axis) in to_body.axes.iter().enumerate() {
                let mut turned = [0.0; COLUMNS];
                for (component, row) in axis.iter().zip(&sum) {
                    for (turned, element) in turned.iter_mut().zip(row) {
                        *turned += component * element;
                    }
                }
                for (k, of_omega) in columns.by_omega[3 * half + x].iter_mut().enumerate() {
                    *of_omega = dot(&to_body.axes[k], &[turned[0], turned[1], turned[2]]);
                }
                columns.by_tensor[3 * half + x].copy_from_slice(&turned[3..]);
            }
        }
        columns
    }
}

fn summed(series: &[Vectors; ORDER + 1], time: f64) -> Vectors {
    let mut sum = [[0.0; COLUMNS]; 3];
    for term in series.iter().rev() {
        for (sum, term) in sum.iter_mut().zip(term) {
            for (sum, term) in sum.iter_mut().zip(term) {
                *sum = *sum * time + term;
            }
        }
    }
    sum
}

/// Adds ± δI ω for a unit change of each element of the tensor.
fn take_levers(columns: &mut Vectors, sign: f64, omega: &[f64; 3]) {
    for (p, [j, k]) in PAIRS.into_iter().enumerate() {
        columns[j][3 + p] += sign * omega[k];
        if j != k {
            columns[k][3 + p] += sign * omega[j];
        }
    }
}
