//! Limits of a computation: tolerance and number of steps.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Largest number of steps of a motion, equal to minutes of work. More steps indicate a mistake in
/// the units.
pub(crate) const MOST_STEPS: u64 = 100_000_000;

/// Largest number of events of a motion, and of changes of a contact.
pub(crate) const MOST_EVENTS: usize = 1_000_000;

/// Tightest tolerance that f64 rounding permits.
pub const TIGHTEST_TOLERANCE: f64 = 1e-15;
/// Loosest tolerance for which the result is still a solution.
pub const LOOSEST_TOLERANCE: f64 = 1e-2;

/// Checks that the tolerance is between [`TIGHTEST_TOLERANCE`] and [`LOOSEST_TOLERANCE`].
///
/// # Errors
/// A parameter error if it is outside this range.
pub(in crate::motion) fn require_tolerance(tolerance: f64) -> Result<(), MotionError> {
    let holds = (TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&tolerance);
    require::that("the tolerance", tolerance, holds, "between 1e-15 and 1e-2")
}

/// Checks the next step before it is taken: the number of steps taken, and its length.
///
/// # Errors
/// - [`MotionError::TooManySteps`] if `taken` has reached the limit.
/// - [`MotionError::NotFinite`] if the step is NaN.
/// - [`MotionError::StepTooSmall`] if the step does not advance the time.
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
