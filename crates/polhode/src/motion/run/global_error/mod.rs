//! The global error of a computed motion: an estimate of how far its states are from the true ones.
//!
//! Balances of energy and momentum cannot see it: a motion that amplifies small errors keeps them
//! and still diverges from the exact solution. So the motion is computed again, and the distance
//! between the runs is the estimate ([`comparison`]). One run is made at the tightest tolerance, by
//! Taylor's method where the torques have power series: its own truncation error is below rounding,
//! so that its distance is the truncation error of the motion, whatever set the length of its steps.
//! Others start from body and start changed by more than their rounding, and add noise larger than
//! rounding after each step. Each error is amplified from where it arises to the end by the full
//! equations: with events, schedules and friction, and beyond linearity.
//!
//! Rounding is amplified so much that a sample that is small by chance is still no smaller than the
//! error; there remains the chance that all samples of an effort are small. [`ErrorEffort`] states
//! what that costs.
//!
//! A closed form has no steps. Its error is that of its formulas, which are measured: `book/accuracy.md`.
//!
//! What the last bit of the inputs is worth is found in the same way, with the inputs alone made different: it is no error of the
//! computation, but nobody knows a body better than that.
//!
//! # Sources
//! Kenney, Laub, SIAM J. Sci. Comput. 15 (1994) 36 (condition from few random samples); Vignes, Math. Comput. Simul. 35 (1993) 233
//! (rounding by random perturbation); Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.4 (global error).

mod compared_samples;
mod comparison;
mod estimation;
mod finding;
mod free;
mod held;
pub(crate) mod in_gimbals;
mod inputs;
pub(crate) mod on_ground;
mod perturbed;

use crate::motion::model::state::StateError;

/// How much work an estimate is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ErrorEffort {
    /// [`ErrorEffort::Thorough`] where that takes a few hundredths of a second at most, [`ErrorEffort::Cheap`] elsewhere.
    #[default]
    Auto,
    /// Two comparison runs: one at the tightest tolerance, and one with larger rounding than in
    /// thorough runs, as it is a single sample.
    Cheap,
    /// Thirteen comparison runs: one at the tightest tolerance, eight with larger rounding, and four
    /// from other inputs.
    Thorough,
}

/// Estimates of the error of each sample of a trajectory.
///
/// The attitude's grow along the way: an angle that happens to be right between two times that are not is no merit.
///
/// # Accuracy
/// The target at every tolerance: the true error is at most twice the stated one. `book/error.md`
/// has what it bounds, what it costs, and how good it is for motions of all torque models, chaotic,
/// damped and stiff ones among them.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{ErrorEffort, Orbit};
/// use polhode::motion::torque::{Attracted, GravityGradient};
/// // A satellite that tumbles in the gravity gradient is chaotic: an error grows five million times within 100 s.
/// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let rotor = Rotor::free(&body);
/// let orbit = Orbit::circular_at_rate(1.0, 0.5, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0))?;
/// let torques = [TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted: Attracted::Tensor }))];
/// let simulation = Simulation {
///     rotor: &rotor,
///     history: None,
///     torques: &torques,
///     switched_off: &[],
///     start: State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) },
///     events: &[],
///     event_sides: &[],
///     times: &[50.0, 100.0],
///     method: Method::Auto,
///     tolerance: 1e-13,
/// };
/// let motion = simulation.run()?;
/// let error = simulation.global_error(&motion, ErrorEffort::Cheap).ok_or("it is computed")?;
/// assert!(error.end().attitude > 1e-9);
/// assert!(Drift::of(&motion).ok_or("it has samples")?.momentum < 1e-13); // which drift does not see
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalError {
    is_thorough: bool,
    computation: Vec<StateError>,
    inputs: Vec<StateError>,
}

/// What rounding a state to doubles leaves, attitude in rad and ω relative.
const ROUNDING: StateError = StateError { attitude: 5e-16, omega: 3e-16 };
const NONE: StateError = StateError { attitude: 0.0, omega: 0.0 };

impl ErrorEffort {
    const fn is_thorough(self, work: u64, few: u64) -> bool {
        match self {
            Self::Thorough => true,
            Self::Cheap => false,
            Self::Auto => work <= few,
        }
    }
}

impl GlobalError {
    /// True if it was [`ErrorEffort::Thorough`].
    pub const fn is_thorough(&self) -> bool {
        self.is_thorough
    }

    /// Estimates of the error of the computation, at each sample.
    pub fn computation(&self) -> &[StateError] {
        &self.computation
    }

    /// What the last bit of the inputs (the body's moments, lever, ω and attitude at the start) is worth, at each sample: half a unit in
    /// the last place of each, rounded either way at random. Of a cheap estimate, at most so much.
    pub fn inputs(&self) -> &[StateError] {
        &self.inputs
    }

    /// The error of the computation at the last sample.
    pub fn end(&self) -> StateError {
        self.computation.last().copied().unwrap_or(ROUNDING)
    }

    /// What the last bit of the inputs is worth at the last sample.
    pub fn inputs_end(&self) -> StateError {
        self.inputs.last().copied().unwrap_or(NONE)
    }
}
