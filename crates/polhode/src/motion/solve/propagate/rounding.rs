//! What of a torque is rounding.

/// What rounding leaves of a torque along an axis along which there is none.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A moment below this part of the greatest is that of a needle.
pub(crate) const THIN: f64 = 1e-2;
