//! Periodic motion of a given amplitude, by collocation.
//!
//! The motion is at rest at the beginning and after half a period, so with τ = ω t
//!
//! u(τ) = Σ c_k cos kτ.
//!
//! The equations hold at τ_j = π j/(N − 1). Newton's method solves for all u(τ_j) and ω. The same
//! matrix gives their derivatives by the quantities in the equations.

use core::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::rig::{Equations, Oscillator};
use crate::decomposition::lu;
use crate::error::IdentifyError;

/// Collocation points in half a period, with matrices from values to derivatives.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    first: DMatrix<f64>,
    second: DMatrix<f64>,
    /// Matrix from values to coefficients of cos kτ.
    pub(super) harmonics: DMatrix<f64>,
}

impl Grid {
    /// Returns a grid with enough points for this amplitude, rad. A pendulum's harmonics fall off
    /// as powers of its nome.
    pub(super) fn of_amplitude(amplitude: f64) -> Self {
        let m = libm::sin(0.5 * amplitude).powi(2);
        // K′/K by arithmetic–geometric means; q = exp(−π K′/K), and harmonic k is of the order
        // q^(k/2).
        let ratio = mean(1.0, (1.0 - m).sqrt()) / mean(1.0, m.sqrt());
        let fall = 0.5 * PI * ratio;
        Self::new((34.0 / fall).ceil().clamp(8.0, 120.0) as usize)
    }

    fn new(count: usize) -> Self {
        let last = count - 1;
        let angle = |k: usize, j: usize| PI * ((k * j) % (2 * last)) as f64 / last as f64;
        let end = |k: usize| if k == 0 || k == last { 0.5 } else { 1.0 };
        let harmonics = DMatrix::from_fn(count, count, |k, j| {
            2.0 / last as f64 * end(k) * end(j) * libm::cos(angle(k, j))
        });
        let slope = DMatrix::from_fn(count, count, |j, k| -(k as f64) * libm::sin(angle(k, j)));
        let bend = DMatrix::from_fn(count, count, |j, k| -((k * k) as f64) * libm::cos(angle(k, j)));
        Self { first: slope * &harmonics, second: bend * &harmonics, harmonics }
    }

    pub(super) fn count(&self) -> usize {
        self.first.nrows()
    }
}

/// Returns the arithmetic–geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        if (a - b).abs() <= 1e-15 * a {
            break;
        }
    }
    a
}

/// Motion: u at the collocation points, one row each, and ω.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    pub(super) u: DMatrix<f64>,
    pub(super) rate: f64,
}

/// Motion of a given amplitude, and its derivatives by the oscillator's quantities at this
/// amplitude.
#[derive(Clone, Debug)]
pub(super) struct Orbit {
    pub(super) motion: Motion,
    pub(super) rate_by: Vec<f64>,
    /// Angle at the collocation points, rad.
    pub(super) angle: DVector<f64>,
    /// Derivatives of the angle, one row per collocation point.
    pub(super) angle_by: DMatrix<f64>,
}

/// Maximum number of Newton steps.
const MOST_STEPS: usize = 25;
/// Convergence threshold of a step, relative to the amplitude; after quadratic convergence the next
/// step is rounding.
const CONVERGED: f64 = 1e-8;

impl Motion {
    /// Returns the small oscillation about rest, scaled to an amplitude.
    pub(super) fn small(oscillator: &dyn Oscillator, grid: &Grid, amplitude: f64) -> Self {
        let (rest, last) = (oscillator.rest(), grid.count() - 1);
        let u = DMatrix::from_fn(grid.count(), rest.u.len(), |j, i| {
            rest.u[i] + amplitude * rest.mode[i] * libm::cos(PI * j as f64 / last as f64)
        });
        Self { u, rate: rest.rate }
    }

    /// Extrapolates to another amplitude. The part that changes sign after half a period scales
    /// with the ratio, the other part with its square.
    pub(super) fn grown(&self, oscillator: &dyn Oscillator, ratio: f64) -> Self {
        let (rest, count) = (oscillator.rest(), self.u.nrows());
        let u = DMatrix::from_fn(count, rest.u.len(), |j, i| {
            let (here, there) = (self.u[(j, i)], self.u[(count - 1 - j, i)]);
            let (odd, even) = (0.5 * (here - there), 0.5 * (here + there) - rest.u[i]);
            rest.u[i] + ratio * odd + ratio * ratio * even
        });
        Self { u, rate: rest.rate + ratio * ratio * (self.rate - rest.rate) }
    }

    /// Solves the motion of an amplitude, from a guess.
    pub(super) fn solved(
        mut self,
        oscillator: &dyn Oscillator,
        grid: &Grid,
        amplitude: f64,
    ) -> Result<Orbit, IdentifyError> {
        for _ in 0..MOST_STEPS {
            let system = System::new(oscillator, grid, &self, amplitude, false);
            let matrix = lu("a derivative of the swing's equations", system.matrix)?;
            let Some(step) = matrix.solve(&system.value) else { break };
            let size = self.take(&step, amplitude);
            if !size.is_finite() || size > 1e3 {
                break;
            }
            if size < CONVERGED {
                return self.differentiated(oscillator, grid, amplitude);
            }
        }
        Err(IdentifyError::NoConvergence { steps: MOST_STEPS })
    }

    /// Applies a step and returns its relative size.
    fn take(&mut self, step: &DVector<f64>, amplitude: f64) -> f64 {
        let width = self.u.ncols();
        let mut size = 0.0_f64;
        for i in 0..width {
            let largest = self.u.column(i).amax().max(amplitude);
            for j in 0..self.u.nrows() {
                let change = step[j * width + i];
                self.u[(j, i)] -= change;
                size = size.max(change.abs() / largest);
            }
        }
        let change = step[step.len() - 1];
        self.rate -= change;
        size.max(change.abs() / self.rate.abs())
    }

    /// Takes one more Newton step and computes the derivatives.
    fn differentiated(
        mut self,
        oscillator: &dyn Oscillator,
        grid: &Grid,
        amplitude: f64,
    ) -> Result<Orbit, IdentifyError> {
        let (count, width) = self.u.shape();
        let system = System::new(oscillator, grid, &self, amplitude, true);
        let decomposition = lu("a derivative of the swing's equations", system.matrix)?;
        let solved = decomposition.solve(&system.value).zip(decomposition.solve(&system.by_quantities));
        let Some((step, by)) = solved else {
            return Err(IdentifyError::NotFinite { quantity: "the solution of the swing's equations" });
        };
        self.take(&step, amplitude);
        let quantities = by.ncols();
        let mut angle = DVector::zeros(count);
        let mut angle_by = DMatrix::zeros(count, quantities);
        for j in 0..count {
            let u = row(&self.u, j);
            oscillator.check(&u)?;
            let (value, slope) = oscillator.angle(&u);
            angle[j] = value;
            for q in 0..quantities {
                angle_by[(j, q)] = -(0..width).map(|i| slope[i] * by[(j * width + i, q)]).sum::<f64>();
            }
        }
        let rate_by = by.row(count * width).iter().map(|by| -by).collect();
        Ok(Orbit { motion: self, rate_by, angle, angle_by })
    }
}

fn row(matrix: &DMatrix<f64>, j: usize) -> Vec<f64> {
    matrix.row(j).iter().copied().collect()
}

/// All equations at all collocation points, and the amplitude condition: half the change of the
/// angle in half a period.
struct System {
    value: DVector<f64>,
    matrix: DMatrix<f64>,
    by_quantities: DMatrix<f64>,
}

impl System {
    fn new(
        oscillator: &dyn Oscillator,
        grid: &Grid,
        motion: &Motion,
        amplitude: f64,
        by_quantities: bool,
    ) -> Self {
        let (count, width) = motion.u.shape();
        let quantities = if by_quantities { oscillator.quantities().len() } else { 0 };
        let size = count * width + 1;
        let rate = motion.rate;
        let (first, second) = (&grid.first * &motion.u, &grid.second * &motion.u);
        let mut system = Self {
            value: DVector::zeros(size),
            matrix: DMatrix::zeros(size, size),
            by_quantities: DMatrix::zeros(size, quantities),
        };
        for j in 0..count {
            let u = row(&motion.u, j);
            let (slope, bend) = (first.row(j), second.row(j));
            let rates: Vec<f64> = slope.iter().map(|x| rate * x).collect();
            let accelerations: Vec<f64> = bend.iter().map(|x| rate * rate * x).collect();
            let Equations { value, by_u, by_rate, by_acceleration, by_quantities } =
                oscillator.equations(&u, &rates, &accelerations, by_quantities);
            for r in 0..width {
                let at = j * width + r;
                system.value[at] = value[r];
                for i in 0..width {
                    let (by_slope, by_bend) = (by_rate[(r, i)], by_acceleration[(r, i)]);
                    system.matrix[(at, j * width + i)] += by_u[(r, i)];
                    if by_slope != 0.0 || by_bend != 0.0 {
                        for other in 0..count {
                            system.matrix[(at, other * width + i)] +=
                                rate * by_slope * grid.first[(j, other)]
                                    + rate * rate * by_bend * grid.second[(j, other)];
                        }
                        system.matrix[(at, size - 1)] += by_slope * slope[i] + 2.0 * rate * by_bend * bend[i];
                    }
                }
                for q in 0..quantities {
                    system.by_quantities[(at, q)] = by_quantities[(r, q)];
                }
            }
        }
        let last = count - 1;
        let (start, by_start) = oscillator.angle(&row(&motion.u, 0));
        let (end, by_end) = oscillator.angle(&row(&motion.u, last));
        system.value[size - 1] = 0.5 * (start - end) - amplitude;
        for i in 0..width {
            system.matrix[(size - 1, i)] = 0.5 * by_start[i];
            system.matrix[(size - 1, last * width + i)] = -0.5 * by_end[i];
        }
        system
    }
}
