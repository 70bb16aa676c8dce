//! The arrangement of a body on the ground: the two surfaces, the law between them, and gravity.

use super::ground::Ground;
use super::law::ContactLaw;
use super::surface::BodySurface;
use crate::math::frame::Space;
use crate::math::vector::Acceleration;

/// Surfaces that touch, the law between them, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The surface of the body.
    pub surface: BodySurface,
    /// The ground that it touches.
    pub ground: Ground,
    /// The law of the force between them.
    pub law: ContactLaw,
    /// Acceleration of gravity g, m/s².
    pub gravity: Acceleration<Space>,
}

impl Contact {
    /// A body that rolls on level ground under standard gravity.
    pub const fn rolling(surface: BodySurface) -> Self {
        let gravity = Acceleration::new(0.0, 0.0, -9.80665);
        Self { surface, ground: Ground::LEVEL, law: ContactLaw::ROLLING, gravity }
    }
}
