//! Couplings between joint values, and limits of joint values.

use crate::model::{Follows, Name, Span};

impl Follows {
    /// Returns the linear coupling y = multiplier (x − reference) + offset.
    pub(crate) fn line(span: Span, leader: Name, [multiplier, offset, reference]: [f64; 3]) -> Self {
        let is_finite = [multiplier, offset, reference].iter().all(|number| number.is_finite());
        let coefficients = if is_finite { Ok(vec![offset, multiplier]) } else { Err(NO_NUMBER.to_owned()) };
        Self { span, leader: Some(leader), reference, coefficients }
    }

    /// Returns the follower's value for a value of the leader.
    pub(crate) fn value(&self, leader: f64) -> Result<f64, &str> {
        let coefficients = self.coefficients.as_ref().map_err(String::as_str)?;
        let x = leader - self.reference;
        let value = coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        if value.is_finite() { Ok(value) } else { Err("its value is too large for a double") }
    }
}

/// Reason for an unknown value: one of its numbers cannot be read or is not finite.
pub(crate) const NO_NUMBER: &str = "one of its numbers is invalid or not finite";

/// Returns lower and upper limit, infinite if the file states none. Returns `None` if both are
/// infinite or one is NaN.
pub(crate) fn limits(lower: Option<f64>, upper: Option<f64>) -> Option<[f64; 2]> {
    let limits = [lower.unwrap_or(f64::NEG_INFINITY), upper.unwrap_or(f64::INFINITY)];
    (limits != [f64::NEG_INFINITY, f64::INFINITY] && !limits.iter().any(|limit| limit.is_nan()))
        .then_some(limits)
}
