//! What carries the suspension.

use crate::math::frame::Space;
use crate::math::vector::AngularVelocity;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// What carries the outer gimbal: at rest in space, or turning with a constant angular velocity, about the crossing of the axes.
///
/// The axes of the base are those of space at the start. Its angular velocity has the same components along both, as it is constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base {
    turning: AngularVelocity<Space>,
}

impl Base {
    /// The rate at which the Earth turns relative to the stars, rad/s.
    ///
    /// Source: WGS 84 (NGA.STND.0036, 2014), table 3.1.
    pub const EARTH_RATE: f64 = 7.292_115e-5;

    /// At rest.
    pub const FIXED: Self = Self { turning: AngularVelocity::ZERO };

    /// Turning with an angular velocity.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for one that is not finite.
    pub fn turning(turning: AngularVelocity<Space>) -> Result<Self, MotionError> {
        require::finite("the angular velocity of the base", turning.norm())?;
        Ok(Self { turning })
    }

    /// On the Earth at a latitude λ, rad, north positive: x to the east, y to the north, z up, so that it turns at ω_E (0, cos λ, sin λ).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a latitude beyond the poles.
    pub fn on_earth(latitude: f64) -> Result<Self, MotionError> {
        let holds = latitude.abs() <= core::f64::consts::FRAC_PI_2;
        require::that("the latitude of the base", latitude, holds, "between -π/2 and π/2")?;
        let (s, c) = (libm::sin(latitude), libm::cos(latitude));
        Ok(Self { turning: AngularVelocity::new(0.0, Self::EARTH_RATE * c, Self::EARTH_RATE * s) })
    }

    /// Its angular velocity, rad/s.
    pub const fn angular_velocity(&self) -> AngularVelocity<Space> {
        self.turning
    }
}
