//! The state of a turning body.

use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::AngularVelocity;

/// Where a body points, how it turns, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Time, s.
    pub time: f64,
    /// R_space_body.
    pub attitude: Attitude,
    /// ω relative to space, in body axes, rad/s.
    pub omega: AngularVelocity<Body>,
}

impl State {
    /// ω in space axes, rad/s.
    pub fn omega_space(&self) -> AngularVelocity<Space> {
        self.attitude * self.omega
    }
}
