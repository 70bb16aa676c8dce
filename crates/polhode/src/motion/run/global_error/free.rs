//! The error of a free motion, which needs no simulation.

use super::compared_samples::ComparedSamples;
use super::estimation::input_error;
use super::inputs::Change;
use crate::math::symmetric3::Symmetric3;
use crate::motion::error::MotionError;
use crate::motion::model::state::StateError;
use crate::motion::run::estimated_error::GlobalError;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::free::FreeMotion;
use crate::motion::solve::reach::ALLOWED;

/// Bound on the rounding of a state by the formulas. Of 300 random bodies and up to 100 turns the
/// largest is 1.5e-15 rad and 8.2e-16 (`tests/all/error_estimate`), whatever the time.
const FORMULA_ROUNDING: StateError = StateError { attitude: 2e-15, omega: 1e-15 };

impl FreeMotion {
    /// Estimates of the error of the states at some times: that of the formulas, which is measured (`book/accuracy.md`), and what the last
    /// bit of moments and start is worth, which grows with time as t ∂Ω/∂I. The times may be in any order.
    ///
    /// ```
    /// use polhode::math::{AngularVelocity, Attitude};
    /// use polhode::motion::{FreeMotion, State};
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    /// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
    /// let error = motion.global_error(&[1e3, 1e9]);
    /// assert!(error.end().attitude < 2.1e-15); // right for these numbers
    /// assert!(error.inputs_end().attitude > 1e-8); // which nobody knows so well
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    pub fn global_error(&self, times: &[f64]) -> GlobalError {
        let (start, after) = (self.start(), |time: f64| (time - self.start().time).abs());
        let computation = times.iter().map(|time| self.formula_error(after(*time))).collect();
        // What grows along the way does so from the start on, whatever the order of the times.
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&a, &b| after(times[a]).total_cmp(&after(times[b])));
        let outward: Vec<f64> = order.iter().map(|&k| times[k]).collect();
        let watched = ComparedSamples::of(self.at_times(&outward), 1);
        let found = input_error(&watched, |seed, amplitude| {
            let mut change = Change::new((seed, amplitude));
            let tensor = change.inertia(&self.tensor());
            Self::of_symmetric(&tensor, change.start(start))
                .map_or_else(|_| Vec::new(), |motion| motion.at_times(&watched.times))
        });
        let mut inputs = found.clone();
        for (k, error) in order.into_iter().zip(found) {
            inputs[k] = error;
        }
        GlobalError { is_thorough: true, computation, inputs }
    }

    /// Bound on the error of the formulas alone, `after` seconds from the start: rounding, which
    /// does not grow with time, and the drift of the phase ([`FreeMotion::reach`]).
    ///
    /// Rounding is bounded by 2e-15 rad and 1e-15 of ω. The motion is that of the rotor's tensor:
    /// the rounding of a tensor about a pivot, or of a body of several parts, is not included.
    pub fn formula_error(&self, after: f64) -> StateError {
        let drift = ALLOWED * (after.abs() / self.reach()).min(1.0);
        FORMULA_ROUNDING.plus(StateError { attitude: drift, omega: drift }, 1.0)
    }

    /// R diag(i) Rᵀ
    fn tensor(&self) -> Symmetric3 {
        let principal = self.principal();
        Symmetric3::diagonal(principal.moments()).rotated(&principal.rotation().matrix())
    }
}

impl Trajectory {
    /// [`Trajectory::of_motion`] with the estimate of its error.
    ///
    /// # Errors
    /// As [`Trajectory::of_motion`].
    pub fn of_motion_with_error(motion: FreeMotion, times: &[f64]) -> Result<Self, MotionError> {
        let error = motion.global_error(times);
        Ok(Self::of_motion(motion, times)?.with_error(Some(error)))
    }
}
