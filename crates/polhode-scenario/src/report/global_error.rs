//! Estimated error of a motion, for text and JSON.

use polhode::motion::{GlobalError, StateError, Trajectory};
use polhode_document::fact::{Fact, LARGEST_ATTITUDE_ERROR};
use polhode_document::number::has_digits;
use serde_json::{Value, json};

/// Returns `{"attitude_rad": …, "omega": …}`.
pub(crate) fn state_json(e: StateError) -> Value {
    json!({ "attitude_rad": e.attitude, "omega": e.omega.is_finite().then_some(e.omega) })
}

/// Returns the error at the first sample from `time` on, or else at the end; zero without an
/// estimate.
pub(crate) fn at(trajectory: &Trajectory, time: f64) -> StateError {
    let none = StateError { attitude: 0.0, omega: 0.0 };
    let Some(estimate) = trajectory.error() else { return none };
    let after = trajectory.samples().iter().position(|sample| sample.state.time >= time);
    after.and_then(|k| estimate.computation().get(k)).copied().unwrap_or_else(|| estimate.end())
}

/// Returns the error of the components of ω at the end, rad/s; zero without an estimate.
pub(crate) fn of_omega(trajectory: &Trajectory) -> f64 {
    let rate = trajectory.samples().last().map_or(0.0, |sample| sample.state.omega.norm());
    trajectory.error().map_or(0.0, |estimate| estimate.end().omega * rate)
}

/// Returns the error of the attitude at the end, rad; zero without an estimate.
pub(crate) fn of_attitude(trajectory: &Trajectory) -> f64 {
    trajectory.error().map_or(0.0, |estimate: &GlobalError| estimate.end().attitude)
}

/// Replaces the digits of a fact by words if the attitude from which it follows has no correct
/// digit; `error` is that of the attitude, rad.
pub(crate) fn known_to(error: f64, fact: Fact) -> Fact {
    if has_digits(LARGEST_ATTITUDE_ERROR, error) { fact } else { fact.without_digits() }
}
