//! Error of a free motion, without a simulation.

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

/// Bound on the rounding error of the formulas. For 300 random bodies and up to 100 turns the
/// largest error is 1.5e-15 rad and 8.2e-16 (`tests/all/error_estimate`), independent of time.
const FORMULA_ROUNDING: StateError = StateError { attitude: 2e-15, omega: 1e-15 };

impl FreeMotion {
    /// Estimates the error of the states at some times, which may be in any order.
    ///
    /// The error of the computation is the measured error of the formulas (`book/accuracy.md`). The
    /// effect of input rounding grows with time as t ∂Ω/∂I.
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
        // Accumulated errors grow from the start outwards, whatever the order of the times.
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

    /// Returns a bound on the error of the formulas, `after` seconds from the start. It contains
    /// rounding, which does not grow with time, and the drift of the phase ([`FreeMotion::reach`]).
    ///
    /// Rounding is bounded by 2e-15 rad and 1e-15 of ω. The bound refers to the tensor of the
    /// rotor. The rounding of a tensor about a pivot, or of a body with several parts, is not
    /// included.
    pub fn formula_error(&self, after: f64) -> StateError {
        let drift = ALLOWED * (after.abs() / self.reach()).min(1.0);
        FORMULA_ROUNDING.plus(StateError { attitude: drift, omega: drift }, 1.0)
    }

    /// Returns the inertia tensor R diag(i) Rᵀ, body axes.
    fn tensor(&self) -> Symmetric3 {
        let principal = self.principal();
        Symmetric3::diagonal(principal.moments()).rotated(&principal.rotation().matrix())
    }
}

impl Trajectory {
    /// Like [`Trajectory::of_motion`], with an estimate of the error.
    ///
    /// # Errors
    /// The errors of [`Trajectory::of_motion`].
    pub fn of_motion_with_error(motion: FreeMotion, times: &[f64]) -> Result<Self, MotionError> {
        let error = motion.global_error(times);
        Ok(Self::of_motion(motion, times)?.with_error(Some(error)))
    }
}
