//! Limits on what a parts list comes to.

mod answer;
mod axis;
mod error;
mod measure;
mod share;
mod undefined;

pub use answer::{AllMet, Answer, Evidence, LimitAnswers, Margin, Trial};
pub(crate) use axis::DIRECTIONS;
pub use axis::PrincipalAxis;
pub use error::LimitError;
pub(crate) use measure::across_axes;
pub use measure::{About, Measure};
pub use share::Share;
pub use undefined::Undefined;

use crate::growth::Basis;

/// What a number of the whole has to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// What to call it.
    pub name: String,
    /// Of what it is.
    pub of: Measure,
    /// The least that is allowed, in the unit of the measure.
    pub least: Option<f64>,
    /// The most that is allowed.
    pub most: Option<f64>,
    /// Which mass of the parts counts.
    pub basis: Basis,
}

impl Limit {
    /// Whether the limit says something that a body can keep or break.
    ///
    /// # Errors
    /// [`LimitError`] that says what it does not.
    pub fn check(&self) -> Result<(), LimitError> {
        let wrong = |what, value, rule| LimitError::Value { limit: self.name.clone(), what, value, rule };
        let (Some(least), Some(most)) =
            (self.least.or(self.most.map(|_| f64::MIN)), self.most.or(self.least.map(|_| f64::MAX)))
        else {
            return Err(LimitError::Open { limit: self.name.clone() });
        };
        for (what, value) in [("the least value", least), ("the greatest value", most)] {
            if !value.is_finite() {
                return Err(wrong(what, value, "finite"));
            }
        }
        if least > most {
            return Err(wrong("the least value", least, "no more than the greatest"));
        }
        self.of.check().map_err(|(what, value, rule)| wrong(what, value, rule))
    }

    /// Whether a value is within the limit.
    pub fn is_met(&self, value: f64) -> bool {
        self.least.is_none_or(|least| value >= least) && self.most.is_none_or(|most| value <= most)
    }
}
