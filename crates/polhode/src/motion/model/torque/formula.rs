//! Torques given by formulas.

use super::model::Model;
use crate::math::algebra::Scalar;
use crate::math::formula::{Formula, Instruction};
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Torque, Vector};
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::state_variables::StateVariables;

/// Torque whose components are formulas of time, ω, L and the attitude, N·m. [`StateVariables`]
/// lists the variables.
///
/// Formulas of smooth functions have a power series, and Taylor's method integrates them. Formulas
/// with corners or jumps (`abs`, `min`, `if`) need DOP853, which reduces its steps there. NaN ends
/// the motion: [`MotionError::NotFinite`](crate::motion::MotionError::NotFinite) has the last valid
/// time. A power series cannot start where the operand of a root is 0, nor at `hypot(0, 0)` or
/// `atan2(0, 0)`, unless the operands stay 0.
///
/// A formula has no known potential, so the checks of the motion are work and impulse.
#[derive(Clone, Debug, PartialEq)]
pub enum FormulaTorque {
    /// Components along body axes.
    Body([Formula; 3]),
    /// Components along space axes.
    Space([Formula; 3]),
}

/// The formulas are the law. In numeric states they are evaluated directly, including functions
/// without a series.
impl Law for FormulaTorque {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let [x, y, z] = self.components();
        let components = [x, y, z].map(|formula| evaluate(formula, at));
        match self {
            Self::Body(_) => at.vector(components),
            Self::Space(_) => {
                let [x, y, z] = components;
                at.in_space(X) * x + at.in_space(Y) * y + at.in_space(Z) * z
            }
        }
    }

    fn at(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        let variables = StateVariables::of(rotor, state);
        let [x, y, z] = self.components();
        let [x, y, z] = [x, y, z].map(|formula| formula.evaluate(&variables));
        match self {
            Self::Body(_) => Vector::new(x, y, z),
            // `N_body` = `R_body_space` `N_space`
            Self::Space(_) => state.attitude.inverse() * Torque::<Space>::new(x, y, z),
        }
    }
}

const X: Direction<Space> = Direction::new(1.0, 0.0, 0.0);
const Y: Direction<Space> = Direction::new(0.0, 1.0, 0.0);
const Z: Direction<Space> = Direction::new(0.0, 0.0, 1.0);

/// Evaluates a formula of a state, instruction by instruction.
pub(in crate::motion) fn evaluate<I: LawInput>(formula: &Formula, at: &I) -> I::Scalar {
    let mut stack: Vec<I::Scalar> = Vec::new();
    for &instruction in formula.instructions() {
        let operands = stack.split_off(stack.len().saturating_sub(instruction.operands()));
        stack.push(match (instruction, operands.as_slice()) {
            (Instruction::Constant(value), _) => at.number(value),
            (Instruction::Variable(k), _) => StateVariables::variable(k, at),
            (Instruction::Unary(function), &[a]) => a.unary(function),
            (Instruction::Binary(function), &[a, b]) => a.binary(function, b),
            (Instruction::Local(k), _) => stack.get(k).copied().unwrap_or_else(|| at.number(f64::NAN)),
            (Instruction::EndLocal, &[_, top]) => top,
            // Instructions with branches are evaluated in numeric states only.
            _ => at.number(f64::NAN),
        });
    }
    stack.pop().unwrap_or_else(|| at.number(f64::NAN))
}

impl FormulaTorque {
    /// Returns the three formulas.
    pub const fn components(&self) -> &[Formula; 3] {
        match self {
            Self::Body(components) | Self::Space(components) => components,
        }
    }
}

impl Model for FormulaTorque {
    fn name(&self) -> &'static str {
        "formula"
    }

    fn roughness(&self) -> Option<&'static str> {
        self.components().iter().find_map(Formula::rough_function)
    }

    fn is_partial(&self) -> bool {
        true
    }

    fn unsplittable(&self) -> Option<&'static str> {
        Some("its formulas may depend on the angular velocity")
    }
}
