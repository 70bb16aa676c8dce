//! A shaft in its bearings: how it turns, and where it may be balanced.

use super::shaft::{CorrectionMass, Reactions, Shaft};
use crate::math::frame::Space;
use crate::math::rotation::Attitude;
use crate::math::vector::Acceleration;
use crate::motion::error::MotionError;

/// A shaft that turns.
#[derive(Clone, Debug, PartialEq)]
pub struct MountedShaft {
    /// The body on its line, with its bearings.
    pub shaft: Shaft,
    /// ω at t = 0, rad/s.
    pub rate: f64,
    /// dω/dt, rad/s².
    pub acceleration: f64,
    /// g in space axes, m/s²; zero where weight does not count.
    pub gravity: Acceleration<Space>,
    /// Planes and radii for correction masses, m: none, one or two.
    pub balance: Vec<[f64; 2]>,
}

impl MountedShaft {
    /// The masses that balance it in its planes; none without a plane.
    ///
    /// # Errors
    /// As [`Shaft::balance_in_planes`].
    pub fn correction_masses(&self) -> Result<Vec<CorrectionMass>, MotionError> {
        Self::corrections(&self.shaft, &self.balance)
    }

    /// The masses that balance a shaft in one plane, or in two, each with its radius, m.
    ///
    /// # Errors
    /// As [`Shaft::balance_in_planes`].
    pub fn corrections(shaft: &Shaft, planes: &[[f64; 2]]) -> Result<Vec<CorrectionMass>, MotionError> {
        match *planes {
            [] => Ok(Vec::new()),
            [[plane, radius]] => Ok(vec![shaft.balance_in_plane(plane, radius)?]),
            [[a, at_a], [b, at_b], ..] => Ok(shaft.balance_in_planes([a, b], [at_a, at_b])?.to_vec()),
        }
    }

    /// What the bearings and the drive do at a rate, with the body's axes standing in space so.
    pub fn reactions(&self, rate: f64, attitude: Attitude) -> Reactions {
        self.shaft.reactions(rate, self.acceleration, attitude.inverse() * self.gravity)
    }
}
