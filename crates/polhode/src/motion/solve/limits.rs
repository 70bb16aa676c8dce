//! Limits of a computation: its tolerance, and the number of its steps.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Largest number of steps of a motion: minutes of work. More is a mistake in the units.
pub(crate) const MOST_STEPS: u64 = 100_000_000;

/// Largest number of events of a motion, and of the changes of a contact.
pub(crate) const MOST_EVENTS: usize = 1_000_000;

/// The tightest tolerance that rounding leaves room for.
pub const TIGHTEST_TOLERANCE: f64 = 1e-15;
/// The loosest tolerance that still means a solution.
pub const LOOSEST_TOLERANCE: f64 = 1e-2;

/// # Errors
/// A parameter's error if it is outside these.
pub(in crate::motion) fn require_tolerance(tolerance: f64) -> Result<(), MotionError> {
    let holds = (TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&tolerance);
    require::that("the tolerance", tolerance, holds, "between 1e-15 and 1e-2")
}

/// Refuses the step that may be taken next, from a time, where it is the one too many or leads nowhere.
///
/// # Errors
/// [`MotionError::TooManySteps`], [`MotionError::NotFinite`], [`MotionError::StepTooSmall`].
pub(in crate::motion) fn require_step(from: f64, step: f64, taken: u64) -> Result<(), MotionError> {
    if taken == MOST_STEPS {
        return Err(MotionError::TooManySteps { time: from, step, most: MOST_STEPS });
    }
    if step.is_nan() {
        return Err(MotionError::NotFinite { time: from });
    }
    if !(from + step > from) {
        return Err(MotionError::StepTooSmall { time: from, step });
    }
    Ok(())
}
