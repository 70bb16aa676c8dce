//! State of a rotating body.

use core::fmt;

use crate::math::display::Shown;
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::AngularVelocity;

/// State of a rotating body: time, attitude and angular velocity.
///
/// Attitude and ω are NaN at a time at which a closed form has no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Time, s.
    pub time: f64,
    /// Attitude `R_space_body`.
    pub attitude: Attitude,
    /// Angular velocity relative to space, body axes, rad/s.
    pub omega: AngularVelocity<Body>,
}

/// Error bound of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateError {
    /// Angle between the attitudes, rad; π, the maximum, if the error is unknown.
    pub attitude: f64,
    /// |δω| / |ω|; infinite if the error is unknown, or if ω = 0 and δω ≠ 0.
    pub omega: f64,
}

/// Shows the time, the quaternion of the attitude, and ω.
///
/// ```
/// let omega = polhode::math::AngularVelocity::new(0.1, 0.0, 2.0);
/// let state = polhode::motion::State { time: 1.5, attitude: polhode::math::Attitude::identity(), omega };
/// assert_eq!(state.to_string(), "t = 1.5 s, attitude (1, 0, 0, 0), ω = (0.1, 0, 2) rad/s");
/// ```
impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("t = ")?;
        Shown(self.time).fmt(f)?;
        f.write_str(" s, attitude ")?;
        self.attitude.fmt(f)?;
        f.write_str(", ω = ")?;
        self.omega.fmt(f)
    }
}

impl StateError {
    /// Adds `factor` times another error.
    pub(crate) fn plus(self, other: Self, factor: f64) -> Self {
        let attitude = (self.attitude + factor * other.attitude).min(core::f64::consts::PI);
        Self { attitude, omega: self.omega + factor * other.omega }
    }
}

impl State {
    /// Returns a state with NaN attitude and ω, for a time at which nothing is known.
    #[cold]
    pub(crate) fn unknown(time: f64) -> Self {
        let omega = AngularVelocity::from_array([f64::NAN; 3]);
        Self { time, attitude: Rotation::from_unit([f64::NAN; 4]), omega }
    }

    /// Returns ω in space axes, rad/s.
    pub fn omega_space(&self) -> AngularVelocity<Space> {
        self.attitude * self.omega
    }
}
