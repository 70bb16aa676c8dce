//! Sample times and method of a motion.

use crate::motion::solve::method::Method;

/// Sample times and method of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Sample times, s, ascending.
    pub times: Vec<f64>,
    /// Method of computation.
    pub method: Method,
    /// Bound on the error of each step: attitude in rad, ω relative.
    pub tolerance: f64,
}

impl Run {
    /// Creates a run with `samples` evenly spaced times from 0 to `duration`, both included, s.
    pub fn evenly(duration: f64, samples: usize, method: Method, tolerance: f64) -> Self {
        let last = samples.saturating_sub(1).max(1) as f64;
        let times = (0..samples).map(|k| duration * (k as f64 / last)).collect();
        Self { times, method, tolerance }
    }
}
