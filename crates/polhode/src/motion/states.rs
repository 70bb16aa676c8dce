//! The states of a motion, and nothing else.

use super::error::MotionError;
use super::free::FreeMotion;
use super::propagate::stepper::{Rule, Stepper};
use super::rotor::Rotor;
use super::state::State;
use super::torque::TorqueModel;
use super::trajectory::{Method, require_ascending, require_finite, require_patience};

/// The states at each of `times` (ascending, s, none before the start), as [`Trajectory::compute`](crate::Trajectory::compute) finds
/// them, without the evidence of their error: what a simulation's inner loop wants.
///
/// # Errors
/// As [`Trajectory::compute`](crate::Trajectory::compute).
///
/// ```
/// use polhode::*;
/// let inertia = InertiaTensor::diagonal([1.0, 1.0, 0.5])?;
/// let top = Rotor::pivoted(&MassProperties::new(1.0, Position::new(0.0, 0.0, 0.1), inertia)?, Position::ZERO);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.0, 9.0) };
/// let gravity = [TorqueModel::Gravity(UniformGravity::STANDARD)];
/// let states = states_at(&top, &gravity, start, &[0.5, 1.0], Method::Auto, 1e-13)?;
/// assert!((states[1].omega.z - 9.0).abs() < 1e-12); // a symmetric top keeps its spin
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn states_at(
    rotor: &Rotor,
    torques: &[TorqueModel],
    start: State,
    times: &[f64],
    method: Method,
    tolerance: f64,
) -> Result<Vec<State>, MotionError> {
    require_ascending(start.time, times)?;
    require_finite(rotor, torques, &start)?;
    let is_free = torques.is_empty() && rotor.wheels().is_empty();
    match method {
        Method::Auto | Method::Exact if is_free => Ok(FreeMotion::of(rotor, start)?.at_times(times)),
        Method::Exact => Err(MotionError::NoClosedForm { why: "a torque acts on the body" }),
        Method::Dop853 => integrated(Rule::Dop853, rotor, torques, start, times, tolerance),
        Method::Auto | Method::Taylor => integrated(Rule::Taylor, rotor, torques, start, times, tolerance),
    }
}

fn integrated(
    rule: Rule,
    rotor: &Rotor,
    torques: &[TorqueModel],
    start: State,
    times: &[f64],
    tolerance: f64,
) -> Result<Vec<State>, MotionError> {
    let mut stepper = Stepper::new(rule, rotor, torques, start, tolerance, false)?;
    let end = times.last().copied().unwrap_or(start.time);
    let mut states = Vec::with_capacity(times.len());
    for &time in times {
        while stepper.time() < time {
            stepper.step(end)?;
            require_patience(&stepper, end)?;
        }
        let there = if time == stepper.time() { stepper.now() } else { stepper.at(time) };
        states.push(there.state);
    }
    Ok(states)
}
