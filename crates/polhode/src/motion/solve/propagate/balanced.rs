//! A state with the work and impulse that test it.

use crate::math::frame::Space;
use crate::math::vector::AngularMomentum;
use crate::motion::model::state::State;

/// State, with the work and the angular impulse of the torque on the body since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Balanced {
    pub(crate) state: State,
    /// ∫ N · ω dt, J.
    pub(crate) work: f64,
    /// ∫ N dt in space axes, N·m·s.
    pub(crate) impulse: AngularMomentum<Space>,
}
