//! Eggs that rise: ellipsoids of revolution that spin fast.

use super::{ROUNDING_OF_SIZE, level, moments};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::contact::{Contact, SurfaceShape};

/// Symmetric body whose surface is an ellipsoid with semi-axes b, b, c centred at its centre of
/// mass. It spins about the vertical n at the rate Ω, with its axis e at the angle θ from n.
///
/// Friction is assumed to be weak compared with the spin. The gyroscopic torques then balance,
/// (C ω_e − A Ω cos θ) Ω sin θ = 0, so that L = A Ω n apart from nutation. With the height of the
/// centre of mass h(θ) = √(b² sin² θ + c² cos² θ), J = −L · r = A Ω h is constant like Jellett's
/// constant of a ball, and the energy is
///
/// E(h) = J²/(2 A h²) + m g h,
///
/// It decreases with increasing h where Ω² > m g h/A. Friction dissipates energy, so a prolate egg
/// that spins faster than this rises: completely if J² > A m g c³. On its end it spins at J/(C c).
///
/// Source: H. K. Moffatt, Y. Shimomura, Nature 416 (2002) 385; H. K. Moffatt, Y. Shimomura,
/// M. Branicki, Proc. R. Soc. A 460 (2004) 3643.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinningEgg {
    /// Mass m, kg.
    pub mass: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Moment of inertia A perpendicular to the axis, kg·m².
    pub across: f64,
    /// Moment of inertia C about the axis, kg·m².
    pub along: f64,
    /// Equatorial semi-axis b, m.
    pub radius: f64,
    /// Semi-axis c along the axis, m.
    pub half_length: f64,
}

impl SpinningEgg {
    /// Returns the egg that a symmetric ellipsoid centred at the centre of mass is on level ground,
    /// and its axis e.
    pub fn of(body: &MassProperties<Body>, contact: &Contact) -> Option<(Self, Direction<Body>)> {
        let SurfaceShape::Ellipsoid { semi_axes } = *contact.surface.shape() else { return None };
        let (gravity, axis) = (level(contact)?, contact.symmetry_axis(body)?);
        let offset = (contact.surface.center() - body.center_of_mass()).norm();
        let along = (contact.surface.axes().inverse() * axis).to_array();
        // The symmetry axis is one of the ellipsoid's axes.
        let k = (0..3).max_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs()))?;
        let (half_length, radius) = (semi_axes[k], semi_axes[(k + 1) % 3]);
        let [across, along] = moments(body, axis);
        let egg = Self { mass: body.mass(), gravity, across, along, radius, half_length };
        (offset <= ROUNDING_OF_SIZE * radius).then_some((egg, axis))
    }

    /// Returns h, m, for the angle `tilt` of the axis from the vertical.
    pub fn height(&self, tilt: f64) -> f64 {
        (self.radius * libm::sin(tilt)).hypot(self.half_length * libm::cos(tilt))
    }

    /// Returns E(h), J, for Jellett's constant in kg·m³/s.
    pub fn energy(&self, jellett: f64, height: f64) -> f64 {
        let momentum = jellett / height;
        0.5 * momentum * momentum / self.across + self.mass * self.gravity * height
    }

    /// Returns the spin above which a higher centre of mass has less energy, for the height h,
    /// rad/s.
    pub fn rises_beyond(&self, height: f64) -> f64 {
        (self.mass * self.gravity * height / self.across).sqrt()
    }

    /// Returns the J above which this holds up to the end of the egg (or the rim, if oblate),
    /// kg·m³/s.
    pub fn stands_beyond(&self) -> f64 {
        let highest = self.radius.max(self.half_length);
        (self.across * self.mass * self.gravity * highest * highest * highest).sqrt()
    }

    /// Returns the spin on its end for this J, rad/s.
    pub fn spin_on_end(&self, jellett: f64) -> f64 {
        jellett / (self.along * self.half_length)
    }
}
