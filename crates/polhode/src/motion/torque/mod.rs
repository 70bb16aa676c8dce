//! Torques: a sum of small models, each in its own file.

pub(crate) mod constant;
pub(crate) mod gravity;

use super::rotor::Rotor;
use super::state::State;
use crate::math::frame::Body;
use crate::math::rotation::Attitude;
use crate::math::vector::Torque;

pub use constant::ConstantTorque;
pub use gravity::UniformGravity;

/// One cause of torque about the point that the body turns about.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TorqueModel {
    /// Constant along body or space axes.
    Constant(ConstantTorque),
    /// The weight of a body held at a pivot.
    Gravity(UniformGravity),
}

impl TorqueModel {
    /// The torque on the body in a state, body axes, N·m.
    pub fn torque(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        match self {
            Self::Constant(model) => model.torque(state.attitude),
            Self::Gravity(model) => model.torque(rotor, state.attitude),
        }
    }

    /// The potential energy whose loss is this torque's work, J; `None` if it has none.
    pub fn potential(&self, rotor: &Rotor, attitude: Attitude) -> Option<f64> {
        match self {
            Self::Constant(_) => None,
            Self::Gravity(model) => Some(model.potential(rotor, attitude)),
        }
    }

    /// The largest that it can be, N·m: what its rounding is relative to.
    pub(crate) fn scale(&self, rotor: &Rotor) -> f64 {
        match self {
            Self::Constant(model) => model.scale(),
            Self::Gravity(model) => rotor.mass() * model.acceleration.norm() * rotor.lever().norm(),
        }
    }

    /// The name in scenario files and summaries.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Gravity(_) => "gravity",
        }
    }
}

/// The sum of all torques, body axes, N·m.
pub(crate) fn total_torque(models: &[TorqueModel], rotor: &Rotor, state: &State) -> Torque<Body> {
    models.iter().fold(Torque::ZERO, |sum, model| sum + model.torque(rotor, state))
}

/// The sum of all potentials, J; `None` if some torque has none (or there is no torque).
pub(crate) fn total_potential(models: &[TorqueModel], rotor: &Rotor, attitude: Attitude) -> Option<f64> {
    let first = models.first()?.potential(rotor, attitude)?;
    models[1..].iter().try_fold(first, |sum, model| Some(sum + model.potential(rotor, attitude)?))
}
