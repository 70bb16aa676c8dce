//! The rows of a table of a prescribed motion.

use polhode::math::Attitude;
use polhode::motion::RateAxes;

/// The rows of a table of a prescribed motion.
#[derive(Debug)]
pub(crate) enum Rows {
    Attitude { times: Vec<f64>, attitudes: Vec<Attitude> },
    Omega { axes: RateAxes, times: Vec<f64>, omega: Vec<[f64; 3]> },
}
