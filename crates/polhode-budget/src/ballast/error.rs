//! Why ballast cannot be looked for, or was not found.

use core::fmt;

use crate::error::BudgetError;
use crate::limit::LimitError;

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BallastError {
    /// There is no site.
    NoSites,
    /// This was built without the feature `ballast`.
    NoSolver,
    /// A number of a site that cannot be.
    Value {
        /// The site.
        site: String,
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// A number of the question that cannot be.
    Question {
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
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
            Self::NoSolver => {
                write!(f, "this program was built without the feature `ballast`, and seeks none")
            }
            Self::Value { site, what, value, rule } => {
                write!(f, "{what} of the site \"{site}\" is {value}, and has to be {rule}")
            }
            Self::Question { what, value, rule } => write!(f, "{what} is {value}, and has to be {rule}"),
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
