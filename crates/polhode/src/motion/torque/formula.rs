//! A torque that is given by formulas.

use crate::math::frame::Body;
use crate::math::vector::Torque;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// A torque of three formulas of time, ω, L and the attitude.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaTorque {}

impl FormulaTorque {
    /// N in body axes.
    pub fn torque(&self, _rotor: &Rotor, _state: &State) -> Torque<Body> {
        Torque::ZERO
    }

    /// Its size at a state, N·m.
    pub(crate) fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.torque(rotor, state).norm()
    }

    /// Why it has no Taylor series, if it has none.
    pub(crate) fn roughness(&self) -> Option<&'static str> {
        None
    }
}
