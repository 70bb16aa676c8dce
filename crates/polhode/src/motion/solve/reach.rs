//! How far in time a closed form is right.

use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// How much a phase may be wrong by, rad, for every unit of time: the constants that time multiplies have two words or three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Drift(pub(crate) f64);

impl Drift {
    /// The time in which it comes to [`ALLOWED`]; the longest there is, of what does not drift.
    pub(crate) fn reach(self) -> f64 {
        (ALLOWED / self.0).min(f64::MAX)
    }
}

/// Of an angle, rad: beyond, a state would have fewer than six digits.
pub(crate) const ALLOWED: f64 = 1e-6;

/// Each of the times is within reach of the start; not so NaN.
pub(crate) fn require(start: &State, reach: f64, times: &[f64]) -> Result<(), MotionError> {
    match times.iter().find(|&&time| !is_within(start, reach, time)) {
        Some(&time) => Err(MotionError::BeyondReach { time, reach }),
        None => Ok(()),
    }
}

/// Negated by NaN.
#[inline(always)]
pub(crate) fn is_within(start: &State, reach: f64, time: f64) -> bool {
    (time - start.time).abs() <= reach
}
