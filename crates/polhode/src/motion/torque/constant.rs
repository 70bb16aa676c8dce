//! A constant torque, in body or in space axes.

use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::Torque;

/// A torque that keeps its components along one set of axes, N·m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConstantTorque {
    /// Along the body's axes: a thruster fixed to the body.
    Body(Torque<Body>),
    /// Along space axes.
    Space(Torque<Space>),
}

impl ConstantTorque {
    /// |N|, N·m.
    pub(crate) fn scale(&self) -> f64 {
        match self {
            Self::Body(n) => n.norm(),
            Self::Space(n) => n.norm(),
        }
    }

    /// N in body axes.
    pub fn torque(&self, attitude: Attitude) -> Torque<Body> {
        match *self {
            Self::Body(n) => n,
            // N_body = R_body_space N_space
            Self::Space(n) => attitude.inverse() * n,
        }
    }
}
