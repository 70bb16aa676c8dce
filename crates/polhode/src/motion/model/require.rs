//! Checks of parameters.

use crate::math::vector::{Direction, Vector};
use crate::motion::error::MotionError;

/// Checks that a number is finite.
///
/// # Errors
/// [`MotionError::NonFiniteParameter`] for NaN and infinities.
pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    if value.is_finite() { Ok(()) } else { Err(MotionError::NonFiniteParameter { parameter, value }) }
}

/// Checks that a number is positive.
///
/// # Errors
/// [`MotionError::NonPositiveParameter`] unless it is above zero and finite.
pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    let holds = value > 0.0 && value.is_finite();
    if holds { Ok(()) } else { Err(MotionError::NonPositiveParameter { parameter, value }) }
}

/// Checks that a number is not negative.
///
/// # Errors
/// [`MotionError::NegativeParameter`] unless it is zero or positive, and finite.
pub(crate) fn not_negative(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    let holds = value >= 0.0 && value.is_finite();
    if holds { Ok(()) } else { Err(MotionError::NegativeParameter { parameter, value }) }
}

/// Returns the unit vector along a vector.
///
/// # Errors
/// [`MotionError::NoDirection`] if the vector is zero or not finite.
pub(crate) fn direction<Q, F>(parameter: &'static str, v: Vector<Q, F>) -> Result<Direction<F>, MotionError> {
    v.direction().ok_or(MotionError::NoDirection { parameter, length: v.norm() })
}

/// Checks a condition; `rule` states it in words.
///
/// # Errors
/// [`MotionError::ParameterOutOfRange`] unless the condition holds.
pub(crate) fn that(
    parameter: &'static str,
    value: f64,
    holds: bool,
    rule: &'static str,
) -> Result<(), MotionError> {
    if holds { Ok(()) } else { Err(MotionError::ParameterOutOfRange { parameter, value, rule }) }
}
