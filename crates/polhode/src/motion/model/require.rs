//! What numbers have to be.

use crate::math::vector::{Direction, Vector};
use crate::motion::error::MotionError;

/// # Errors
/// [`MotionError::NonFiniteParameter`] of NaN and infinities.
pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    if value.is_finite() { Ok(()) } else { Err(MotionError::NonFiniteParameter { parameter, value }) }
}

/// # Errors
/// [`MotionError::NonPositiveParameter`] unless it is above zero, and finite.
pub(crate) fn positive(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    let holds = value > 0.0 && value.is_finite();
    if holds { Ok(()) } else { Err(MotionError::NonPositiveParameter { parameter, value }) }
}

/// # Errors
/// [`MotionError::NegativeParameter`] unless it is zero or more, and finite.
pub(crate) fn not_negative(parameter: &'static str, value: f64) -> Result<(), MotionError> {
    let holds = value >= 0.0 && value.is_finite();
    if holds { Ok(()) } else { Err(MotionError::NegativeParameter { parameter, value }) }
}

/// A vector's unit vector.
///
/// # Errors
/// [`MotionError::NoDirection`] of what is zero or not finite.
pub(crate) fn direction<Q, F>(parameter: &'static str, v: Vector<Q, F>) -> Result<Direction<F>, MotionError> {
    v.direction().ok_or(MotionError::NoDirection { parameter, length: v.norm() })
}

/// # Errors
/// [`MotionError::ParameterOutOfRange`] unless the rule holds.
pub(crate) fn that(
    parameter: &'static str,
    value: f64,
    holds: bool,
    rule: &'static str,
) -> Result<(), MotionError> {
    if holds { Ok(()) } else { Err(MotionError::ParameterOutOfRange { parameter, value, rule }) }
}
