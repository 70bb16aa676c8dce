//! Least-squares problem of tumbles.

use nalgebra::{Matrix3, Vector3};
use polhode::math::{AngularVelocity, Attitude, Body, Rotation};
use polhode::motion::State;
use polhode::motion::torque::DragLaw;

use super::flight::Flight;
use super::motion::{Flown, turn, turned};
use super::sensor::GyroErrors;
use crate::decomposition::lu;
use crate::error::IdentifyError;
use crate::least_squares::{Problem, Rows, rows_of, side_by_side};
use crate::residuals::Noise;
use crate::six::{Six, matrix};

/// Flights, and the model that predicts their readings.
///
/// Shared parameters: the six elements of the tensor, those of drag if there is any, the estimated
/// gyro errors, and the tracked axes relative to the gyro's as a rotation vector. Local parameters
/// of a flight: ω at its reference time and, with attitudes, the rotation vector from the reference
/// attitude to the estimated one.
pub(crate) struct Tumbles<'a> {
    pub(crate) flights: &'a [Flight],
    pub(crate) references: Vec<Reference>,
    pub(crate) gyro: GyroErrors,
    /// Noise of a gyro component, rad/s.
    pub(crate) gyro_noise: Noise,
    /// Standard deviation of an attitude component, rad.
    pub(crate) attitude_noise: f64,
    /// Law of drag against ω, if drag is estimated.
    pub(crate) drag: Option<DragLaw>,
    /// Initial estimate of the tracked axes; `None` if they are the gyro's.
    pub(crate) tracked: Option<Rotation<Body, Body>>,
}

/// Reference point of a flight's local parameters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reference {
    /// Time, s.
    pub(crate) time: f64,
    pub(crate) attitude: Attitude,
}

/// Number of rows per reading.
pub(crate) const CHANNELS: usize = 3;

impl Tumbles<'_> {
    /// Returns the number of drag parameters.
    pub(crate) const fn drag_count(&self) -> usize {
        if self.drag.is_some() { 6 } else { 0 }
    }

    /// Returns the index of the first gyro parameter.
    const fn gyro_from(&self) -> usize {
        6 + self.drag_count()
    }

    /// Returns the index of the first parameter of the tracked axes.
    const fn axes_from(&self) -> usize {
        self.gyro_from() + self.gyro.count()
    }

    /// Returns the number of shared parameters.
    pub(crate) const fn shared(&self) -> usize {
        self.axes_from() + if self.tracked.is_some() { 3 } else { 0 }
    }

    /// Returns the number of local parameters of a flight.
    pub(crate) fn local(&self, flight: usize) -> usize {
        if self.flights[flight].attitudes().is_empty() { 3 } else { 6 }
    }

    /// Returns the state at a flight's reference time.
    pub(crate) fn state(&self, flight: usize, local: &[f64]) -> State {
        let Reference { time, attitude } = self.references[flight];
        let attitude = local.get(3..6).map_or(attitude, |t| turned(attitude, [t[0], t[1], t[2]]));
        State { time, attitude, omega: AngularVelocity::from_array([local[0], local[1], local[2]]) }
    }

    /// Returns the body with the torques on it in a flight.
    pub(crate) fn flown(&self, flight: usize, shared: &[f64]) -> Flown<'_> {
        let flight = &self.flights[flight];
        let added = flight.added();
        Flown {
            tensor: core::array::from_fn(|k| shared[k] + added[k]),
            drag: self.drag.map(|law| (law, core::array::from_fn(|k| shared[6 + k]))),
            wheels: flight.wheels(),
            torques: flight.torques(),
        }
    }

    fn gyro_rows(
        &self,
        (flown, start): (&Flown<'_>, State),
        flight: &Flight,
        shared: &[f64],
        rows: &mut Rows,
    ) -> Result<(), IdentifyError> {
        let gyro = self.gyro.gyro(&shared[self.gyro_from()..self.axes_from()]);
        let (matrix, noise) = (gyro.matrix(), self.gyro_noise.deviation);
        let times: Vec<f64> = flight.gyro().iter().map(|r| r.time + gyro.clock).collect();
        for (reading, at) in flight.gyro().iter().zip(flown.derived(start, &times)?) {
            rows.begin_measurement();
            let (omega, read) = (at.of.state.omega.to_array(), reading.omega.to_array());
            let predicted = gyro.reading(omega);
            let by_gyro = self.gyro.derivatives(&gyro, omega, acceleration(flown.tensor, omega)?);
            for i in 0..CHANNELS {
                let (own, all) = rows.push((read[i] - predicted[i]) / noise);
                for (k, element) in matrix[i].iter().enumerate() {
                    let turn = element / noise;
                    let (start, inertia) = (&at.of.by_start[3 + k], &at.of.by_inertia[3 + k]);
                    add(&mut own[..3], &start[3..], turn);
                    if own.len() > 3 {
                        add(&mut own[3..], &start[..3], turn);
                    }
                    add(&mut all[..6], inertia, turn);
                    if self.drag.is_some() {
                        add(&mut all[6..12], &at.by_drag[3 + k], turn);
                    }
                }
                add(&mut all[self.gyro_from()..self.axes_from()], &by_gyro[i], 1.0 / noise);
            }
        }
        Ok(())
    }

    fn attitude_rows(
        &self,
        (flown, start): (&Flown<'_>, State),
        (flight, local): (&Flight, &[f64]),
        shared: &[f64],
        rows: &mut Rows,
    ) -> Result<(), IdentifyError> {
        let noise = self.attitude_noise;
        let times: Vec<f64> = flight.attitudes().iter().map(|r| r.time).collect();
        // Derivative of exp(θ) by the local rotation vector, in body axes.
        let by_local = right_jacobian([local[3], local[4], local[5]]);
        let (axes, by_axes) = self.tracked.map_or((Rotation::identity(), IDENTITY), |first| {
            let theta = core::array::from_fn(|k| shared[self.axes_from() + k]);
            (first * turn(theta), right_jacobian(theta))
        });
        let back = axes.inverse().matrix();
        for (reading, at) in flight.attitudes().iter().zip(flown.derived(start, &times)?) {
            rows.begin_measurement();
            // measured = R A exp(ε) with residual ε. A rotation of R A by θ in body axes is A⁻¹ θ
            // in the tracked axes.
            let predicted = at.of.state.attitude * axes;
            let left = (predicted.inverse() * reading.attitude).log().to_array();
            for i in 0..CHANNELS {
                let (own, all) = rows.push(left[i] / noise);
                for (row, element) in back[i].iter().enumerate() {
                    let turn = element / noise;
                    let start = &at.of.by_start[row];
                    add(&mut own[..3], &start[3..], turn);
                    for k in 0..3 {
                        own[3 + k] += turn * (0..3).map(|j| start[j] * by_local[j][k]).sum::<f64>();
                    }
                    add(&mut all[..6], &at.of.by_inertia[row], turn);
                    if self.drag.is_some() {
                        add(&mut all[6..12], &at.by_drag[row], turn);
                    }
                }
                if self.tracked.is_some() {
                    add(&mut all[self.axes_from()..], &by_axes[i], 1.0 / noise);
                }
            }
        }
        Ok(())
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
        let (flown, start) = (self.flown(group, shared), self.state(group, local));
        if !flight.gyro().is_empty() {
            self.gyro_rows((&flown, start), flight, shared, rows)?;
        }
        if !flight.attitudes().is_empty() {
            self.attitude_rows((&flown, start), (flight, local), shared, rows)?;
        }
        Ok(())
    }

    fn all_rows(&self, shared: &[f64], local: &[Vec<f64>]) -> Vec<Result<Rows, IdentifyError>> {
        side_by_side(self.groups(), |group| rows_of(self, group, shared, &local[group]))
    }
}

/// Adds factor × b to a.
fn add(a: &mut [f64], b: &[f64], factor: f64) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += factor * b;
    }
}

/// Returns ω̇ = I⁻¹ (I ω × ω).
fn acceleration(tensor: Six, omega: [f64; 3]) -> Result<[f64; 3], IdentifyError> {
    let tensor = Matrix3::from(matrix(tensor));
    let omega = Vector3::from(omega);
    // A singular tensor (a rod about its own axis) gives no angular acceleration.
    let solved = lu("the tensor", tensor)?.solve(&(tensor * omega).cross(&omega));
    Ok(solved.unwrap_or_default().into())
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Returns J of exp(θ + δ) = exp(θ) exp(J δ): 1 − (1 − cos θ)/θ² [θ]× + (θ − sin θ)/θ³ [θ]×².
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
