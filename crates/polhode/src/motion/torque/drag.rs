//! Drag: a torque against ω.

use crate::math::frame::Body;
use crate::math::vector::Torque;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// A torque that resists turning. `matrix` is symmetric and positive semi-definite, along body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Drag {
    /// N = −C ω, C in N·m·s.
    #[non_exhaustive]
    Linear {
        /// C.
        matrix: [[f64; 3]; 3],
    },
    /// N = −|ω| D ω, D in N·m·s².
    #[non_exhaustive]
    Quadratic {
        /// D.
        matrix: [[f64; 3]; 3],
    },
}

impl Drag {
    /// N in body axes.
    pub fn torque(&self, _state: &State) -> Torque<Body> {
        Torque::ZERO
    }

    /// Its size at a state, N·m.
    pub(crate) fn scale(&self, _rotor: &Rotor, state: &State) -> f64 {
        self.torque(state).norm()
    }
}
