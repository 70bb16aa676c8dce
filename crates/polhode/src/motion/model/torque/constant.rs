//! A torque that is constant in body or in space axes.

use super::model::Model;
use crate::math::frame::{Body, Space};
use crate::math::vector::Torque;
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Torque with constant components along one set of axes, N·m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConstantTorque {
    /// Constant along body axes, such as that of a thruster fixed to the body.
    Body(Torque<Body>),
    /// Constant along space axes.
    Space(Torque<Space>),
}

impl Law for ConstantTorque {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        match *self {
            Self::Body(n) => at.body_parameters(0, n.as_quantity()),
            Self::Space(n) => at.space_parameters(0, n.as_quantity()),
        }
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["x", "y", "z"]
    }
}

impl Model for ConstantTorque {
    fn name(&self) -> &'static str {
        "constant"
    }

    fn scale(&self, _: &Rotor, _: &State) -> f64 {
        match self {
            Self::Body(n) => n.norm(),
            Self::Space(n) => n.norm(),
        }
    }
}
