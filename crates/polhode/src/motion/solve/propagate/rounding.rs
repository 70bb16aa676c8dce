//! Thresholds for torques that are only rounding.

/// Relative rounding error of a torque about an axis about which the true torque is zero.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Threshold of the ratio of a moment to the greatest: below it the body counts as a needle.
pub(crate) const THIN: f64 = 1e-2;
