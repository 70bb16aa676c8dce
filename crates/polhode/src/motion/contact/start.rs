//! Start of a motion on the ground.

use crate::math::frame::Space;
use crate::math::vector::{Position, Velocity};
use crate::motion::model::state::State;

/// Velocity of the centre of mass at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartVelocity {
    /// Velocity for which the body rolls.
    Rolling,
    /// Velocity whose normal component is zero or the one that the contact requires. A zero
    /// component is replaced by the required one. Any other component is an error: the body would
    /// leave the ground or penetrate it.
    Along(Velocity<Space>),
}

/// Start of a motion on the ground: attitude and ω, point of contact, and velocity of the centre of
/// mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStart {
    /// Time, attitude and ω.
    pub state: State,
    /// Point of contact on the ground, m.
    pub at: Position<Space>,
    /// Velocity of the centre of mass.
    pub velocity: StartVelocity,
}

impl ContactStart {
    /// Creates a rolling start at the origin of a plane.
    pub const fn rolling(state: State) -> Self {
        Self { state, at: Position::ZERO, velocity: StartVelocity::Rolling }
    }
}
