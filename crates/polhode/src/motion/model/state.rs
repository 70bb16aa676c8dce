//! The state of a turning body.

use core::fmt;

use crate::math::display::Shown;
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::AngularVelocity;

/// Where a body points, how it turns, and when.
///
/// Of a time at which a closed form is not known attitude and ω are not numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Time, s.
    pub time: f64,
    /// R_space_body.
    pub attitude: Attitude,
    /// ω relative to space, in body axes, rad/s.
    pub omega: AngularVelocity<Body>,
}

/// How far a state may be from the true one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateError {
    /// The angle between the attitudes, rad; π, the largest that there is, where nothing is known.
    pub attitude: f64,
    /// |δω| / |ω|; infinite where nothing is known, or ω = 0 and δω is not.
    pub omega: f64,
}

/// The time, the attitude's quaternion, and ω.
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
    /// Adds another error, times a factor.
    pub(crate) fn plus(self, other: Self, factor: f64) -> Self {
        let attitude = (self.attitude + factor * other.attitude).min(core::f64::consts::PI);
        Self { attitude, omega: self.omega + factor * other.omega }
    }
}

impl State {
    /// Of a time at which nothing is known.
    #[cold]
    pub(crate) fn unknown(time: f64) -> Self {
        let omega = AngularVelocity::from_array([f64::NAN; 3]);
        Self { time, attitude: Rotation::from_unit([f64::NAN; 4]), omega }
    }

    /// ω in space axes, rad/s.
    pub fn omega_space(&self) -> AngularVelocity<Space> {
        self.attitude * self.omega
    }
}
