//! The motion of a log, once it is known what its numbers mean.

use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// The motion of a log, once it is known what its numbers mean.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadMotion {
    /// When, s, in the scenario's time.
    pub times: Vec<f64>,
    /// R_space_body as quaternions (w, x, y, z), of the length that they have in the log.
    pub attitude: Vec<[f64; 4]>,
    /// ω in body axes, rad/s, where the log has it.
    pub omega: Option<Vec<AngularVelocity<Body>>>,
}
