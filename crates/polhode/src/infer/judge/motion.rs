//! Motion of a log with the determined meaning of its numbers.

use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// Motion of a log, after the meaning of its numbers has been determined.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadMotion {
    /// Times of the rows, s, on the scenario's clock.
    pub times: Vec<f64>,
    /// Attitudes R_space_body as quaternions (w, x, y, z), with their length in the log.
    pub attitude: Vec<[f64; 4]>,
    /// Angular velocities ω, body axes, rad/s, if the log has them.
    pub omega: Option<Vec<AngularVelocity<Body>>>,
}
