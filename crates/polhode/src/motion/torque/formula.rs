//! A torque that is given by formulas.

use crate::math::formula::Formula;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Torque, Vector};
use crate::motion::rotor::Rotor;
use crate::motion::state::State;
use crate::motion::state_variables::StateVariables;

/// A torque whose components are formulas of time, ω, L and the attitude, N·m: of the variables that [`StateVariables`] lists.
///
/// Formulas of smooth functions have a power series, and Taylor's method integrates them. What has corners or jumps, such as
/// `abs`, `min` or `if`, is for DOP853, whose steps shrink there. What is no number ends the motion:
/// [`MotionError::NotFinite`](crate::MotionError::NotFinite) has the last good time. No power series starts at a root of 0,
/// `hypot(0, 0)` or `atan2(0, 0)`, unless what they are of stays 0.
///
/// It has no potential here, so that work and impulse are its evidence.
#[derive(Clone, Debug, PartialEq)]
pub enum FormulaTorque {
    /// Components along body axes.
    Body([Formula; 3]),
    /// Components along space axes.
    Space([Formula; 3]),
}

impl FormulaTorque {
    /// N in body axes.
    pub fn torque(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        let variables = StateVariables::of(rotor, state);
        let [x, y, z] = self.components();
        let [x, y, z] = [x, y, z].map(|formula| formula.evaluate(&variables));
        match self {
            Self::Body(_) => Vector::new(x, y, z),
            // N_body = R_body_space N_space
            Self::Space(_) => state.attitude.inverse() * Torque::<Space>::new(x, y, z),
        }
    }

    /// Its three formulas.
    pub const fn components(&self) -> &[Formula; 3] {
        match self {
            Self::Body(components) | Self::Space(components) => components,
        }
    }

    /// Its size at a state, N·m.
    pub(crate) fn scale(&self, rotor: &Rotor, state: &State) -> f64 {
        self.torque(rotor, state).norm()
    }

    /// Why it has no Taylor series, if it has none.
    pub(crate) fn roughness(&self) -> Option<&'static str> {
        self.components().iter().find_map(Formula::rough_function)
    }
}
