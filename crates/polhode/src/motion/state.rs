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

/// The time, the attitude's quaternion, and ω.
///
/// ```
/// let omega = polhode::AngularVelocity::new(0.1, 0.0, 2.0);
/// let state = polhode::State { time: 1.5, attitude: polhode::Attitude::identity(), omega };
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
