//! Eggs that stand up: ellipsoids of revolution that spin fast.

use super::{ROUNDING_OF_SIZE, level, moments};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::contact::{Contact, SurfaceShape};

/// A symmetric body whose surface is an ellipsoid with semi-axes b, b, c about its centre of mass, spinning about the vertical n at Ω with its axis e at θ from it.
///
/// Friction is too small to keep up with the spin: the gyroscopic torques balance by themselves, (C ω_e − A Ω cos θ) Ω sin θ = 0, so that L is A Ω n but for what nods. With h(θ) = √(b² sin² θ + c² cos² θ), the height
/// of the centre of mass, J = −L · r = A Ω h then stays as Jellett's constant of a ball does, and the energy is
///
/// E(h) = J²/(2 A h²) + m g h,
///
/// which falls as h rises where Ω² > m g h/A. Friction takes energy, and so a prolate egg that spins that fast rises: all the way if J² > A m g c³; on its end it spins at J/(C c).
///
/// Source: H. K. Moffatt, Y. Shimomura, Nature 416 (2002) 385; H. K. Moffatt, Y. Shimomura, M. Branicki, Proc. R. Soc. A 460 (2004) 3643.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinningEgg {
    /// m, kg
    pub mass: f64,
    /// g, m/s²
    pub gravity: f64,
    /// A, kg·m²
    pub across: f64,
    /// C, kg·m²
    pub along: f64,
    /// b, m
    pub radius: f64,
    /// c, m
    pub half_length: f64,
}

impl SpinningEgg {
    /// The egg that a symmetric body with an ellipsoid about its centre of mass is on level ground, and its axis e.
    pub fn of(body: &MassProperties<Body>, contact: &Contact) -> Option<(Self, Direction<Body>)> {
        let SurfaceShape::Ellipsoid { semi_axes } = *contact.surface.shape() else { return None };
        let (gravity, axis) = (level(contact)?, contact.symmetry_axis(body)?);
        let offset = (contact.surface.center() - body.center_of_mass()).norm();
        let along = (contact.surface.axes().inverse() * axis).to_array();
        // The axis is one of the ellipsoid's.
        let k = (0..3).max_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs()))?;
        let (half_length, radius) = (semi_axes[k], semi_axes[(k + 1) % 3]);
        let [across, along] = moments(body, axis);
        let egg = Self { mass: body.mass(), gravity, across, along, radius, half_length };
        (offset <= ROUNDING_OF_SIZE * radius).then_some((egg, axis))
    }

    /// h, m, with the axis at an angle from the vertical.
    pub fn height(&self, tilt: f64) -> f64 {
        (self.radius * libm::sin(tilt)).hypot(self.half_length * libm::cos(tilt))
    }

    /// E(h), J, with J in kg·m³/s.
    pub fn energy(&self, jellett: f64, height: f64) -> f64 {
        let momentum = jellett / height;
        0.5 * momentum * momentum / self.across + self.mass * self.gravity * height
    }

    /// The spin beyond which a higher centre of mass has less energy, where it is this high, rad/s.
    pub fn rises_beyond(&self, height: f64) -> f64 {
        (self.mass * self.gravity * height / self.across).sqrt()
    }

    /// J beyond which that is so up to its end, or of an oblate one up to its rim, kg·m³/s.
    pub fn stands_beyond(&self) -> f64 {
        let highest = self.radius.max(self.half_length);
        (self.across * self.mass * self.gravity * highest * highest * highest).sqrt()
    }

    /// The spin on its end that has this J, rad/s.
    pub fn spin_on_end(&self, jellett: f64) -> f64 {
        jellett / (self.along * self.half_length)
    }
}
