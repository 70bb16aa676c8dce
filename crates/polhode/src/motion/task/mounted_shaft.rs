//! A rotating shaft in its bearings, with its balancing planes.

use super::shaft::{CorrectionMass, Reactions, Shaft};
use crate::math::frame::Space;
use crate::math::rotation::Attitude;
use crate::math::vector::Acceleration;
use crate::motion::error::MotionError;

/// Rotating shaft in its bearings.
#[derive(Clone, Debug, PartialEq)]
pub struct MountedShaft {
    /// Body on the shaft, with the bearings.
    pub shaft: Shaft,
    /// ω at t = 0, rad/s.
    pub rate: f64,
    /// dω/dt, rad/s².
    pub acceleration: f64,
    /// g in space axes, m/s²; zero to neglect the weight.
    pub gravity: Acceleration<Space>,
    /// Balancing planes, none, one or two: position along the axis and radius, m.
    pub balance: Vec<[f64; 2]>,
}

impl MountedShaft {
    /// Returns the masses that balance the shaft in its planes; empty without a plane.
    ///
    /// # Errors
    /// The errors of [`Shaft::balance_in_planes`].
    pub fn correction_masses(&self) -> Result<Vec<CorrectionMass>, MotionError> {
        Self::corrections(&self.shaft, &self.balance)
    }

    /// Returns the masses that balance a shaft in one or two planes, each with position and radius,
    /// m.
    ///
    /// # Errors
    /// The errors of [`Shaft::balance_in_planes`].
    pub fn corrections(shaft: &Shaft, planes: &[[f64; 2]]) -> Result<Vec<CorrectionMass>, MotionError> {
        match *planes {
            [] => Ok(Vec::new()),
            [[plane, radius]] => Ok(vec![shaft.balance_in_plane(plane, radius)?]),
            [[a, at_a], [b, at_b], ..] => Ok(shaft.balance_in_planes([a, b], [at_a, at_b])?.to_vec()),
        }
    }

    /// Returns the reactions of the bearings and the drive torque at a rate (rad/s) and an
    /// attitude.
    pub fn reactions(&self, rate: f64, attitude: Attitude) -> Reactions {
        self.shaft.reactions(rate, self.acceleration, attitude.inverse() * self.gravity)
    }
}
