//! Reasons for which a quantity has no exact formula.

use std::fmt;

/// Quantity without an exact formula, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Gap {
    /// A number with a unit.
    Number {
        /// Name of the quantity.
        what: String,
        /// Text of the value.
        written: String,
    },
    /// A formula that is not a quotient of polynomials in the symbols, their sines and cosines.
    Formula {
        /// Name of the quantity.
        what: String,
        /// Text of the formula.
        written: String,
    },
    /// Something that has no symbols.
    Kind {
        /// Name of the quantity.
        what: String,
        /// Reason.
        why: &'static str,
    },
    /// A formula whose value is not the computed one: a defect of this program.
    Differs {
        /// Name of the quantity.
        what: String,
    },
}

impl fmt::Display for Gap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { what, written } => {
                write!(f, "{what} is the number {written}; give it a name under [symbols]")
            }
            Self::Formula { what, written } => write!(f, "{what}, {written}, has no exact form here"),
            Self::Kind { what, why } => write!(f, "{what} {why}"),
            Self::Differs { what } => {
                write!(f, "the formula of {what} has another value than the computed one; please report this")
            }
        }
    }
}

impl std::error::Error for Gap {}
