//! Errors of parsing and checking a formula.

use std::error::Error;
use std::fmt;

use super::function;
use crate::text::{counted, cut};
use crate::unit::{Dimension, UnitError};

/// Error in a formula, with its column.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpressionError {
    /// Error kind, with its details.
    pub kind: ExpressionErrorKind,
    /// Column of the first wrong character, from 1.
    pub column: usize,
}

/// Kind of error in a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ExpressionErrorKind {
    /// The grammar requires something else here.
    Expected {
        /// Expected content: `"a number, a name or ("`.
        what: &'static str,
        /// Text found instead; empty at the end of the text.
        found: String,
    },
    /// A number outside the range of `f64`.
    Number {
        /// The number as written.
        found: String,
    },
    /// An unknown variable.
    UnknownVariable {
        /// The unknown name.
        name: String,
        /// Closest known name, if one is close.
        suggestion: Option<String>,
        /// All variables of this formula.
        known: Vec<String>,
    },
    /// An unknown function.
    UnknownFunction {
        /// The unknown name.
        name: String,
        /// Closest known name, if one is close.
        suggestion: Option<&'static str>,
    },
    /// Wrong number of arguments of a function.
    Arguments {
        /// Name of the function.
        function: &'static str,
        /// Number of arguments required.
        takes: usize,
        /// Number of arguments found.
        given: usize,
    },
    /// A comparison of a comparison: `0 < x < 1`.
    ChainedComparison,
    /// A formula with too many characters.
    TooLong {
        /// Largest number of characters.
        most: usize,
    },
    /// A number with an invalid unit.
    Unit(UnitError),
    /// Two operands of different dimensions.
    Unequal {
        /// The operator or function that joins them.
        operation: &'static str,
        /// Dimension of the first operand.
        left: Dimension,
        /// Dimension of the second operand.
        right: Dimension,
    },
    /// A dimensional value in a place that requires a plain number.
    NotPlain {
        /// Function or operator that requires the plain number.
        function: &'static str,
        /// Dimension of the value.
        found: Dimension,
    },
    /// A power with fractional exponents of kg, m or s.
    BrokenPower {
        /// Function or operator that raises the value.
        function: &'static str,
        /// Dimension of the base.
        found: Dimension,
    },
    /// An angle compared with a number without a unit.
    BareAngle {
        /// Operator that joins them.
        operation: &'static str,
        /// The number.
        found: String,
    },
    /// A number in a place that requires a condition.
    NoCondition,
    /// A value of another dimension than required.
    Value {
        /// Dimension of the value.
        found: Dimension,
        /// Required dimension.
        expected: Dimension,
    },
}

impl ExpressionError {
    /// Returns advice for the user, if there is any.
    pub fn hint(&self) -> Option<String> {
        use ExpressionErrorKind as Kind;
        match &self.kind {
            Kind::UnknownVariable { suggestion: Some(name), .. } => Some(format!("did you mean {name}?")),
            Kind::UnknownVariable { known, .. } if known.is_empty() => {
                Some("this formula has no variables".to_owned())
            }
            Kind::UnknownVariable { known, .. } => Some(format!("the variables are {}", known.join(", "))),
            Kind::UnknownFunction { suggestion: Some(name), .. } => Some(format!("did you mean {name}?")),
            Kind::UnknownFunction { name, .. } => Some(format!(
                "the functions are {}; a product is written {name}*(…)",
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
                example(*found).map(|unit| format!("divide by a quantity of the same dimension, such as {unit}"))
            }
            Kind::Value { found, expected } if *found == Dimension::NONE => {
                example(*expected).map(|unit| with_unit(&unit))
            }
            Kind::Value { found, expected } => example(expected.times(found.without_angle(), -1))
                .map(|unit| format!("a factor is missing, such as {unit}")),
            Kind::Expected { found, .. } if found == "[" => Some(
                "write a unit only after a number, and only where dimensions are checked; otherwise numbers are in SI units"
                    .to_owned(),
            ),
            Kind::Expected { found, .. } if found == "*" => Some("a power is written x^2".to_owned()),
            Kind::Expected { found, .. } if found == "=" || found == "!" || found == "&" || found == "|" => {
                Some("the operators are <, <=, > and >=, and, or, and if(condition, then, else)".to_owned())
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
            Self::UnknownVariable { name, .. } => write!(f, "unknown variable {}", cut(name)),
            Self::UnknownFunction { name, .. } => write!(f, "unknown function {}", cut(name)),
            Self::Arguments { function, takes, given } => {
                write!(f, "{function} takes {}, not {given}", counted(*takes, "argument"))
            }
            Self::TooLong { most } => write!(f, "a formula has up to {most} characters"),
            Self::Unit(error) => error.fmt(f),
            Self::Unequal { operation, left, right } => {
                write!(f, "{operation} of {left} and {right}: the dimensions differ")
            }
            Self::NotPlain { function, found } => {
                write!(f, "{function} needs a number without unit, not {found}")
            }
            Self::BrokenPower { function, found } => {
                write!(f, "{function} of {found} has no integer powers of kg, m and s")
            }
            Self::Value { found, expected } => write!(f, "the value is {found}, where {expected} belongs"),
            Self::BareAngle { operation, found } => {
                write!(f, "{operation} compares an angle with {found}, which has no unit")
            }
            Self::NoCondition => write!(f, "this is a number, where a condition belongs"),
            Self::ChainedComparison => write!(f, "the result of a comparison cannot be compared"),
        }
    }
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.kind)
    }
}

impl Error for ExpressionError {}

/// Returns an example of a quantity of a dimension in the syntax of formulas.
fn example(dimension: Dimension) -> Option<String> {
    let text = dimension.with_angle().example().filter(|_| dimension.without_angle() != Dimension::NONE)?;
    text.split_once(' ').map(|(number, unit)| format!("{number}[{unit}]"))
}

fn with_unit(example: &str) -> String {
    format!("write the unit after the number, such as {}", example.replace('[', " ").replace(']', ""))
}
