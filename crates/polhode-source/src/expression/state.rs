//! Formulas of the state of a turning body: of torques and of events; and of time alone.

use polhode::math::formula::Formula;
use polhode::motion::StateVariables;

use super::{ExpressionError, measured, parse};
use crate::unit::Dimension;

/// The formula in a text of time, angular velocity, angular momentum and attitude, and what its value measures.
///
/// Its variables are those of [`StateVariables`], in that order. A plain number may be an angle. If `expected` is given, the
/// value has to be of that dimension.
///
/// ```
/// use polhode_source::expression::formula_of_state;
/// use polhode_source::unit::Dimension;
/// let (speed, dimension) = formula_of_state("hypot(wx, hypot(wy, wz))", None)?;
/// assert_eq!(dimension, Dimension::ANGULAR_VELOCITY);
/// # Ok::<(), polhode_source::expression::ExpressionError>(())
/// ```
///
/// # Errors
/// [`ExpressionError`]: the column, what is wrong there, and a hint.
pub fn formula_of_state(
    text: &str,
    expected: Option<Dimension>,
) -> Result<(Formula, Dimension), ExpressionError> {
    measured(text, &StateVariables::NAMES.map(|name| (name, dimension_of(name))), expected)
}

/// The formula in a text of the same variables, all numbers in SI; dimensions are not checked.
///
/// # Errors
/// As [`formula_of_state`].
pub fn formula_of_state_in_si(text: &str) -> Result<Formula, ExpressionError> {
    /// It may have been made by a program.
    const LONGEST: usize = 65_536;
    parse::require_length(text, LONGEST)?;
    parse::compile(text, &StateVariables::NAMES)
}

/// The formula in a text of time, `t`, alone, whose value is of a dimension.
///
/// # Errors
/// As [`formula_of_state`].
pub fn formula_of_time(text: &str, expected: Dimension) -> Result<Formula, ExpressionError> {
    measured(text, &[("t", Dimension::TIME)], Some(expected)).map(|(formula, _)| formula)
}

/// What a variable measures: its first letter says it.
fn dimension_of(name: &str) -> Dimension {
    match name.chars().next() {
        Some('t') if name == "t" => Dimension::TIME,
        Some('w') => Dimension::ANGULAR_VELOCITY,
        Some('L') => Dimension::ANGULAR_MOMENTUM,
        Some('T') => Dimension::TORQUE,
        _ if ["phi", "theta", "psi"].contains(&name) => Dimension::ANGLE,
        _ => Dimension::NONE,
    }
}
