//! Conditions on the inputs that are checked before a motion begins.

use super::limits::MOST_STEPS;
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// Checks that the times are finite and in ascending order, not before `start`.
///
/// # Errors
/// A parameter error ([`MotionError::is_parameter`]) for the first time that is not.
pub(crate) fn require_ascending(start: f64, times: &[f64]) -> Result<(), MotionError> {
    let mut last = start;
    for &value in times {
        let rule = "finite, and not before the time that precedes it";
        require::that("the time", value, value.is_finite() && value >= last, rule)?;
        last = value;
    }
    Ok(())
}

/// Checks the number of pulses between two times. A step ends at the beginning of every pulse, so
/// the number of pulses is limited like that of steps.
///
/// # Errors
/// [`MotionError::TooManyPulses`] if the pulses of the wheels' motors and of all torques that do
/// not stay off exceed the limit.
pub(crate) fn require_few_pulses(
    rotor: &Rotor,
    torques: &[TorqueModel],
    stays_off: &dyn Fn(&usize) -> bool,
    [start, end]: [f64; 2],
) -> Result<(), MotionError> {
    let acting = torques.iter().enumerate().filter(|(k, _)| !stays_off(k));
    let of_torques = acting.map(|(k, torque)| (Some(k), torque.pulses_between(start, end)));
    let of_wheels = rotor.wheels().iter().map(|wheel| (None, wheel.pulses_between(start, end)));
    let (mut sum, mut densest) = (0.0, (None, 0.0));
    for (torque, pulses) in of_torques.chain(of_wheels) {
        sum += pulses;
        if pulses > densest.1 {
            densest = (torque, pulses);
        }
    }
    if sum <= MOST_STEPS as f64 {
        return Ok(());
    }
    Err(MotionError::TooManyPulses { torque: densest.0, count: sum, most: MOST_STEPS })
}

/// Checks that the start is finite, and the torques at the start. The start is an input, so the
/// error names the input and not the computation.
pub(crate) fn require_finite(
    rotor: &Rotor,
    torques: &[TorqueModel],
    switched_off: &[usize],
    start: &State,
) -> Result<(), MotionError> {
    let (energy, momentum) = (rotor.kinetic_energy(start.omega), rotor.angular_momentum(start.omega).norm());
    for (what, value) in [
        ("the start's time", start.time),
        ("the start's attitude", start.attitude.quaternion().iter().sum()),
        ("the start's angular velocity", start.omega.norm()),
        ("the start's kinetic energy", energy),
        ("the start's angular momentum", momentum),
    ] {
        require::finite(what, value)?;
    }
    for (k, torque) in torques.iter().enumerate() {
        // A torque that begins later may be NaN or infinite already now.
        let model = torque.acting(start.time).unwrap_or(torque);
        if !model.scale(rotor, start).is_finite() && !switched_off.contains(&k) {
            let value = model.torque(rotor, start).to_array();
            return Err(MotionError::TorqueNotFinite { torque: k, value });
        }
    }
    Ok(())
}
