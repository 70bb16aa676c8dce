//! Where a motion on the ground starts.

use crate::math::frame::Space;
use crate::math::vector::{Position, Velocity};
use crate::motion::model::state::State;

/// How the centre of mass moves at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartVelocity {
    /// As it must, so that the body rolls.
    Rolling,
    /// Velocity whose component along the normal is zero, or the one that the contact demands. Zero
    /// is completed to that. A motion with any other component is refused: the body would leave the
    /// ground or enter it.
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
