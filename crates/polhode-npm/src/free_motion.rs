//! Free motion of a body with given moments, in closed form.

use polhode::body::InertiaTensor;
use polhode::math::{AngularVelocity, Attitude, Body};
use polhode::motion::{FreeMotion, MotionError, State};
use polhode::observe::FreeRegime;
use polhode_document::VERSION;
use polhode_source::Failure;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::outcome::Outcome;

/// JSON schema of a request of `free_motion`.
pub const REQUEST_SCHEMA: &str = include_str!("../schema/free-motion/request.json");

/// JSON schema of the value of an answer.
pub const REPORT_SCHEMA: &str = include_str!("../schema/free-motion/report.json");

/// Request for the torque-free motion of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    /// Moments of inertia along the body axes, which are principal, kg·m².
    moments: [f64; 3],
    /// Angular velocity at time 0, body axes, rad/s.
    omega: [f64; 3],
    /// Attitude at time 0 as a unit quaternion (w, x, y, z), from body to space.
    #[serde(default = "identity")]
    attitude: [f64; 4],
    /// Times of the states, s.
    times: Vec<f64>,
}

fn identity() -> [f64; 4] {
    [1.0, 0.0, 0.0, 0.0]
}

/// Computes the states and constants of a free motion.
pub(crate) fn outcome(request: &Request) -> Outcome {
    computed(request).into()
}

fn computed(request: &Request) -> Result<Outcome, Failure> {
    let refused = |reason: String, hint: Option<&str>| Failure::usage(reason, hint.unwrap_or_default());
    let failed = |error: MotionError| refused(error.to_string(), error.hint());
    InertiaTensor::<Body>::diagonal(request.moments)
        .map_err(|error| refused(format!("moments: {error}"), error.hint()))?;
    let attitude = Attitude::from_quaternion(request.attitude)
        .map_err(|error| refused(format!("attitude: {error}"), Some("the identity is [1, 0, 0, 0]")))?;
    let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(request.omega) };
    let motion = FreeMotion::of_moments(request.moments, start).map_err(failed)?;
    if !(motion.kinetic_energy().is_finite() && motion.momentum().norm().is_finite()) {
        let reason = "the energy or |L| of this motion is too large for a double (at most 1.8e308)";
        return Err(Failure::usage(reason, "check the units and the exponents"));
    }
    motion.require(&request.times).map_err(failed)?;
    // One state after the other: the kernel for many would make the module a tenth larger.
    let states: Vec<State> = request.times.iter().map(|time| motion.at(*time)).collect();
    let regime = FreeRegime::of_motion(&motion);
    let count = states.len();
    let value = json!({
        "polhode": VERSION,
        "regime": regime.regime.name(),
        "period_s": regime.period,
        "flip_interval_s": regime.flip_interval,
        "growth_rate_per_s": regime.growth_rate,
        "precession_rate_rad_s": finite(motion.precession_rate()),
        "nutation_range_rad": motion.nutation_range().map(finite),
        "kinetic_energy_j": motion.kinetic_energy(),
        "momentum_kg_m2_s": motion.momentum().norm(),
        "momentum_space_kg_m2_s": motion.momentum().to_array(),
        "times_s": { "f64": [0, count] },
        "omega_body_rad_s": { "f64": [count, 3 * count] },
        "attitude_wxyz": { "f64": [4 * count, 4 * count] },
    });
    let omega = states.iter().flat_map(|state| state.omega.to_array());
    let numbers = request.times.iter().copied().chain(omega).chain(continuous(attitude, &states));
    Ok(Outcome::Done { value, numbers: numbers.collect() })
}

/// Returns a number, or `None` if it does not exist.
fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

/// Returns the quaternions of the states, each with the sign that is closer to the one before.
fn continuous(start: Attitude, states: &[State]) -> impl Iterator<Item = f64> {
    let mut before = start.quaternion();
    states.iter().flat_map(move |state| {
        let wxyz = state.attitude.quaternion();
        let along: f64 = before.iter().zip(wxyz).map(|(a, b)| a * b).sum();
        before = if along < 0.0 { wxyz.map(|component| -component) } else { wxyz };
        before
    })
}
