//! A force fixed to the body.

use crate::math::frame::Body;
use crate::math::vector::{Force, Position, Torque};
use crate::motion::rotor::Rotor;

/// A thruster: a force along body axes at a point of the body, N = (r − c) × F.
///
/// c is the point that the body turns about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thruster {
    /// Where it acts, in the body, m.
    pub position: Position<Body>,
    /// F, N.
    pub force: Force<Body>,
}

impl Thruster {
    /// N in body axes.
    pub fn torque(&self, rotor: &Rotor) -> Torque<Body> {
        (self.position - rotor.point()).cross(self.force)
    }

    /// |N|, N·m.
    pub(crate) fn scale(&self, rotor: &Rotor) -> f64 {
        self.torque(rotor).norm()
    }
}
