//! A spring that is twisted as the body turns.

use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::{Direction, Torque};
use crate::motion::state::State;

/// A torsion spring or wire between the body and space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torsion {
    /// N·m/rad.
    pub stiffness: f64,
    /// The attitude without twist.
    pub rest: Attitude,
    /// A wire's line in space; `None`: a spring that resists every turn alike.
    pub axis: Option<Direction<Space>>,
}

impl Torsion {
    /// N in body axes.
    pub fn torque(&self, _state: &State) -> Torque<Body> {
        Torque::ZERO
    }

    /// U, J.
    pub fn potential(&self, _attitude: Attitude) -> f64 {
        0.0
    }

    /// The largest that it can be, N·m.
    pub(crate) fn scale(&self) -> f64 {
        self.stiffness * core::f64::consts::PI
    }
}
