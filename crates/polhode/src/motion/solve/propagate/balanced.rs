//! A state with its evidence.

use crate::math::frame::Space;
use crate::math::vector::AngularMomentum;
use crate::motion::model::state::State;

/// A state with the work and the angular impulse that torque has given the body since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Balanced {
    pub(crate) state: State,
    /// ∫ N · ω dt, J.
    pub(crate) work: f64,
    /// ∫ N dt in space axes, N·m·s.
    pub(crate) impulse: AngularMomentum<Space>,
}
