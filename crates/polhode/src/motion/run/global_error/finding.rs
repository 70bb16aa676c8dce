//! Findings about the error of a motion.

use crate::body::finding::{Finding, Severity};
use crate::motion::model::state::StateError;
use crate::motion::run::estimated_error::GlobalError;
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;

/// Threshold of the attitude error, rad; smaller errors are not reported.
const SMALL: f64 = 1e-9;
/// Threshold relative to the requested tolerance of a step.
const WITHIN: f64 = 1e4;
/// Threshold for splitting, rad. Its step, and with it the error, is the user's choice.
const SMALL_OF_SPLITTING: f64 = 1e-4;
/// Attitude error, rad, at which no digit is correct.
const LOST: f64 = 0.1;

impl Trajectory {
    /// Returns findings about the error; none without an estimate.
    ///
    /// - `motion.error`: errors have grown far beyond the requested tolerance.
    /// - `motion.inputs`: input rounding has an unexpectedly large effect (thorough estimates
    ///   only).
    pub fn findings(&self) -> Vec<Finding> {
        let Some(error) = self.error() else { return Vec::new() };
        self.computation_finding(error).into_iter().chain(self.input_finding(error)).collect()
    }

    fn computation_finding(&self, error: &GlobalError) -> Option<Finding> {
        let expected = match self.solution() {
            Solution::Splitting { .. } => SMALL_OF_SPLITTING,
            solution => SMALL.max(WITHIN * solution.tolerance().unwrap_or(0.0)),
        };
        let StateError { attitude, omega } = error.end();
        if attitude <= expected {
            return None;
        }
        let message = match self.time_beyond(error.computation(), LOST) {
            Some(time) => format!(
                "no digit of the attitude is correct from t = {time} s on: the motion amplifies the errors of its computation beyond {LOST} rad \
                 (estimate)"
            ),
            None => format!(
                "the motion amplifies errors: at the end the attitude may be off by {attitude:.1e} rad and ω by {omega:.1e} (relative) \
                 (estimate)"
            ),
        };
        Some(Finding { code: "motion.error", severity: Severity::Warning, message, place: None })
    }

    fn input_finding(&self, error: &GlobalError) -> Option<Finding> {
        let StateError { attitude, .. } = error.inputs_end();
        // A cheap estimate gives only an upper bound, which does not prove an effect.
        if attitude <= SMALL || !error.is_thorough() {
            return None;
        }
        let (severity, message) = match self.time_beyond(error.inputs(), LOST) {
            Some(time) => (
                Severity::Warning,
                format!(
                    "from t = {time} s on the attitude holds only for exactly these inputs: half a unit in the last place of the moments or the start \
                     turns it by more than {LOST} rad"
                ),
            ),
            None => (
                Severity::Info,
                format!(
                    "input rounding limits the attitude at the end to {attitude:.1e} rad (half a unit in the last place of the moments and the start); further digits hold only for exactly these inputs"
                ),
            ),
        };
        Some(Finding { code: "motion.inputs", severity, message, place: None })
    }

    /// Returns the time of the first sample whose attitude error exceeds an angle, s.
    fn time_beyond(&self, errors: &[StateError], angle: f64) -> Option<f64> {
        let first = errors.iter().position(|error| !(error.attitude <= angle))?;
        self.samples().get(first).map(|sample| sample.state.time)
    }
}
