//! Arrangement of a contact: the two surfaces, the contact law, and gravity.

use super::ground::Ground;
use super::law::ContactLaw;
use super::surface::BodySurface;
use crate::math::frame::Space;
use crate::math::vector::Acceleration;

/// Two surfaces in contact, the contact law, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Surface of the body.
    pub surface: BodySurface,
    /// Surface of the ground.
    pub ground: Ground,
    /// Law of the contact force.
    pub law: ContactLaw,
    /// Acceleration of gravity g, space axes, m/s².
    pub gravity: Acceleration<Space>,
}

impl Contact {
    /// Creates a contact of a body that rolls on level ground under standard gravity.
    pub const fn rolling(surface: BodySurface) -> Self {
        let gravity = Acceleration::new(0.0, 0.0, -9.80665);
        Self { surface, ground: Ground::LEVEL, law: ContactLaw::ROLLING, gravity }
    }
}
