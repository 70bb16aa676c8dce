//! The estimated error of a motion, for people and for programs.

use polhode::motion::{GlobalError, StateError, Trajectory};
use polhode_document::layout::labelled;
use polhode_document::number::error;
use serde_json::{Value, json};

/// An attitude with an error beyond this, rad, has no digit that is right: the finding `motion.error` begins there too.
pub(crate) const LARGEST_ATTITUDE: f64 = 0.1;

/// The error at the end, in a line; and what the last bit of the inputs is worth. Nothing without an estimate.
pub(crate) fn to_text(trajectory: &Trajectory) -> String {
    let Some(estimate) = trajectory.error() else { return String::new() };
    let [computation, inputs] = [estimate.end(), estimate.inputs_end()].map(in_words);
    let at_most = if estimate.is_thorough() { "" } else { "at most " };
    labelled("error", &format!("{computation}, at the end (estimate)"))
        + &labelled("", &format!("the last bit of the inputs is worth {at_most}{inputs}"))
}

/// `attitude 2.3e-14 rad, ω 1.2e-14 of itself`
fn in_words(StateError { attitude, omega }: StateError) -> String {
    format!("attitude {} rad, ω {} of itself", error(attitude), error(omega))
}

/// `null` without an estimate, and in place of what is not known.
pub(crate) fn to_json(trajectory: &Trajectory) -> Value {
    let Some(estimate) = trajectory.error() else { return Value::Null };
    let mut object = state_json(estimate.end());
    object["effort"] = if estimate.is_thorough() { "thorough" } else { "cheap" }.into();
    object["inputs"] = state_json(estimate.inputs_end());
    object
}

/// `{"attitude_rad": …, "omega": …}`
pub(crate) fn state_json(e: StateError) -> Value {
    json!({ "attitude_rad": e.attitude, "omega": e.omega.is_finite().then_some(e.omega) })
}

/// The error of a state at a time of the motion: that of the first sample from then on; none without an estimate.
pub(crate) fn at(trajectory: &Trajectory, time: f64) -> StateError {
    let none = StateError { attitude: 0.0, omega: 0.0 };
    let Some(estimate) = trajectory.error() else { return none };
    let after = trajectory.samples().iter().position(|sample| sample.state.time >= time);
    after.and_then(|k| estimate.computation().get(k)).copied().unwrap_or_else(|| estimate.end())
}

/// The error of the components of ω at the end, rad/s; zero without an estimate.
pub(crate) fn of_omega(trajectory: &Trajectory) -> f64 {
    let rate = trajectory.samples().last().map_or(0.0, |sample| sample.state.omega.norm());
    trajectory.error().map_or(0.0, |estimate| estimate.end().omega * rate)
}

/// The error of the attitude at the end, rad; zero without an estimate.
pub(crate) fn of_attitude(trajectory: &Trajectory) -> f64 {
    trajectory.error().map_or(0.0, |estimate: &GlobalError| estimate.end().attitude)
}
