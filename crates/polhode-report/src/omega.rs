//! An angular velocity in words.

use polhode::{AngularVelocity, Body};

use crate::number::{tidy, vector};
use crate::unit::{DIGITS, rate};

/// `ω = (0.01, 1, 0.01) rad/s in body axes, |ω| = 1.0001 rad/s (57.3015 deg/s)`
pub(crate) fn in_words(omega: AngularVelocity<Body>) -> String {
    if omega.norm() == 0.0 {
        return "at rest: ω = 0".to_owned();
    }
    let shown = vector(tidy(omega.to_array()), DIGITS);
    format!("ω = {shown} rad/s in body axes, |ω|\u{a0}=\u{a0}{}", rate(omega.norm()))
}
