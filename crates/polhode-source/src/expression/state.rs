//! Formulas of the rotational state, for torques and events, and of time alone.

use polhode::math::formula::Formula;
use polhode::motion::StateVariables;

use super::{ExpressionError, measured, parse};
use crate::unit::Dimension;

/// Parses a formula of time, angular velocity, angular momentum and attitude; returns it with the
/// dimension of its value.
///
/// The variables are [`StateVariables`], in that order. A plain number may be an angle. If
/// `expected` is given, the value must have that dimension.
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
/// [`ExpressionError`], with column, cause and a hint.
pub fn formula_of_state(
    text: &str,
    expected: Option<Dimension>,
) -> Result<(Formula, Dimension), ExpressionError> {
    measured(text, &StateVariables::NAMES.map(|name| (name, dimension_of(name))), expected)
}

/// Parses a formula of the same variables with all numbers in SI; dimensions are not checked.
///
/// Programs generate such formulas. Values that are used several times may have names, which are
/// defined before the result.
///
/// ```
/// use polhode::motion::StateVariables;
/// use polhode_source::expression::formula_of_state_in_si;
/// let scaled = formula_of_state_in_si("size = hypot(wx, wy); gain = 2 + size; gain*size/(1 + gain)")?;
/// let mut state = [0.0; StateVariables::COUNT];
/// (state[1], state[2]) = (3.0, -4.0);
/// assert_eq!(scaled.evaluate(&state), 35.0 / 8.0);
/// # Ok::<(), polhode_source::expression::ExpressionError>(())
/// ```
///
/// # Errors
/// Same as [`formula_of_state`].
pub fn formula_of_state_in_si(text: &str) -> Result<Formula, ExpressionError> {
    /// Programs may generate longer formulas than people write.
    const LONGEST: usize = 65_536;
    parse::require_length(text, LONGEST)?;
    parse::compile_with_locals(text, &StateVariables::NAMES)
}

/// Parses a formula of time `t` alone; the value must have the dimension `expected`.
///
/// # Errors
/// Same as [`formula_of_state`].
pub fn formula_of_time(text: &str, expected: Dimension) -> Result<Formula, ExpressionError> {
    measured(text, &[("t", Dimension::TIME)], Some(expected)).map(|(formula, _)| formula)
}

/// Returns the dimension of a variable, from the first letter of its name.
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
