//! The derivatives along the labelled axes, and in the body.

use crate::motion::solve::free::labelled::Labelled;

use super::functions::TimeFunctions;
use super::inertia::{Integral, PAIRS};
use super::momentum::{MomentumFlow, cross};

/// Rows θ and ω, columns ω(0) and the elements 11, 22, 33, 12, 13, 23 of the tensor, along the labelled axes, in units of the elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub(super) turn_by_omega: [[f64; 3]; 3],
    pub(super) omega_by_omega: [[f64; 3]; 3],
    pub(super) turn_by_inertia: [[f64; 6]; 3],
    pub(super) omega_by_inertia: [[f64; 6]; 3],
}

impl Columns {
    /// At L = `l`, from ∂L(t)/∂L(0) and the attitude at the start, seen from that at t, B.
    ///
    /// L is constant in space: θ × L = B δL(0) − δL(t) for θ(0) = 0, and L·θ = t ω·δL(0) + ∫ δH dt, δH = −½ ω·δI ω:
    ///
    /// L² θ = L (L·θ) + L × (B δL(0) − δL(t)),  δω = I⁻¹ (δL − δI ω)
    ///
    /// A change of the tensor is one of the start by L(0) × ∇∫ δH dt, besides δL(0) = δI ω(0).
    pub(super) fn of(flow: &MomentumFlow, l: &[f64; 3], back: &[[f64; 3]; 3], f: &TimeFunctions) -> Self {
        let by_start = flow.derivative(l, f);
        let integrals = flow.integrals(l, &by_start, f);
        let inverse = flow.inverse;
        let (before, omega) = (hadamard(&inverse, &flow.start), hadamard(&inverse, l));
        let over = 1.0 / flow.squares[2];
        let along = l.map(|l| l * over);
        // B − ∂L(t)/∂L(0)
        let lag: [[f64; 3]; 3] = [0, 1, 2].map(|i| [0, 1, 2].map(|j| back[i][j] - by_start[i][j]));
        let mut columns = Self {
            turn_by_omega: [[0.0; 3]; 3],
            omega_by_omega: [[0.0; 3]; 3],
            turn_by_inertia: [[0.0; 6]; 3],
            omega_by_inertia: [[0.0; 6]; 3],
        };
        for k in 0..3 {
            let moment = 1.0 / inverse[k];
            let across = cross(&along, &[lag[0][k], lag[1][k], lag[2][k]]);
            for i in 0..3 {
                columns.turn_by_omega[i][k] = moment * (along[i] * (f.time * before[k]) + across[i]);
                columns.omega_by_omega[i][k] = moment * inverse[i] * by_start[i][k];
            }
        }
        for (p, ([j, k], Integral { value, carried })) in PAIRS.into_iter().zip(integrals).enumerate() {
            // δI ω at both ends, and the share of ∫ δH
            let factor = inverse[j] * inverse[k];
            let (mut lever, mut now) = ([0.0; 3], [0.0; 3]);
            let action = if j == k {
                (lever[j], now[j]) = (before[j], omega[j]);
                0.5 * factor * value
            } else {
                (lever[j], lever[k]) = (before[k], before[j]);
                (now[j], now[k]) = (omega[k], omega[j]);
                f.time * before[j] * before[k] - factor * value
            };
            let share = if j == k { 0.5 * factor } else { factor };
            let change = carried.map(|x| -share * x);
            let rest = [0, 1, 2].map(|i| dot(&lag[i], &lever) - change[i]);
            let across = cross(&along, &rest);
            for i in 0..3 {
                columns.turn_by_inertia[i][p] = along[i] * action + across[i];
                columns.omega_by_inertia[i][p] =
                    inverse[i] * ((dot(&by_start[i], &lever) + change[i]) - now[i]);
            }
        }
        columns
    }
}

fn hadamard(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// From the labelled axes to the body's, and from the units of the elements to SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ToBody {
    /// The labelled axes in the body: one in each column.
    axes: [[f64; 3]; 3],
    /// Elements 11, 22, 33, 12, 13, 23 of a tensor along the labelled axes by its elements xx, yy, zz, xy, xz, yz, in units of the elements.
    tensor: [[f64; 6]; 6],
    /// rad/s per unit.
    rad_s: f64,
}

impl ToBody {
    pub(super) fn of(labelled: &Labelled, kg_m2: f64, rad_s: f64) -> Self {
        let a = labelled.axes;
        let tensor = PAIRS.map(|[j, k]| {
            PAIRS.map(|[x, y]| {
                let both = a[j][x] * a[k][y];
                (if x == y { both } else { both + a[j][y] * a[k][x] }) / kg_m2
            })
        });
        Self { axes: [0, 1, 2].map(|x| a.map(|axis| axis[x])), tensor, rad_s }
    }

    /// A body vector along the labelled axes.
    pub(super) fn along(&self, v: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.axes[0][k] * v[0] + self.axes[1][k] * v[1] + self.axes[2][k] * v[2])
    }

    /// Derivatives by the start and by the tensor; `back` is the attitude at the start, seen from that at t, in the body's axes.
    pub(super) fn derivatives(&self, columns: &Columns, back: &[[f64; 3]; 3]) -> [[[f64; 6]; 6]; 2] {
        let mut by_start = [[0.0; 6]; 6];
        let mut by_inertia = [[0.0; 6]; 6];
        for (half, (by_omega, by_tensor, factor)) in [
            (&columns.turn_by_omega, &columns.turn_by_inertia, 1.0 / self.rad_s),
            (&columns.omega_by_omega, &columns.omega_by_inertia, 1.0),
        ]
        .into_iter()
        .enumerate()
        {
            let turned: [[f64; 3]; 3] = by_omega.map(|row| self.axes.map(|axis| dot(&axis, &row)));
            let tensor: [[f64; 6]; 3] = by_tensor.map(|row| {
                let mut sum = [0.0; 6];
                for (weight, elements) in row.into_iter().zip(&self.tensor) {
                    for (sum, element) in sum.iter_mut().zip(elements) {
                        *sum += weight * element;
                    }
                }
                sum
            });
            for (x, axis) in self.axes.iter().enumerate() {
                let row = 3 * half + x;
                for k in 0..3 {
                    by_start[row][3 + k] =
                        factor * (axis[0] * turned[0][k] + axis[1] * turned[1][k] + axis[2] * turned[2][k]);
                }
                for k in 0..6 {
                    by_inertia[row][k] = (factor * self.rad_s)
                        * (axis[0] * tensor[0][k] + axis[1] * tensor[1][k] + axis[2] * tensor[2][k]);
                }
            }
        }
        for (row, back) in by_start.iter_mut().zip(back) {
            row[..3].copy_from_slice(back);
        }
        [by_start, by_inertia]
    }
}
