//! Gravity that differs from one end of an orbiting body to the other.

use crate::body::particles::Particle;
use crate::math::frame::Body;
use crate::math::vector::Torque;
use crate::motion::orbit::Orbit;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// The torque of the gravity of a point mass about which the body's centre of mass moves on an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityGradient {
    /// How the centre of mass moves.
    pub orbit: Orbit,
    /// The mass that gravity acts on.
    pub attracted: Attracted,
}

/// What gravity acts on.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Attracted {
    /// The inertia tensor, to first order in size over distance: N = 3 µ/r³ r̂ × I r̂.
    Tensor,
    /// Mass points, exactly: N = Σ x × m g(r + x). Positions in the body.
    Points(Vec<Particle<Body>>),
}

impl GravityGradient {
    /// N in body axes.
    pub fn torque(&self, _rotor: &Rotor, _state: &State) -> Torque<Body> {
        Torque::ZERO
    }

    /// The largest that it can be, N·m.
    pub(crate) fn scale(&self, _rotor: &Rotor) -> f64 {
        0.0
    }
}
