//! Onset of slip at the limit of static friction. Slip grows with the square of time, and friction
//! aligns against the slip on a much shorter time scale.
//!
//! The equations are stiff, and the direction of slip is undefined at the start, but the motion is
//! smooth. A polynomial is therefore found by collocation at Gauss nodes (order 2 × [`STAGES`])
//! with Newton's method.
//!
//! Sources: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8; on the
//! onset of slip, D. E. Stewart, SIAM Rev. 42 (2000) 3.

use super::equations::{Kinetics, Pivot, Regime};
use super::stepper::Stepper;
use super::watch::Watch;
use crate::math::algebra::Components;
use crate::motion::solve::collocation::{Nodes, monomials};

/// Number of collocation nodes.
const STAGES: usize = 9;
/// Threshold on the last coefficients of an accepted polynomial, relative to the sizes of the
/// variables. Near the start friction is as uncertain as the direction of a slip of about 1e-9 of
/// the speed.
const SMALL: f64 = 1e-12;
/// Maximum number of Newton iterations.
const ITERATIONS: usize = 12;

/// Motion after an onset, as polynomials of the elapsed time: coefficients of each variable and of
/// each watched function.
pub(super) struct Onset {
    pub(super) duration: f64,
    pub(super) variables: Vec<Vec<f64>>,
    pub(super) outputs: Vec<Vec<f64>>,
}

impl Stepper {
    /// Computes the onset of slip of a body that has rolled so far. `rolling` gives its variables,
    /// and `longest` is the step of the rolling motion.
    pub(super) fn onset(
        &self,
        rolling: &dyn Fn(f64) -> Vec<f64>,
        pivot: Pivot,
        longest: f64,
        watches: &[Watch],
    ) -> Option<Onset> {
        let nodes = Nodes::new();
        // Try shorter and shorter steps. If slip begins slowly, or another change follows soon, a
        // long polynomial does not converge. In a very short time the slip is below rounding.
        let factor = |k: i32| libm::exp2(-f64::from(k) / 3.0);
        (1..36).find_map(|k| self.collocated(rolling, pivot, longest * factor(k), &nodes, watches))
    }

    fn collocated(
        &self,
        rolling: &dyn Fn(f64) -> Vec<f64>,
        pivot: Pivot,
        h: f64,
        nodes: &Nodes<STAGES>,
        watches: &[Watch],
    ) -> Option<Onset> {
        let read = |y: &[f64]| self.model.kinetics(1.0, y, Regime::Rolling, pivot);
        let first = rolling(0.0);
        let beginning = read(&first).sliding(&first, Components([0.0; 3]));
        let count = beginning.len();
        let rates = |y: &[f64]| self.model.rates(1.0, y, Regime::Sliding, pivot).0;
        // Initial guess: it rolls on, and slips against the force that would hold it.
        let mut stages: Vec<Vec<f64>> = Vec::new();
        for c in nodes.at {
            let y = rolling(c * h);
            let at = read(&y);
            let against = against(&at)?;
            let trial = at.sliding(&y, against.scaled(1e-8 * self.speed(&y)));
            let sliding = self.model.kinetics(1.0, &trial, Regime::Sliding, pivot);
            let growth = sliding.slip_rate(&self.model).dot(against);
            if !(growth > 0.0) {
                return None;
            }
            stages.push(at.sliding(&y, against.scaled(0.5 * growth * c * h)));
        }
        let sizes = self.sizes_of(&beginning);
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let slopes: Vec<Vec<f64>> = stages.iter().map(|y| rates(y)).collect();
            let mut residual: Vec<f64> = Vec::with_capacity(STAGES * count);
            for (stage, integrals) in stages.iter().zip(&nodes.integrals) {
                for k in 0..count {
                    let sum: f64 = integrals.iter().zip(&slopes).map(|(a, f)| a * f[k]).sum();
                    residual.push(beginning[k] + h * sum - stage[k]);
                }
            }
            let jacobians: Vec<Vec<Vec<f64>>> =
                stages.iter().map(|y| self.jacobian(y, pivot, &sizes)).collect();
            // (1 − h A ⊗ J) Δ = residual
            let mut matrix = vec![vec![0.0; STAGES * count]; STAGES * count];
            for (i, integrals) in nodes.integrals.iter().enumerate() {
                for (j, a) in integrals.iter().enumerate() {
                    for k in 0..count {
                        for l in 0..count {
                            let own = if i == j && k == l { 1.0 } else { 0.0 };
                            matrix[i * count + k][j * count + l] = own - h * a * jacobians[j][l][k];
                        }
                    }
                }
            }
            let change = solved(matrix, residual)?;
            for (stage, change) in stages.iter_mut().zip(change.chunks(count)) {
                stage.iter_mut().zip(change).for_each(|(y, d)| *y += d);
            }
            let size =
                change.iter().zip(sizes.iter().cycle()).map(|(d, s)| (d / s).abs()).fold(0.0, f64::max);
            if size.is_nan() {
                return None;
            }
            // Quadratic convergence until only rounding remains.
            if size < 1e-14 || size < 1e-11 && size > 0.5 * last {
                return self.polynomials((&beginning, &stages), pivot, (h, nodes), watches);
            }
            last = size;
        }
        None
    }

    /// Returns the columns of ∂(rates)/∂(variable), accurate enough for Newton's method.
    fn jacobian(&self, y: &[f64], pivot: Pivot, sizes: &[f64]) -> Vec<Vec<f64>> {
        let at = self.model.kinetics(1.0, y, Regime::Sliding, pivot);
        let slip = at.slip.dot(at.slip).sqrt();
        let speed = self.speed(y);
        let rates = |y: &[f64]| self.model.rates(1.0, y, Regime::Sliding, pivot).0;
        (0..y.len())
            .map(|k| {
                // Relative change of the slip.
                let step = 1e-4 * sizes[k] * (slip / speed).min(1e-2);
                let shifted = |by: f64| {
                    let mut y = y.to_vec();
                    y[k] += by;
                    rates(&y)
                };
                let (up, down) = (shifted(step), shifted(-step));
                up.iter().zip(down).map(|(up, down)| (up - down) / (2.0 * step)).collect()
            })
            .collect()
    }

    /// Returns the polynomials through the stages if they have converged, i.e. if their last
    /// coefficients are small.
    fn polynomials(
        &self,
        (beginning, stages): (&[f64], &[Vec<f64>]),
        pivot: Pivot,
        (h, nodes): (f64, &Nodes<STAGES>),
        watches: &[Watch],
    ) -> Option<Onset> {
        let sizes = self.sizes_of(beginning);
        let slopes: Vec<Vec<f64>> =
            stages.iter().map(|y| self.model.rates(1.0, y, Regime::Sliding, pivot).0).collect();
        let mut variables = Vec::new();
        for (k, &y) in beginning.iter().enumerate() {
            let values = core::array::from_fn(|stage| h * slopes[stage][k]);
            let legendre = nodes.legendre(&values);
            let [.., before, last] = legendre;
            if before.abs().max(last.abs()) > SMALL * sizes[k] {
                return None;
            }
            let integrated = monomials(&legendre).into_iter().enumerate().map(|(n, c)| c / (n + 1) as f64);
            let in_time = [y].into_iter().chain(integrated).enumerate();
            variables.push(in_time.map(|(n, c)| c * h.powi(-(n as i32))).collect());
        }
        let watched: Vec<Vec<f64>> = stages
            .iter()
            .map(|y| {
                let at = self.model.kinetics(1.0, y, Regime::Sliding, pivot);
                watches.iter().map(|watch| self.value(&at, *watch, pivot)).collect()
            })
            .collect();
        let count = watched.first().map_or(0, Vec::len);
        let outputs = (0..count).map(|k| {
            let values = core::array::from_fn(|stage| watched[stage][k]);
            let in_time = monomials(&nodes.legendre(&values)).into_iter().enumerate();
            in_time.map(|(n, c)| c * h.powi(-(n as i32))).collect()
        });
        Some(Onset { duration: h, variables, outputs: outputs.collect() })
    }
}

/// Returns the unit vector opposite to the force of friction.
fn against(at: &Kinetics<f64>) -> Option<Components<f64>> {
    let size = at.tangential.dot(at.tangential).sqrt();
    (size > 0.0).then(|| at.tangential.scaled(-1.0 / size))
}

/// Solves by elimination with partial pivoting; `None` if the matrix is singular.
fn solved(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        if !(a[k][k].abs() > 0.0) {
            return None;
        }
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            if factor != 0.0 {
                let (above, below) = a.split_at_mut(i);
                below[0][k..].iter_mut().zip(&above[k][k..]).for_each(|(x, y)| *x -= factor * y);
                b[i] -= factor * b[k];
            }
        }
    }
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - sum) / a[k][k];
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_systems_are_solved() {
        let a = vec![vec![0.0, 2.0, 1.0], vec![1.0, -1.0, 3.0], vec![4.0, 1.0, -2.0]];
        let x = [1.5, -0.5, 2.0];
        let b = a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect();
        for (got, want) in solved(a, b).unwrap().into_iter().zip(x) {
            assert!((got - want).abs() < 1e-15);
        }
        assert!(solved(vec![vec![1.0, 2.0], vec![2.0, 4.0]], vec![1.0, 1.0]).is_none());
    }
}
