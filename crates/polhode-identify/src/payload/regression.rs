//! Rows of the wrench as a triangle, for parameters and motions that are improved in every pass.
//!
//! If the motion u = (ω, α, a − g) is measured with noise of covariance Σ, the regressor X(u) is
//! noisy too, and plain least squares is biased towards zero. So the most likely motion û is
//! estimated together with the parameters p. With J = ∂F/∂u and V the covariance of the wrench,
//!
//! V' = V + J Σ Jᵀ,  û = u + Σ Jᵀ V'⁻¹ (y − F(p, û) − J (u − û)),
//!
//! and the rows are X(û) for the response y − J (u − û), with covariance V'. At convergence, p and
//! û maximize the likelihood.
//!
//! Source: W. A. Fuller, *Measurement Error Models* (1987), § 3.2.

use nalgebra::DMatrix;

use super::log::{PayloadLog, WrenchNoise};
use super::motion::{Motion, Regressor, wrench_of};
use super::small::{self, Matrix6, Vector6};
use crate::error::IdentifyError;
use crate::least_squares::{Rows, stacked};

/// State that is improved in every pass.
pub(super) struct Regression<'a> {
    log: &'a PayloadLog,
    deviations: [f64; 9],
    motions: Vec<Motion>,
    /// Weight of each row.
    pub(super) weights: Vec<f64>,
}

/// Rows at given parameters.
pub(super) struct Pass {
    /// Triangles of forces, and of torques given the forces: derivatives by the parameters, and the
    /// residual.
    pub(super) force: DMatrix<f64>,
    pub(super) torque: DMatrix<f64>,
    /// Triangle of forces and torques together.
    pub(super) triangle: DMatrix<f64>,
    /// JᵀJ of second differences of force and of torque, if the noise is estimated from them.
    pub(super) differences: [DMatrix<f64>; 2],
    /// Residuals in standard deviations, row by row.
    pub(super) residuals: Vec<Vector6>,
    /// Residuals in N and N·m, row by row.
    pub(super) left: Vec<Vector6>,
    /// Mean variance caused by the motion: of a force, N², and of a torque, (N·m)².
    pub(super) propagated: [f64; 2],
}

/// One row with its whitening factor L.
struct Whitened {
    l: Matrix6,
    regressor: Regressor,
    jacobian: [[f64; 9]; 6],
    /// Residual y − J (u − û) − X(û) p.
    left: Vector6,
}

impl<'a> Regression<'a> {
    pub(super) fn new(log: &'a PayloadLog) -> Self {
        Self {
            log,
            deviations: [0.0; 9],
            motions: log.rows().iter().map(super::log::PayloadRow::motion).collect(),
            weights: vec![1.0; log.rows().len()],
        }
    }

    pub(super) fn has_motion_noise(&self) -> bool {
        self.deviations.iter().any(|&sd| sd > 0.0)
    }

    /// Includes the stated noise of the motion from now on.
    pub(super) fn regard_motion_noise(&mut self) {
        self.deviations = self.log.motion_deviations();
    }

    /// Computes all rows. `judge` sets the weights from the residuals.
    pub(super) fn pass(
        &mut self,
        numbers: &[f64],
        noise: &Matrix6,
        judge: impl FnOnce(&[Vector6], &mut [f64]),
    ) -> Result<Pass, IdentifyError> {
        let n = numbers.len();
        let (mut force, mut torque) = (Rows::new(0, n), Rows::new(0, n));
        let count = self.log.rows().len();
        let mut pass = Pass {
            force: DMatrix::zeros(0, n + 1),
            torque: DMatrix::zeros(0, n + 1),
            triangle: DMatrix::zeros(0, n + 1),
            differences: [DMatrix::zeros(n, n), DMatrix::zeros(n, n)],
            residuals: Vec::with_capacity(count),
            left: Vec::with_capacity(count),
            propagated: [0.0; 2],
        };
        let known = cholesky(noise)?;
        for row in 0..count {
            if self.has_motion_noise() {
                self.improve_motion(row, numbers, noise)?;
            }
            let white = self.whitened(row, numbers, noise, &known)?;
            let residual = small::forward(&white.l, white.left);
            for (i, row) in white.jacobian.iter().enumerate() {
                let squares = row.iter().zip(&self.deviations).map(|(j, sd)| (j * sd) * (j * sd));
                pass.propagated[i / 3] += squares.sum::<f64>() / (3 * count) as f64;
            }
            pass.residuals.push(residual);
            pass.left.push(white.left);
            push(self.log, &white.l, &white.regressor, residual, [&mut force, &mut torque]);
        }
        judge(&pass.residuals, &mut self.weights);
        if self.log.noise == WrenchNoise::Unknown {
            pass.differences = [&force, &torque].map(|rows| rows.information_of_differences(&self.weights));
        }
        pass.force = force.triangle(&self.weights)?;
        pass.torque = torque.triangle(&self.weights)?;
        pass.triangle = stacked(&pass.force, &pass.torque)?;
        Ok(pass)
    }

    fn whitened(
        &self,
        row: usize,
        numbers: &[f64],
        noise: &Matrix6,
        known: &Matrix6,
    ) -> Result<Whitened, IdentifyError> {
        let (motion, sign) = (&self.motions[row], self.log.sense.sign());
        let regressor = motion.regressor();
        let predicted = wrench_of(&regressor, numbers);
        let measured = self.log.rows()[row].wrench();
        let bias = |i: usize| numbers.get(10 + i).copied().unwrap_or(0.0);
        let mut left: Vector6 = core::array::from_fn(|i| measured[i] - sign * predicted[i] - bias(i));
        if !self.has_motion_noise() {
            return Ok(Whitened { l: *known, regressor, jacobian: [[0.0; 9]; 6], left });
        }
        let jacobian = motion.jacobian(numbers).map(|row| row.map(|j| sign * j));
        let given = self.log.rows()[row].motion();
        for (left, j) in left.iter_mut().zip(&jacobian) {
            *left -= (0..9).map(|k| j[k] * (given.0[k] - motion.0[k])).sum::<f64>();
        }
        let covariance: Matrix6 = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let spread =
                    |k: usize| jacobian[i][k] * jacobian[j][k] * self.deviations[k] * self.deviations[k];
                noise[i][j] + (0..9).map(spread).sum::<f64>()
            })
        });
        let l = cholesky(&covariance)?;
        Ok(Whitened { l, regressor, jacobian, left })
    }

    /// Updates the most likely motion û of a row for these parameters.
    fn improve_motion(&mut self, row: usize, numbers: &[f64], noise: &Matrix6) -> Result<(), IdentifyError> {
        let white = self.whitened(row, numbers, noise, noise)?;
        let pulled = small::backward(&white.l, small::forward(&white.l, white.left));
        let given = self.log.rows()[row].motion();
        self.motions[row] = Motion(core::array::from_fn(|k| {
            let sum: f64 = (0..6).map(|i| white.jacobian[i][k] * pulled[i]).sum();
            given.0[k] + self.deviations[k] * self.deviations[k] * sum
        }));
        Ok(())
    }

    /// Returns Nᵀ N, where N are the rows if the motion consisted only of the remaining noise of û.
    /// A long log is sampled and the result scaled up.
    pub(super) fn noise_information(
        &self,
        numbers: &[f64],
        noise: &Matrix6,
    ) -> Result<DMatrix<f64>, IdentifyError> {
        let (count, n) = (self.log.rows().len(), numbers.len());
        let stride = count.div_ceil(SAMPLED);
        let scale = count as f64 / count.div_ceil(stride) as f64;
        let own = cholesky(noise)?;
        let mut sum = DMatrix::zeros(n, n);
        for row in (0..count).step_by(stride).filter(|&row| self.weights[row] > 0.0) {
            let white = self.whitened(row, numbers, noise, &own)?;
            for direction in self.remaining(&white, &own) {
                // Half the difference over two steps: exact, because the wrench is quadratic in the
                // motion.
                let there = self.motions[row].moved(&direction, 1.0).regressor();
                let back = self.motions[row].moved(&direction, -1.0).regressor();
                let columns: [Vector6; 10] = core::array::from_fn(|k| {
                    small::forward(&white.l, core::array::from_fn(|i| 0.5 * (there[i][k] - back[i][k])))
                });
                for i in 0..10 {
                    for j in 0..10 {
                        sum[(i, j)] += scale * small::dot(&columns[i], &columns[j]);
                    }
                }
            }
        }
        Ok(sum)
    }

    /// Returns a factor of the covariance of û: (1 − K J) Σ (1 − K J)ᵀ + K V Kᵀ with the gain
    /// K = Σ Jᵀ V'⁻¹.
    fn remaining(&self, white: &Whitened, own: &Matrix6) -> Vec<[f64; 9]> {
        let gain = |of: Vector6| -> [f64; 9] {
            let pulled = small::backward(&white.l, small::forward(&white.l, of));
            core::array::from_fn(|k| {
                let sum: f64 = (0..6).map(|i| white.jacobian[i][k] * pulled[i]).sum();
                self.deviations[k] * self.deviations[k] * sum
            })
        };
        let mut all = Vec::with_capacity(15);
        for k in (0..9).filter(|&k| self.deviations[k] > 0.0) {
            let sd = self.deviations[k];
            let corrected = gain(core::array::from_fn(|i| white.jacobian[i][k] * sd));
            let mut direction = corrected.map(|g| -g);
            direction[k] += sd;
            all.push(direction);
        }
        for j in 0..6 {
            let column = own.map(|row| row[j]);
            all.push(gain(column));
        }
        all
    }
}

/// Adds the rows of one wrench to those of the force and of the torque: columns L⁻¹ X, and those of
/// the bias.
pub(super) fn push(
    log: &PayloadLog,
    l: &Matrix6,
    regressor: &Regressor,
    residual: Vector6,
    of: [&mut Rows; 2],
) {
    let columns: Vec<Vector6> = (0..log.unknowns())
        .map(|k| {
            let column = core::array::from_fn(|i| match k {
                0..10 => log.sense.sign() * regressor[i][k],
                _ => f64::from(u8::from(i == k - 10)),
            });
            small::forward(l, column)
        })
        .collect();
    for (rows, first) in of.into_iter().zip([0, 3]) {
        rows.begin_measurement();
        for i in first..first + 3 {
            let (_, derivatives) = rows.push(residual[i]);
            derivatives.iter_mut().zip(&columns).for_each(|(derivative, column)| *derivative = column[i]);
        }
    }
}

/// Returns the Cholesky factor L of a covariance L Lᵀ.
fn cholesky(covariance: &Matrix6) -> Result<Matrix6, IdentifyError> {
    let quantity = "the Cholesky factor of the wrench's covariance";
    small::cholesky(covariance).ok_or(IdentifyError::NotFinite { quantity })
}

/// Maximum number of rows sampled for the noise of the motion.
const SAMPLED: usize = 200;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::payload::{MotionNoise, PayloadRow, WrenchSense};
    use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Force, Torque};

    /// The covariance of û is (Σ⁻¹ + Jᵀ V⁻¹ J)⁻¹, as of any combination of two independent
    /// measurements of u: Σ of the motion, and V of the wrench.
    #[test]
    fn the_remaining_noise_is_that_of_two_measurements_together() {
        let row = PayloadRow {
            time: 0.3,
            omega: AngularVelocity::new(1.3, -0.7, 2.1),
            alpha: AngularAcceleration::new(-4.0, 3.1, 0.9),
            acceleration: Acceleration::new(0.4, -1.2, 2.3),
            gravity: Acceleration::new(3.0, -9.0, 2.5),
            force: Force::new(3.0, 20.0, -4.0),
            torque: Torque::new(0.2, -0.3, 0.5),
        };
        let deviations = MotionNoise { omega: 0.05, alpha: 2.0, acceleration: 0.7 };
        let log = PayloadLog::new(vec![row], WrenchSense::OnPayload).unwrap();
        let log = log.with_motion_noise(deviations).unwrap();
        let mut regression = Regression::new(&log);
        regression.regard_motion_noise();
        let numbers = [1.7, 0.12, -0.2, 0.31, 0.09, 0.11, 0.07, -0.02, 0.013, -0.017];
        let variances = [0.04, 0.09, 0.02, 0.003, 0.005, 0.002];
        let noise: Matrix6 =
            core::array::from_fn(|i| core::array::from_fn(|j| if i == j { variances[i] } else { 0.0 }));
        let own = cholesky(&noise).unwrap();
        let white = regression.whitened(0, &numbers, &noise, &own).unwrap();
        let directions = regression.remaining(&white, &own);
        let covariance = |i: usize, k: usize| directions.iter().map(|d| d[i] * d[k]).sum::<f64>();
        let inverse = |k: usize, j: usize| {
            let known = if k == j { regression.deviations[k].powi(-2) } else { 0.0 };
            let measured = |i: usize| white.jacobian[i][k] * white.jacobian[i][j] / variances[i];
            known + (0..6).map(measured).sum::<f64>()
        };
        for i in 0..9 {
            for j in 0..9 {
                let product: f64 = (0..9).map(|k| covariance(i, k) * inverse(k, j)).sum();
                let want = f64::from(u8::from(i == j));
                assert!((product - want).abs() < 1e-10, "{i} {j}: {product}");
            }
        }
        // Both parts matter here: the wrench removes much of the noise of α and a − g, not all.
        let [alpha, acceleration] = [covariance(3, 3) / 4.0, covariance(8, 8) / 0.49];
        assert!(
            (0.01..0.9).contains(&alpha) && (0.01..0.9).contains(&acceleration),
            "{alpha} {acceleration}"
        );
    }
}
