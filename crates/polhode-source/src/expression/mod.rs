//! Formulas in text: numbers, variables, `+ − * / ^`, functions and `if`.
//!
//! | | |
//! |---|---|
//! | numbers | `2700`, `.5`, `1.5e-3`, `pi` |
//! | variables | whatever the place of the formula offers: `x`, `y`, `z` in m for a density |
//! | arithmetic | `+ - * /` from the left, `^` from the right; `-x^2` is −(x²), `2^-1` is ½ |
//! | comparison | `< <= > >=`, below all arithmetic: 1 where it holds, else 0; joined by `and`, and below it `or` |
//! | functions | `sqrt exp log log1p expm1 sin cos tan asin acos atan sinh cosh tanh abs floor` |
//! | of several numbers | `atan2(y, x) min max hypot pow mod`, `clip(a, low, high)` |
//! | choice | `if(condition, then, else)`: *then* where the condition is not 0 |
//! | local values | `a = x + y; b = a^2; a*b`: only in generated formulas, [`formula_of_state_in_si`] |
//! | units | `0.2 N m`, `30[deg/s]` where dimensions are checked: [`measured`] |
//!
//! Angles are in radians, `log` is the natural logarithm. A text is compiled once into a
//! [`Formula`], which evaluates many points per call. Functions are those of `libm`, so results are
//! bit-identical on every platform.
//!
//! The numerical integration of a density with steps (`if`) converges slowly. If possible, divide
//! the body along the step instead.

mod dimensions;
mod error;
mod function;
mod parse;
mod state;

use polhode::math::formula::Formula;

use crate::unit::Dimension;

pub use error::{ExpressionError, ExpressionErrorKind};
pub use state::{formula_of_state, formula_of_state_in_si, formula_of_time};

/// Formula of named variables, ready for evaluation; numbers have no units, and dimensions are not
/// checked.
///
/// ```
/// use polhode_source::expression::Expression;
/// let density = Expression::parse("2700 - 300*hypot(x, y)^2 + if(z > 0.5, 40, 0)", &["x", "y", "z"])?;
/// assert_eq!(density.evaluate([2.0, 0.0, 1.0]), 2700.0 - 1200.0 + 40.0);
///
/// let error = Expression::parse("2700 + sqr(x)", &["x", "y", "z"]).unwrap_err();
/// assert_eq!(error.to_string(), "column 8: unknown function sqr");
/// assert_eq!(error.hint().unwrap(), "did you mean sqrt?");
/// # Ok::<(), polhode_source::expression::ExpressionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    formula: Formula,
    text: String,
}

impl Expression {
    /// Parses a formula of the named variables; variable n is component n of a point.
    ///
    /// # Errors
    /// [`ExpressionError`], with column, cause and a hint.
    pub fn parse(text: &str, variables: &[&str]) -> Result<Self, ExpressionError> {
        Ok(Self { formula: parse::compile(text, variables)?, text: text.to_owned() })
    }

    /// Returns the source text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the compiled formula without its text.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Returns the value for these values of the variables; a missing variable is NaN.
    pub fn evaluate<const N: usize>(&self, point: [f64; N]) -> f64 {
        self.formula.evaluate(&point)
    }

    /// Evaluates the formula at many points, up to the length of the shorter slice.
    pub fn evaluate_all<const N: usize>(&self, points: &[[f64; N]], values: &mut [f64]) {
        self.formula.evaluate_all(points, values);
    }
}

/// Density, kg/m³, as a function of x, y and z, m; the variables must be these, in this order.
impl polhode::body::density::DensityField for Expression {
    fn density(&self, point: [f64; 3]) -> f64 {
        self.evaluate(point)
    }

    fn densities(&self, points: &[[f64; 3]], densities: &mut [f64]) {
        self.evaluate_all(points, densities);
    }
}

/// Parses a formula with units and dimensional variables; returns it with the dimension of its
/// value.
///
/// Operands of sums and comparisons must have the same dimension. Arguments and results of
/// functions are plain numbers. A number without a unit is a plain number, except that 0 fits every
/// dimension. An angle is a plain number too. `expected` is the required dimension of the value, if
/// known. The returned dimension counts the angle in rates.
///
/// ```
/// use polhode_source::expression::measured;
/// use polhode_source::unit::Dimension;
/// let variables = [("t", Dimension::TIME), ("wx", Dimension::ANGULAR_VELOCITY)];
/// let (torque, dimension) = measured("-0.3[N m s]*wx + sin(90[deg/s]*t)*2[mN m]", &variables, None)?;
/// assert_eq!(dimension, Dimension::TORQUE);
/// assert!((torque.evaluate(&[1.0, 0.5]) - (-0.15 + 0.002)).abs() < 1e-16);
///
/// let error = measured("wx + 2", &variables, None).unwrap_err();
/// assert_eq!(error.to_string(), "column 4: + of an angular velocity and a plain number: the dimensions differ");
/// assert_eq!(error.hint().unwrap(), "write the unit after the number, such as 30 deg/s");
/// # Ok::<(), polhode_source::expression::ExpressionError>(())
/// ```
///
/// # Errors
/// [`ExpressionError`], with column, cause and a hint.
pub fn measured(
    text: &str,
    variables: &[(&str, Dimension)],
    expected: Option<Dimension>,
) -> Result<(Formula, Dimension), ExpressionError> {
    parse::compile_measured(text, variables, expected)
}

/// Returns true for a name that formulas have already: a function, an operator, or pi.
pub fn is_reserved(name: &str) -> bool {
    ["pi", "and", "or"].contains(&name) || function::FUNCTIONS.iter().any(|f| f.name == name)
}

/// Parses a condition of dimensional variables; its formula is 1 if the condition holds, else 0.
///
/// ```
/// use polhode_source::expression::condition;
/// use polhode_source::unit::Dimension;
/// let variables = [("tilt", Dimension::ANGLE), ("t", Dimension::TIME)];
/// let lost = condition("tilt > 90 deg and t < 2 h", &variables)?;
/// assert_eq!([lost.evaluate(&[1.6, 7000.0]), lost.evaluate(&[1.5, 7000.0])], [1.0, 0.0]);
/// assert!(condition("tilt > 90", &variables).is_err()); // of what?
/// assert!(condition("tilt", &variables).is_err());
/// # Ok::<(), polhode_source::expression::ExpressionError>(())
/// ```
///
/// # Errors
/// [`ExpressionError`], with column, cause and a hint.
pub fn condition(text: &str, variables: &[(&str, Dimension)]) -> Result<Formula, ExpressionError> {
    let (formula, _) = measured(text, variables, None)?;
    if formula.is_condition() {
        return Ok(formula);
    }
    Err(ExpressionError { kind: ExpressionErrorKind::NoCondition, column: 1 })
}
