//! Errors of formulas as text.

use core::fmt;

use crate::rational::RationalError;

/// Error in a formula, with its column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Error kind, with its details.
    pub kind: ParseErrorKind,
    /// Column of the first wrong character, from 1.
    pub column: usize,
}

/// Kind of error in a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseErrorKind {
    /// The grammar requires something else here.
    Expected {
        /// Expected content: `a number, a symbol or (`.
        what: &'static str,
        /// Text found instead; empty at the end of the formula.
        found: String,
    },
    /// A number that cannot be represented.
    Number(RationalError),
    /// An unknown symbol.
    UnknownSymbol {
        /// Name as it is written.
        name: String,
        /// Closest declared name, if one is close.
        suggestion: Option<String>,
        /// All declared names.
        known: Vec<String>,
    },
    /// An unknown function.
    UnknownFunction {
        /// Name as it is written.
        name: String,
    },
    /// An exponent that is not a small integer.
    Exponent {
        /// Exponent as it is written.
        found: String,
    },
    /// A quotient whose denominator is zero.
    DivisionByZero,
    /// A square root of something else than a positive number.
    SquareRoot,
    /// A sine or cosine of something else than a sum of multiples of symbols.
    Angle,
    /// A formula with too many characters, nested parentheses, or terms.
    TooLarge {
        /// The limit: `1000 characters`.
        limit: &'static str,
    },
}

impl ParseError {
    /// Returns advice for the user, if there is any.
    pub fn hint(&self) -> Option<String> {
        match &self.kind {
            ParseErrorKind::UnknownSymbol { suggestion: Some(name), .. } => {
                Some(format!("did you mean `{name}`?"))
            }
            ParseErrorKind::UnknownSymbol { known, .. } if known.is_empty() => {
                Some("no symbols are declared".to_owned())
            }
            ParseErrorKind::UnknownSymbol { known, .. } => {
                Some(format!("the symbols are {}", known.join(", ")))
            }
            ParseErrorKind::UnknownFunction { name } => {
                Some(format!("the functions are sqrt, sin and cos; a product is written {name}*(…)"))
            }
            ParseErrorKind::Expected { found, .. } if found == "*" => {
                Some("a power is written b^2".to_owned())
            }
            ParseErrorKind::Expected { found, .. } if found == "," => {
                Some("the decimal sign is a point".to_owned())
            }
            ParseErrorKind::Expected { found, .. } if found == "^" => {
                Some("write parentheses around a power of a power: (b^2)^3".to_owned())
            }
            ParseErrorKind::Expected { what, found } if what.starts_with("an operator") => {
                let starts = found.chars().next().filter(|c| c.is_alphanumeric() || matches!(c, '(' | '.'));
                starts.map(|_| format!("a product is written with *: …*{found}"))
            }
            ParseErrorKind::Exponent { .. } => Some("write a square root of a number as sqrt(3)".to_owned()),
            ParseErrorKind::SquareRoot => {
                Some("use a symbol for the root, and its square where it is needed".to_owned())
            }
            ParseErrorKind::Angle => {
                Some("declare the angle as a symbol: sin(alpha), cos(2*alpha - beta)".to_owned())
            }
            _ => None,
        }
    }
}

impl fmt::Display for ParseErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expected { what, found } if found.is_empty() => {
                write!(f, "expected {what}, found the end of the formula")
            }
            Self::Expected { what, found } => write!(f, "expected {what}, found `{found}`"),
            Self::Number(error) => error.fmt(f),
            Self::UnknownSymbol { name, .. } => write!(f, "unknown symbol `{name}`"),
            Self::UnknownFunction { name } => write!(f, "unknown function `{name}`"),
            Self::Exponent { found } => {
                write!(f, "the exponent `{found}` is not an integer from −12 to 12")
            }
            Self::DivisionByZero => write!(f, "the divisor is zero"),
            Self::SquareRoot => write!(f, "sqrt takes a positive number without large prime factors"),
            Self::Angle => write!(f, "sin and cos take sums of symbols with integer factors up to 16"),
            Self::TooLarge { limit } => write!(f, "a formula has at most {limit}"),
        }
    }
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.kind)
    }
}

impl core::error::Error for ParseError {}
