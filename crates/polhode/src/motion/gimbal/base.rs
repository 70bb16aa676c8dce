//! Base of the suspension.

use crate::math::frame::Space;
use crate::math::vector::AngularVelocity;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Base that carries the outer gimbal. It is at rest in space, or turns with constant angular
/// velocity about the intersection of the axes.
///
/// The axes of the base coincide with those of space at the start. The constant angular velocity
/// has the same components along both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base {
    turning: AngularVelocity<Space>,
}

impl Base {
    /// Rotation rate of the Earth relative to the stars, rad/s.
    ///
    /// Source: WGS 84 (NGA.STND.0036, 2014), table 3.1.
    pub const EARTH_RATE: f64 = 7.292_115e-5;

    /// Base at rest.
    pub const FIXED: Self = Self { turning: AngularVelocity::ZERO };

    /// Creates a base that turns with an angular velocity, rad/s.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if it is not finite.
    pub fn turning(turning: AngularVelocity<Space>) -> Result<Self, MotionError> {
        require::finite("the angular velocity of the base", turning.norm())?;
        Ok(Self { turning })
    }

    /// Creates a base on the Earth at a latitude λ, rad, north positive. x points east, y north and
    /// z up; the angular velocity is `ω_E` (0, cos λ, sin λ).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the latitude is not in −π/2 … π/2.
    pub fn on_earth(latitude: f64) -> Result<Self, MotionError> {
        let holds = latitude.abs() <= core::f64::consts::FRAC_PI_2;
        require::that("the latitude of the base", latitude, holds, "between -π/2 and π/2")?;
        let (s, c) = (libm::sin(latitude), libm::cos(latitude));
        Ok(Self { turning: AngularVelocity::new(0.0, Self::EARTH_RATE * c, Self::EARTH_RATE * s) })
    }

    /// Returns the angular velocity, rad/s.
    pub const fn angular_velocity(&self) -> AngularVelocity<Space> {
        self.turning
    }
}
