//! Where a motion on the ground starts.

use crate::math::frame::Space;
use crate::math::vector::{Position, Velocity};
use crate::motion::model::state::State;

/// How the centre of mass moves at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartVelocity {
    /// As it must, so that the body rolls.
    Rolling,
    /// With this velocity, of which only what lies in the ground counts: the rest follows from the contact.
    Along(Velocity<Space>),
}

/// Where a motion on the ground starts: attitude and ω, the point of the ground that is touched, and how the centre of mass moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStart {
    /// Time, attitude and ω.
    pub state: State,
    /// The point of the ground that is touched.
    pub at: Position<Space>,
    /// The velocity of the centre of mass.
    pub velocity: StartVelocity,
}

impl ContactStart {
    /// Rolling, from the origin of a plane.
    pub const fn rolling(state: State) -> Self {
        Self { state, at: Position::ZERO, velocity: StartVelocity::Rolling }
    }
}
