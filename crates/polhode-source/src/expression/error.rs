//! Why a text is not a formula.

use std::error::Error;
use std::fmt;

use super::function;
use crate::text::{counted, cut};
use crate::unit::{Dimension, UnitError};

/// Why a text is not a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpressionError {
    /// What is wrong.
    pub kind: ExpressionErrorKind,
    /// The character, from 1, that it starts at.
    pub column: usize,
}

/// What is wrong with a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ExpressionErrorKind {
    /// Something else stands where the grammar has its place.
    Expected {
        /// What belongs there: `"a number, a name or ("`.
        what: &'static str,
        /// What stands there; empty at the end of the text.
        found: String,
    },
    /// A number that f64 does not hold.
    Number {
        /// The number.
        found: String,
    },
    /// A name that is no variable.
    UnknownVariable {
        /// The name.
        name: String,
        /// What was probably meant.
        suggestion: Option<String>,
        /// All variables that there are here.
        known: Vec<String>,
    },
    /// A name that is no function.
    UnknownFunction {
        /// The name.
        name: String,
        /// What was probably meant.
        suggestion: Option<&'static str>,
    },
    /// A function with too few or too many arguments.
    Arguments {
        /// The function.
        function: &'static str,
        /// How many it takes.
        takes: usize,
        /// How many are there.
        given: usize,
    },
    /// A comparison of a comparison: `0 < x < 1`.
    ChainedComparison,
    /// More characters than a formula may have.
    TooLong {
        /// The most that it may have.
        most: usize,
    },
    /// A number whose unit cannot be read.
    Unit(UnitError),
    /// Two that have to be of the same dimension and are not.
    Unequal {
        /// What joins them.
        operation: &'static str,
        /// What the first measures.
        left: Dimension,
        /// What the second measures.
        right: Dimension,
    },
    /// Something else where a plain number belongs.
    NotPlain {
        /// What takes it.
        function: &'static str,
        /// What it measures.
        found: Dimension,
    },
    /// A power that leaves no whole powers of kg, m and s.
    BrokenPower {
        /// What takes it.
        function: &'static str,
        /// What is raised.
        found: Dimension,
    },
    /// An angle that is compared with a number without a unit.
    BareAngle {
        /// What compares them.
        operation: &'static str,
        /// The number.
        found: String,
    },
    /// A value that is neither true nor false, where a condition belongs.
    NoCondition,
    /// A value of another dimension than its place asks for.
    Value {
        /// What it measures.
        found: Dimension,
        /// What belongs there.
        expected: Dimension,
    },
}

impl ExpressionError {
    /// What to write instead, where there is something to say.
    pub fn hint(&self) -> Option<String> {
        use ExpressionErrorKind as Kind;
        match &self.kind {
            Kind::UnknownVariable { suggestion: Some(name), .. } => Some(format!("did you mean {name}?")),
            Kind::UnknownVariable { known, .. } if known.is_empty() => {
                Some("there are no variables here".to_owned())
            }
            Kind::UnknownVariable { known, .. } => Some(format!("the variables are {}", known.join(", "))),
            Kind::UnknownFunction { suggestion: Some(name), .. } => Some(format!("did you mean {name}?")),
            Kind::UnknownFunction { name, .. } => Some(format!(
                "there are {}; a product is written {name}*(…)",
                function::FUNCTIONS.map(|f| f.name).join(", ")
            )),
            Kind::ChainedComparison => Some("write 0 < x and x < 1".to_owned()),
            Kind::BareAngle { found, .. } => Some(format!("write {found} deg or {found} rad")),
            Kind::NoCondition => Some(
                "a condition is a comparison, such as end_time_s < 30 s, or several with and, or".to_owned(),
            ),
            Kind::Unit(error) => error.hint(),
            Kind::Unequal { left, right, .. } if *left == Dimension::NONE => {
                example(*right).map(|unit| with_unit(&unit))
            }
            Kind::Unequal { left, right, .. } if *right == Dimension::NONE => {
                example(*left).map(|unit| with_unit(&unit))
            }
            Kind::NotPlain { function: "if", .. } => {
                Some("a condition is a comparison, such as t < 3 s".to_owned())
            }
            Kind::NotPlain { found, .. } | Kind::BrokenPower { found, .. } => {
                example(*found).map(|unit| format!("divide by a quantity like it, such as {unit}"))
            }
            Kind::Value { found, expected } if *found == Dimension::NONE => {
                example(*expected).map(|unit| with_unit(&unit))
            }
            Kind::Value { found, expected } => example(expected.times(found.without_angle(), -1))
                .map(|unit| format!("a factor is missing, such as {unit}")),
            Kind::Expected { found, .. } if found == "[" => Some(
                "a unit stands after a number, where dimensions are checked; else numbers are in SI"
                    .to_owned(),
            ),
            Kind::Expected { found, .. } if found == "*" => Some("a power is written x^2".to_owned()),
            Kind::Expected { found, .. } if found == "=" || found == "!" || found == "&" || found == "|" => {
                Some("there are <, <=, > and >=, and, or, and if(condition, then, else)".to_owned())
            }
            Kind::Expected { what, found } if what.starts_with("an operator") => match found.chars().next() {
                Some(c) if c.is_alphanumeric() || c == '(' || c == '.' => {
                    Some(format!("a product is written with *: …*{found}"))
                }
                Some(',') => Some("the decimal sign is a point".to_owned()),
                _ => None,
            },
            _ => None,
        }
    }
}

impl fmt::Display for ExpressionErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expected { what, found } if found.is_empty() => {
                write!(f, "expected {what}, found the end of the formula")
            }
            Self::Expected { what, found } => write!(f, "expected {what}, found {:?}", cut(found)),
            Self::Number { found } => write!(f, "{} is beyond the range of a double", cut(found)),
            Self::UnknownVariable { name, .. } => write!(f, "there is no variable {}", cut(name)),
            Self::UnknownFunction { name, .. } => write!(f, "there is no function {}", cut(name)),
            Self::Arguments { function, takes, given } => {
                write!(f, "{function} takes {}, not {given}", counted(*takes, "argument"))
            }
            Self::TooLong { most } => write!(f, "a formula has up to {most} characters"),
            Self::Unit(error) => error.fmt(f),
            Self::Unequal { operation, left, right } => write!(f, "{operation} joins {left} and {right}"),
            Self::NotPlain { function, found } => write!(f, "{function} takes a plain number, not {found}"),
            Self::BrokenPower { function, found } => {
                write!(f, "{function} of {found} leaves no whole powers of kg, m and s")
            }
            Self::Value { found, expected } => write!(f, "the value is {found}, where {expected} belongs"),
            Self::BareAngle { operation, found } => {
                write!(f, "{operation} compares an angle with {found}, which has no unit")
            }
            Self::NoCondition => write!(f, "this is a number, where a condition belongs"),
            Self::ChainedComparison => write!(f, "a comparison cannot be compared"),
        }
    }
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.kind)
    }
}

impl Error for ExpressionError {}

/// A quantity of a dimension as a formula has it.
fn example(dimension: Dimension) -> Option<String> {
    let text = dimension.with_angle().example().filter(|_| dimension.without_angle() != Dimension::NONE)?;
    text.split_once(' ').map(|(number, unit)| format!("{number}[{unit}]"))
}

fn with_unit(example: &str) -> String {
    format!("a number has its unit behind it, such as {}", example.replace('[', " ").replace(']', ""))
}
