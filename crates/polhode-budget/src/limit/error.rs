//! What can be wrong with a limit.

use core::fmt;

use crate::error::BudgetError;

/// Why a limit has no answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LimitError {
    /// Neither a least nor a greatest value.
    Open {
        /// The limit.
        limit: String,
    },
    /// A number that cannot be.
    Value {
        /// The limit.
        limit: String,
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// A level of confidence that is none.
    Level {
        /// As it was given.
        value: f64,
    },
    /// No draws on a basis that limits are on, or not as many as on the other.
    Draws {
        /// The fewest and the most that there are.
        given: [usize; 2],
    },
    /// The list has no such estimate or draws.
    Budget(BudgetError),
}

impl LimitError {
    /// What its reader may do.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Open { .. } => Some("give it the least value that is allowed, the greatest, or both"),
            Self::Budget(error) => error.hint(),
            _ => None,
        }
    }
}

impl fmt::Display for LimitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Open { limit } => write!(f, "the limit \"{limit}\" allows every value"),
            Self::Value { limit, what, value, rule } => {
                write!(f, "{what} of the limit \"{limit}\" is {value}, and has to be {rule}")
            }
            Self::Level { value } => {
                write!(f, "the level of confidence is {value}, and has to be above 0 and below 1")
            }
            Self::Draws { given: [fewest, most] } => {
                write!(
                    f,
                    "{fewest} draws on one basis and {most} on another, where limits need the same on each"
                )
            }
            Self::Budget(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for LimitError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Budget(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BudgetError> for LimitError {
    fn from(error: BudgetError) -> Self {
        Self::Budget(error)
    }
}
