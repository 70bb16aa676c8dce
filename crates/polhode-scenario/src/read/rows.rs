//! The rows of tables: of a prescribed motion, and of a torque.

use polhode::math::Attitude;
use polhode::motion::RateAxes;

/// The rows of a table of a prescribed motion.
#[derive(Debug)]
pub(crate) enum Rows {
    Attitude { times: Vec<f64>, attitudes: Vec<Attitude> },
    Omega { axes: RateAxes, times: Vec<f64>, omega: Vec<[f64; 3]> },
}

/// The rows of a table of torques, in SI.
#[derive(Debug, Default)]
pub(crate) struct TorqueRows {
    pub times: Vec<f64>,
    pub torques: Vec<[f64; 3]>,
}
