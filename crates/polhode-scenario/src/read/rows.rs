//! Rows of tables, for prescribed motions and torques.

use polhode::math::Attitude;
use polhode::motion::RateAxes;

/// Rows of a table of a prescribed motion, SI units.
#[derive(Debug)]
pub(crate) enum Rows {
    Attitude { times: Vec<f64>, attitudes: Vec<Attitude> },
    Omega { axes: RateAxes, times: Vec<f64>, omega: Vec<[f64; 3]> },
}

/// Rows of a table of torques, SI units.
#[derive(Debug, Default)]
pub(crate) struct TorqueRows {
    pub times: Vec<f64>,
    pub torques: Vec<[f64; 3]>,
}
