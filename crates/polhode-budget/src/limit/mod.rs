//! Limits on the mass properties of a parts list.

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

/// Range that a quantity of the whole has to be in.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    pub name: String,
    /// Limited quantity of the whole.
    pub of: Measure,
    /// Least allowed value, in the unit of the measure.
    pub least: Option<f64>,
    /// Greatest allowed value, in the unit of the measure.
    pub most: Option<f64>,
    /// Mass basis of the parts.
    pub basis: Basis,
}

impl Limit {
    /// Checks that the limit has a bound and valid numbers.
    ///
    /// # Errors
    /// [`LimitError`] that names the invalid item.
    pub fn check(&self) -> Result<(), LimitError> {
        let wrong = |what, value, rule| LimitError::Value { limit: self.name.clone(), what, value, rule };
        let (Some(least), Some(most)) =
            (self.least.or(self.most.map(|_| f64::MIN)), self.most.or(self.least.map(|_| f64::MAX)))
        else {
            return Err(LimitError::Open { limit: self.name.clone() });
        };
        for (what, value) in [("the lower bound", least), ("the upper bound", most)] {
            if !value.is_finite() {
                return Err(wrong(what, value, "finite"));
            }
        }
        if least > most {
            return Err(wrong("the lower bound", least, "at most the upper bound"));
        }
        self.of.check().map_err(|(what, value, rule)| wrong(what, value, rule))
    }

    /// Returns true if a value is within the limit.
    pub fn is_met(&self, value: f64) -> bool {
        self.least.is_none_or(|least| value >= least) && self.most.is_none_or(|most| value <= most)
    }
}
