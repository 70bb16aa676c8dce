//! Tumbles as a problem of least squares.

use nalgebra::{Matrix3, Vector3};
use polhode::math::{AngularVelocity, Attitude, Body, Rotation};
use polhode::motion::State;

use super::flight::Flight;
use super::motion::{derived, turned};
use super::sensor::GyroErrors;
use crate::error::IdentifyError;
use crate::least_squares::{Problem, Rows};

/// Flights, and what predicts their readings.
///
/// Shared numbers: the tensor's six elements, what is found of the gyro, and the tracked axes in the gyro's, as a rotation vector. Each flight's own: ω at
/// its reference time and, if attitudes were measured, a rotation vector by which the attitude there differs from the reference.
pub(crate) struct Tumbles<'a> {
    pub(crate) flights: &'a [Flight],
    pub(crate) references: Vec<Reference>,
    pub(crate) gyro: GyroErrors,
    /// rad/s
    pub(crate) gyro_noise: f64,
    /// rad
    pub(crate) attitude_noise: f64,
    /// The tracked axes, to begin with; `None` if they are the gyro's.
    pub(crate) tracked: Option<Rotation<Body, Body>>,
}

/// Where a flight's own numbers are counted from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reference {
    /// s
    pub(crate) time: f64,
    pub(crate) attitude: Attitude,
}

/// Rows of a reading.
pub(crate) const CHANNELS: usize = 3;

impl Tumbles<'_> {
    /// How many numbers all flights share.
    pub(crate) fn shared(&self) -> usize {
        6 + self.gyro.count() + if self.tracked.is_some() { 3 } else { 0 }
    }

    /// How many a flight has of its own.
    pub(crate) fn local(&self, flight: usize) -> usize {
        if self.flights[flight].attitudes().is_empty() { 3 } else { 6 }
    }

    /// The state at a flight's reference.
    pub(crate) fn state(&self, flight: usize, local: &[f64]) -> State {
        let Reference { time, attitude } = self.references[flight];
        let attitude = local.get(3..6).map_or(attitude, |t| turned(attitude, [t[0], t[1], t[2]]));
        State { time, attitude, omega: AngularVelocity::from_array([local[0], local[1], local[2]]) }
    }

    /// The tensor of a flight.
    pub(crate) fn tensor(&self, flight: usize, shared: &[f64]) -> [f64; 6] {
        let added = self.flights[flight].added();
        core::array::from_fn(|k| shared[k] + added[k])
    }
}

impl Problem for Tumbles<'_> {
    fn groups(&self) -> usize {
        self.flights.len()
    }

    fn rows(
        &self,
        group: usize,
        shared: &[f64],
        local: &[f64],
        rows: &mut Rows,
    ) -> Result<(), IdentifyError> {
        let flight = &self.flights[group];
        let (tensor, start) = (self.tensor(group, shared), self.state(group, local));
        let gyro_numbers = &shared[6..6 + self.gyro.count()];
        let gyro = self.gyro.gyro(gyro_numbers);
        let matrix = gyro.matrix();
        let times: Vec<f64> = flight.gyro().iter().map(|r| r.time + gyro.clock).collect();
        for (reading, at) in flight.gyro().iter().zip(derived(&tensor, start, &times)?) {
            rows.begin_measurement();
            let (omega, read) = (at.state.omega.to_array(), reading.omega.to_array());
            let predicted = gyro.reading(omega);
            let by_gyro = self.gyro.derivatives(&gyro, omega, acceleration(&tensor, omega));
            for i in 0..CHANNELS {
                let (own, all) = rows.push((read[i] - predicted[i]) / self.gyro_noise);
                for k in 0..3 {
                    let turn = matrix[i][k] / self.gyro_noise;
                    for (own, by) in own.iter_mut().zip(at.by_omega[3 + k]) {
                        *own += turn * by;
                    }
                    for (all, by) in all.iter_mut().zip(at.by_tensor[3 + k]) {
                        *all += turn * by;
                    }
                }
                for (all, by) in all[6..].iter_mut().zip(&by_gyro[i]) {
                    *all = by / self.gyro_noise;
                }
            }
        }
        let times: Vec<f64> = flight.attitudes().iter().map(|r| r.time).collect();
        if times.is_empty() {
            return Ok(());
        }
        // The derivative of exp(θ) at the local rotation vector, in axes of the body
        let local_turn = right_jacobian([local[3], local[4], local[5]]);
        let tracked = self.tracked.map(|first| {
            let t = &shared[6 + self.gyro.count()..];
            let turn = [t[0], t[1], t[2]];
            (first * super::motion::turn(turn), right_jacobian(turn))
        });
        for (reading, at) in flight.attitudes().iter().zip(derived(&tensor, start, &times)?) {
            rows.begin_measurement();
            // measured = R A exp(ε): ε is what is left. δ of R A by θ in the body's axes is A⁻¹ θ in the tracked ones.
            let (axes, by_axes) = tracked.unwrap_or((Rotation::identity(), IDENTITY));
            let predicted = at.state.attitude * axes;
            let left = (predicted.inverse() * reading.attitude).log().to_array();
            let back = axes.inverse().matrix();
            let in_tracked =
                |by: &dyn Fn(usize) -> f64, i: usize| (0..3).map(|k| back[i][k] * by(k)).sum::<f64>();
            for i in 0..CHANNELS {
                let noise = self.attitude_noise;
                let (own, all) = rows.push(left[i] / noise);
                for (k, all) in all[..6].iter_mut().enumerate() {
                    *all = in_tracked(&|row| at.by_tensor[row][k], i) / noise;
                }
                for k in 0..3 {
                    own[k] = in_tracked(&|row| at.by_omega[row][k], i) / noise;
                    let by_start =
                        |row: usize| (0..3).map(|j| at.by_attitude[row][j] * local_turn[j][k]).sum::<f64>();
                    own[3 + k] = in_tracked(&by_start, i) / noise;
                }
                if tracked.is_some() {
                    for k in 0..3 {
                        all[6 + self.gyro.count() + k] = by_axes[i][k] / noise;
                    }
                }
            }
        }
        Ok(())
    }
}

/// ω̇ = I⁻¹ (I ω × ω)
fn acceleration([xx, yy, zz, xy, xz, yz]: &[f64; 6], omega: [f64; 3]) -> [f64; 3] {
    let tensor = Matrix3::new(*xx, *xy, *xz, *xy, *yy, *yz, *xz, *yz, *zz);
    let omega = Vector3::from(omega);
    // A body about an axis of which nothing turns it has no acceleration there.
    tensor.lu().solve(&(tensor * omega).cross(&omega)).unwrap_or_default().into()
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// J of exp(θ + δ) = exp(θ) exp(J δ): 1 − (1 − cos θ)/θ² [θ]× + (θ − sin θ)/θ³ [θ]×²
fn right_jacobian([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let square = x * x + y * y + z * z;
    let angle = square.sqrt();
    let (first, second) = if angle < 1e-3 {
        (0.5 - square / 24.0, 1.0 / 6.0 - square / 120.0)
    } else {
        ((1.0 - libm::cos(angle)) / square, (angle - libm::sin(angle)) / (square * angle))
    };
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let outer = [x, y, z];
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let one = if i == j { 1.0 } else { 0.0 };
            // [θ]×² = θ θᵀ − θ² 1
            one - first * cross[i][j] + second * (outer[i] * outer[j] - square * one)
        })
    })
}
