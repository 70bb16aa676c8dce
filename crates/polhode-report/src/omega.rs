//! An angular velocity in words.

use polhode::math::{AngularVelocity, Body};
use polhode_document::number::{has_digits, tidy, vector_within};
use polhode_document::unit::{DIGITS, rate_within};

/// `ω = (0.01, 1, 0.01) rad/s in body axes, |ω| = 1.0001 rad/s (57.3015 deg/s)`
pub(crate) fn in_words(omega: AngularVelocity<Body>) -> String {
    in_words_within(omega, 0.0)
}

/// The same with the digits that an error (rad/s) leaves.
pub(crate) fn in_words_within(omega: AngularVelocity<Body>, error: f64) -> String {
    if omega.norm() == 0.0 {
        return "at rest: ω = 0".to_owned();
    }
    if !has_digits(omega.norm(), error) {
        return "no digit of ω is right (estimate)".to_owned();
    }
    let shown = vector_within(tidy(omega.to_array()), error, DIGITS);
    format!("ω = {shown} rad/s in body axes, |ω|\u{a0}=\u{a0}{}", rate_within(omega.norm(), error))
}
