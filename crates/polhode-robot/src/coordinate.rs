//! The value of a joint: how it is counted, where it belongs, and which other joint decides it.

use crate::model::Name;
use crate::span::Span;

/// What a file says of a joint's value, rad or m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coordinate {
    /// A name of its own, by which it may be given beside the joint's: OpenSim's coordinates.
    pub name: Option<Name>,
    /// The value at which the child stands as [`Joint::pose`](crate::model::Joint::pose) says, and that a joint has of which no value is
    /// given: MJCF's `ref`, zero elsewhere.
    pub at_rest: f64,
    /// The least and the greatest value; either may be infinite.
    pub limits: Option<[f64; 2]>,
    /// The joint that it follows.
    pub follows: Option<Follows>,
}

/// A joint whose value is a function of another's.
///
/// y = Σ c_k (x − x₀)^k of the leader's value x.
#[derive(Clone, Debug, PartialEq)]
pub struct Follows {
    /// Where that is written.
    pub span: Span,
    /// The joint that leads; `None` if the value is c₀ and hangs on none.
    pub leader: Option<Name>,
    /// x₀
    pub reference: f64,
    /// c, from the constant up; or why they are not known.
    pub coefficients: Result<Vec<f64>, String>,
}

impl Follows {
    /// y = multiplier (x − reference) + offset
    pub(crate) fn line(span: Span, leader: Name, [multiplier, offset, reference]: [f64; 3]) -> Self {
        let is_finite = [multiplier, offset, reference].iter().all(|number| number.is_finite());
        let coefficients = if is_finite { Ok(vec![offset, multiplier]) } else { Err(NO_NUMBER.to_owned()) };
        Self { span, leader: Some(leader), reference, coefficients }
    }

    /// The follower's value.
    pub(crate) fn value(&self, leader: f64) -> Result<f64, &str> {
        let coefficients = self.coefficients.as_ref().map_err(String::as_str)?;
        let x = leader - self.reference;
        let value = coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        if value.is_finite() { Ok(value) } else { Err("its value is beyond the largest double") }
    }
}

/// Why a value is not known whose numbers are none.
pub(crate) const NO_NUMBER: &str = "a number of it is none, or not finite";

/// Limits in order: from what a file says, infinite where it says nothing.
pub(crate) fn limits(lower: Option<f64>, upper: Option<f64>) -> Option<[f64; 2]> {
    let limits = [lower.unwrap_or(f64::NEG_INFINITY), upper.unwrap_or(f64::INFINITY)];
    (limits != [f64::NEG_INFINITY, f64::INFINITY] && !limits.iter().any(|limit| limit.is_nan()))
        .then_some(limits)
}
