//! Choice of the most useful next flight.

use nalgebra::DMatrix;
use polhode::motion::State;

use super::first_guess::tracked_axes;
use super::flight::Flight;
use super::model::{Reference, Tumbles};
use super::options::TumbleOptions;
use super::sensor::GyroErrors;
use super::tumble::Tumble;
use crate::error::IdentifyError;
use crate::knowledge::BodyUnits;
use crate::least_squares::{Problem, rows_of};
use crate::next::{Comparison, NextExperiment};
use crate::residuals::Noise;

/// Possible next flight: same duration, speed and sampling as an earlier one.
#[derive(Clone, Debug, PartialEq)]
pub struct NextFlight {
    /// Initial axis of rotation, a unit vector along the principal axes.
    pub about: [f64; 3],
    /// Initial ω along the sensor's axes, rad/s.
    pub omega: [f64; 3],
    /// Name of the earlier flight that it repeats, with the same added body.
    pub like: String,
}

/// Angle between a principal axis and a throw about it, rad: 10°.
const OFF: f64 = 0.175;

/// Returns directions near each principal axis, midway between two, and between all three.
fn directions() -> [[f64; 3]; 7] {
    let near = libm::cos(OFF);
    let off = libm::sin(OFF) * core::f64::consts::FRAC_1_SQRT_2;
    let (half, third) = (core::f64::consts::FRAC_1_SQRT_2, 1.0 / 3.0_f64.sqrt());
    [
        [near, off, off],
        [off, near, off],
        [off, off, near],
        [half, half, 0.0],
        [half, 0.0, half],
        [0.0, half, half],
        [third, third, third],
    ]
}

/// Ranks possible next flights, best first. `None` if the moments of the body are zero.
///
/// # Errors
/// [`IdentifyError::NotFinite`] if a covariance or derivative is not finite.
pub fn next_flight(
    flights: &[Flight],
    options: &TumbleOptions,
    found: &Tumble,
) -> Result<Option<NextExperiment<NextFlight>>, IdentifyError> {
    let Some(units) = BodyUnits::of_tensor(&found.estimate, 0, found.scale_is_known) else { return Ok(None) };
    let information = found.estimate.information()?;
    let mut next = Comparison::new(&units, &information);
    let has_gyro = flights.iter().any(|flight| !flight.gyro().is_empty());
    let has_attitudes = flights.iter().any(|flight| !flight.attitudes().is_empty());
    let noise = found.residuals.iter().find(|_| has_gyro).map_or(1.0, |test| test.noise);
    let shared: Vec<f64> = found.estimate.numbers.iter().map(|number| number.value).collect();
    for k in templates(flights) {
        let State { time, attitude, omega } = found.flights[k].state;
        let problem = Tumbles {
            flights: core::slice::from_ref(&flights[k]),
            references: vec![Reference { time, attitude }],
            gyro: if has_gyro { options.gyro } else { GyroErrors::default() },
            gyro_noise: Noise::told(noise),
            attitude_noise: options.attitude_noise.unwrap_or(1.0),
            drag: options.drag,
            tracked: (has_gyro && has_attitudes).then(|| tracked_axes(flights)).transpose()?,
        };
        for about in directions() {
            let start = core::array::from_fn(|i| {
                omega.norm() * (0..3).map(|axis| about[axis] * found.principal.axes[axis][i]).sum::<f64>()
            });
            let experiment = NextFlight { about, omega: start, like: flights[k].name().to_owned() };
            let rows = rows(&problem, &shared, start).map(|rows| rows / found.widening);
            next.add(experiment, rows);
        }
    }
    Ok(Some(next.finish()?))
}

/// Returns one flight per group with equal added body, wheels and torques: that with the median
/// number of readings.
fn templates(flights: &[Flight]) -> Vec<usize> {
    let is_like = |a: &Flight, b: &Flight| {
        a.added() == b.added() && a.wheels() == b.wheels() && a.torques() == b.torques()
    };
    let mut kinds: Vec<Vec<usize>> = Vec::new();
    for (k, flight) in flights.iter().enumerate() {
        match kinds.iter_mut().find(|kind| is_like(&flights[kind[0]], flight)) {
            Some(kind) => kind.push(k),
            None => kinds.push(vec![k]),
        }
    }
    let readings = |k: &usize| flights[*k].gyro().len() + flights[*k].attitudes().len();
    kinds
        .into_iter()
        .map(|mut kind| {
            kind.sort_by_key(readings);
            kind[kind.len() / 2]
        })
        .collect()
}

/// Returns the derivatives by the shared parameters, with the flight's local ones eliminated.
fn rows(problem: &Tumbles<'_>, shared: &[f64], omega: [f64; 3]) -> Result<DMatrix<f64>, IdentifyError> {
    let mut local = vec![0.0; problem.local(0)];
    local[..3].copy_from_slice(&omega);
    debug_assert_eq!(problem.groups(), 1);
    rows_of(problem, 0, shared, &local)?.without_own()
}
