//! Estimated error of a trajectory, sample by sample.

use crate::motion::model::state::StateError;

/// Estimated error of each sample of a trajectory.
///
/// The attitude error never decreases along the motion. An angle that happens to be right between
/// two wrong ones does not count.
///
/// # Accuracy
/// Target at every tolerance: the true error is at most twice the stated one. `book/error.md`
/// describes what the estimate bounds, its cost, and its quality for motions of all torque models.
/// These include chaotic, damped and stiff motions.
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
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
/// let simulation = Simulation::new(&rotor, &torques, start, &[50.0, 100.0]);
/// let motion = simulation.run()?;
/// let error = simulation.global_error(&motion, ErrorEffort::Cheap).ok_or("it is computed")?;
/// assert!(error.end().attitude > 1e-9);
/// assert!(Drift::of(&motion).ok_or("it has samples")?.momentum < 1e-13); // which drift does not see
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GlobalError {
    pub(super) is_thorough: bool,
    pub(super) computation: Vec<StateError>,
    pub(super) inputs: Vec<StateError>,
}

/// Error of a state by rounding to f64: attitude in rad, ω relative.
pub(super) const ROUNDING: StateError = StateError { attitude: 5e-16, omega: 3e-16 };
pub(super) const NONE: StateError = StateError { attitude: 0.0, omega: 0.0 };

impl GlobalError {
    /// Returns true if the effort was
    /// [`ErrorEffort::Thorough`](crate::motion::ErrorEffort::Thorough).
    pub const fn is_thorough(&self) -> bool {
        self.is_thorough
    }

    /// Returns the estimated error of the computation at each sample.
    pub fn computation(&self) -> &[StateError] {
        &self.computation
    }

    /// Returns the effect of input rounding at each sample. Inputs are the body's moments, its
    /// lever, and ω and attitude at the start, each changed by half a unit in the last place with
    /// random sign. A cheap estimate gives upper bounds.
    pub fn inputs(&self) -> &[StateError] {
        &self.inputs
    }

    /// Returns the estimated error of the computation at the last sample.
    pub fn end(&self) -> StateError {
        self.computation.last().copied().unwrap_or(ROUNDING)
    }

    /// Returns the effect of input rounding at the last sample.
    pub fn inputs_end(&self) -> StateError {
        self.inputs.last().copied().unwrap_or(NONE)
    }
}
