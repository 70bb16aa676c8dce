//! Time from the start for which a closed form is accurate.

use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Bound on the growth of a phase error, rad per unit time. It comes from the constants that
/// multiply time, which have two or three words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Drift(pub(crate) f64);

impl Drift {
    /// Returns the time after which the phase error is [`ALLOWED`]; the largest f64 if there is no
    /// drift.
    pub(crate) fn reach(self) -> f64 {
        (ALLOWED / self.0).min(f64::MAX)
    }
}

/// Allowed phase error, rad. Beyond it a state would have fewer than six correct digits.
pub(crate) const ALLOWED: f64 = 1e-6;

/// Returns an error for the first time that is not within reach of the start, or is NaN.
pub(crate) fn require(start: &State, reach: f64, times: &[f64]) -> Result<(), MotionError> {
    match times.iter().find(|&&time| !is_within(start, reach, time)) {
        Some(&time) => Err(MotionError::BeyondReach { time, reach }),
        None => Ok(()),
    }
}

/// Returns true if a time is within reach of the start; false for NaN.
#[inline(always)]
pub(crate) fn is_within(start: &State, reach: f64, time: f64) -> bool {
    (time - start.time).abs() <= reach
}
