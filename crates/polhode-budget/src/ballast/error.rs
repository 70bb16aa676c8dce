//! Errors of the search for ballast.

use core::fmt;

use crate::error::BudgetError;
use crate::limit::LimitError;

/// Error of a question that the search cannot answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BallastError {
    /// There is no site.
    NoSites,
    /// A number that is not allowed.
    Value {
        /// Name of the site, or `None` for a number of the question.
        site: Option<String>,
        /// Name of the number.
        what: &'static str,
        /// The number that was given.
        value: f64,
        /// Condition that it has to meet.
        rule: &'static str,
    },
    /// A limit that ballast cannot be found for.
    Limit {
        /// The limit.
        limit: String,
        /// Why not.
        why: &'static str,
    },
    /// A number that was computed from the list and its limits is NaN or infinite.
    NotFinite {
        /// Name of the number.
        quantity: &'static str,
    },
    /// A limit that says nothing.
    NotLimit(LimitError),
    /// The list has no such estimate.
    Budget(BudgetError),
}

impl fmt::Display for BallastError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSites => write!(f, "there is no site for ballast"),
            Self::Value { site, what, value, rule } => {
                let of = site.as_ref().map_or_else(String::new, |site| format!(" of the site \"{site}\""));
                write!(f, "{what}{of} is {value}, and has to be {rule}")
            }
            Self::Limit { limit, why } => {
                write!(f, "no ballast can be sought for the limit \"{limit}\": {why}")
            }
            Self::NotFinite { quantity } => write!(f, "{quantity} is not finite"),
            Self::NotLimit(error) => error.fmt(f),
            Self::Budget(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for BallastError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::NotLimit(error) => Some(error),
            Self::Budget(error) => Some(error),
            _ => None,
        }
    }
}

impl From<LimitError> for BallastError {
    fn from(error: LimitError) -> Self {
        Self::NotLimit(error)
    }
}

impl From<BudgetError> for BallastError {
    fn from(error: BudgetError) -> Self {
        Self::Budget(error)
    }
}
