//! Formulas in text: numbers, variables, `+ − * / ^`, functions and `if`.
//!
//! | | |
//! |---|---|
//! | numbers | `2700`, `.5`, `1.5e-3`, `pi` |
//! | variables | whatever the place of the formula offers: `x`, `y`, `z` in m for a density |
//! | arithmetic | `+ - * /` from the left, `^` from the right; `-x^2` is −(x²), `2^-1` is ½ |
//! | comparison | `< <= > >=`, below all arithmetic: 1 where it holds, else 0 |
//! | functions | `sqrt exp log sin cos tan asin acos atan abs`, of two `atan2(y, x) min max hypot pow` |
//! | choice | `if(condition, then, else)`: *then* where the condition is not 0 |
//!
//! Angles are in radians, `log` is the natural logarithm. A text is compiled into a [`Formula`] once, which runs over
//! many points at a time. Functions are `libm`'s: the same bits on every platform.
//!
//! A density with steps is integrated slowly: `if` says it is one, so divide the body along the step where that is
//! possible.

mod parse;

use std::error::Error;
use std::fmt;

use polhode::Formula;

use crate::text::cut;

/// A formula of named variables, ready to be evaluated.
///
/// ```
/// use polhode_formats::expression::Expression;
/// let density = Expression::parse("2700 - 300*hypot(x, y)^2 + if(z > 0.5, 40, 0)", &["x", "y", "z"])?;
/// assert_eq!(density.evaluate([2.0, 0.0, 1.0]), 2700.0 - 1200.0 + 40.0);
///
/// let error = Expression::parse("2700 + sqr(x)", &["x", "y", "z"]).unwrap_err();
/// assert_eq!(error.to_string(), "column 8: there is no function sqr");
/// assert_eq!(error.hint().unwrap(), "did you mean sqrt?");
/// # Ok::<(), polhode_formats::expression::ExpressionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    formula: Formula,
    text: String,
}

impl Expression {
    /// The formula in a text, of the variables by their names: the n-th is the n-th value of a point.
    ///
    /// # Errors
    /// [`ExpressionError`]: the column, what is wrong there, and a hint.
    pub fn parse(text: &str, variables: &[&str]) -> Result<Self, ExpressionError> {
        Ok(Self { formula: parse::compile(text, variables)?, text: text.to_owned() })
    }

    /// The text that it was read from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The formula itself, without its text.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Its value where the variables have these values; one that is not given is NaN.
    pub fn evaluate<const N: usize>(&self, point: [f64; N]) -> f64 {
        self.formula.evaluate(&point)
    }

    /// Its values at many points: the shorter of the two lists says how many.
    pub fn evaluate_all<const N: usize>(&self, points: &[[f64; N]], values: &mut [f64]) {
        self.formula.evaluate_all(points, values);
    }
}

/// A density, kg/m³, of x, y and z, m, which must be its variables in this order.
impl polhode::DensityField for Expression {
    fn density(&self, point: [f64; 3]) -> f64 {
        self.evaluate(point)
    }

    fn densities(&self, points: &[[f64; 3]], densities: &mut [f64]) {
        self.evaluate_all(points, densities);
    }
}

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
                parse::FUNCTIONS.map(|f| f.name).join(", ")
            )),
            Kind::ChainedComparison => Some("write if(0 < x, if(x < 1, a, b), b)".to_owned()),
            Kind::Expected { found, .. } if found == "*" => Some("a power is written x^2".to_owned()),
            Kind::Expected { found, .. } if found == "=" || found == "!" || found == "&" || found == "|" => {
                Some("there are <, <=, > and >=, and if(condition, then, else)".to_owned())
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
                write!(f, "{function} takes {takes} arguments, not {given}")
            }
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
