//! Payloads known to be laminae, rods or points: least squares along the boundary of physical
//! consistency.
//!
//! Every such body has Σ = U Uᵀ + m c cᵀ, where U has three rows and one column per direction with
//! extent. U and U Q give the same body for every rotation Q, so the minimum-norm step is taken.

use nalgebra::{DMatrix, DVector};
use polhode::math::symmetric_eigen;

use super::edge::EdgeKind;
use super::possible::moments_about_center;
use crate::decomposition::{Svd, svd};
use crate::error::IdentifyError;
use crate::six::PLACES;

/// Maximum number of steps.
const MOST_STEPS: usize = 100;
/// Convergence threshold: stop when a step lowers ½χ² by less than this, relative to 1 + ½χ².
const NOTHING: f64 = 1e-12;

/// Current point: m, c, the columns of U in order, and any further parameters.
struct Place {
    extent: usize,
    numbers: DVector<f64>,
}

/// Minimizes ‖z − R (p − from)‖² over bodies of a kind, from a physically consistent start.
pub(super) fn least_squares(
    r: &DMatrix<f64>,
    z: &DVector<f64>,
    from: &DVector<f64>,
    start: &DVector<f64>,
    kind: EdgeKind,
) -> Result<DVector<f64>, IdentifyError> {
    let mut place = Place::near(start, 3 - kind.thin());
    let rest = |place: &Place| z - r * (place.physical() - from);
    let mut here = rest(&place);
    let mut damping = 1e-6;
    for _ in 0..MOST_STEPS {
        let Some(step) = step(&(r * place.jacobian()), &here, damping)? else { break };
        let there = Place { extent: place.extent, numbers: &place.numbers + &step };
        let left = rest(&there);
        let gain = 0.5 * (here.norm_squared() - left.norm_squared());
        if gain > 0.0 && there.numbers[0] > 0.0 {
            let nothing = gain <= NOTHING * (1.0 + 0.5 * here.norm_squared());
            (place, here) = (there, left);
            damping = f64::max(0.1 * damping, 1e-15);
            if nothing {
                break;
            }
        } else {
            damping *= 10.0;
            if damping > 1e6 {
                break;
            }
        }
    }
    Ok(place.physical())
}

/// Solves (JᵀJ + damping D²) δ = Jᵀ r, where D has the norms of the columns.
fn step(
    jacobian: &DMatrix<f64>,
    residual: &DVector<f64>,
    damping: f64,
) -> Result<Option<DVector<f64>>, IdentifyError> {
    let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    let mut scaled = jacobian.clone();
    for (mut column, norm) in scaled.column_iter_mut().zip(&norms) {
        column /= if *norm > 0.0 { *norm } else { 1.0 };
    }
    let Svd { u, values, v_t } = svd("the Jacobian of a thin body", scaled)?;
    let mut along = u.tr_mul(residual);
    for (x, s) in along.iter_mut().zip(&values) {
        *x *= s / (s * s + damping);
    }
    let mut step = v_t.tr_mul(&along);
    for (x, norm) in step.iter_mut().zip(&norms) {
        *x /= if *norm > 0.0 { *norm } else { 1.0 };
    }
    Ok(step.iter().all(|x| x.is_finite()).then_some(step))
}

impl Place {
    fn near(physical: &DVector<f64>, extent: usize) -> Self {
        let n = physical.len();
        let m = physical[0];
        let (values, vectors) = symmetric_eigen(moments_about_center(physical.as_slice()));
        let mut numbers = vec![m, physical[1] / m, physical[2] / m, physical[3] / m];
        for k in 3 - extent..3 {
            // Columns must not start at zero, because their derivatives vanish there.
            let size = values[k].max(1e-6 * values[2]).max(0.0).sqrt();
            numbers.extend(vectors[k].map(|v| size * v));
        }
        numbers.extend((10..n).map(|k| physical[k]));
        Self { extent, numbers: DVector::from_vec(numbers) }
    }

    fn center(&self) -> [f64; 3] {
        [1, 2, 3].map(|k| self.numbers[k])
    }

    fn column(&self, k: usize) -> [f64; 3] {
        [0, 1, 2].map(|i| self.numbers[4 + 3 * k + i])
    }

    /// Returns m, m c, the tensor about the origin, and any further parameters.
    fn physical(&self) -> DVector<f64> {
        let (m, c) = (self.numbers[0], self.center());
        let mut all = vec![m, m * c[0], m * c[1], m * c[2]];
        let point = tensor(c, c);
        let mut own = point.map(|x| m * x);
        for k in 0..self.extent {
            let u = self.column(k);
            for (sum, x) in own.iter_mut().zip(tensor(u, u)) {
                *sum += x;
            }
        }
        all.extend(own);
        all.extend(self.numbers.iter().skip(4 + 3 * self.extent));
        DVector::from_vec(all)
    }

    fn jacobian(&self) -> DMatrix<f64> {
        let (m, c) = (self.numbers[0], self.center());
        let own = 4 + 3 * self.extent;
        let others = self.numbers.len() - own;
        let mut all = DMatrix::zeros(10 + others, own + others);
        let mut set = |column: usize, of: [f64; 6]| (0..6).for_each(|k| all[(4 + k, column)] = of[k]);
        set(0, tensor(c, c));
        for j in 0..3 {
            let unit: [f64; 3] = core::array::from_fn(|i| if i == j { 1.0 } else { 0.0 });
            set(1 + j, tensor(unit, c).map(|x| 2.0 * m * x));
            for k in 0..self.extent {
                set(4 + 3 * k + j, tensor(unit, self.column(k)).map(|x| 2.0 * x));
            }
        }
        all[(0, 0)] = 1.0;
        for j in 0..3 {
            all[(1 + j, 0)] = c[j];
            all[(1 + j, 1 + j)] = m;
        }
        (0..others).for_each(|k| all[(10 + k, own + k)] = 1.0);
        all
    }
}

/// Returns tr(G) 1 − G for G = ½ (a bᵀ + b aᵀ).
fn tensor(a: [f64; 3], b: [f64; 3]) -> [f64; 6] {
    let dot: f64 = (0..3).map(|k| a[k] * b[k]).sum();
    PLACES.map(|(i, j)| if i == j { dot } else { 0.0 } - 0.5 * (a[i] * b[j] + a[j] * b[i]))
}
