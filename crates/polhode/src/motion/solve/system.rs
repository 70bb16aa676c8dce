//! Interface of systems that are integrated step by step.

use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;

/// Sample of a motion, which contains a state.
pub(in crate::motion) trait Sampled: Copy {
    /// Returns time, attitude and ω.
    fn state(&self) -> State;
}

/// System that is integrated step by step: a rotor, a body on the ground, a rotor in gimbals.
///
/// The order of calls is `begin`, then any number of evaluations within the step, then `take`. Some
/// systems already take the step in `begin`; `cut` then returns to an earlier time.
pub(in crate::motion) trait System {
    /// Type of a sample of the motion.
    type Sample: Sampled;
    /// Type of a change after which the motion is not known;
    /// [`Infallible`](core::convert::Infallible) for systems without such changes.
    type Change;

    /// Returns the end of the last step, s.
    fn time(&self) -> f64;

    /// Begins a step that ends at `end` or before, and returns its end. Before the time
    /// `first_look`, samples are taken only at the ends of steps.
    ///
    /// # Errors
    /// The reason why a step fails. The time of the system is then not changed.
    fn begin(&mut self, end: f64, first_look: f64) -> Result<f64, MotionError>;

    /// Returns the state at a time within the step.
    fn state_at(&self, time: f64) -> State;

    /// Returns Ω and ω̇ from the equations of motion in a state, body axes; `None` if they are not
    /// available.
    fn rates_of(&self, _: &State) -> Option<[Direction<Body>; 2]> {
        None
    }

    /// Returns a sample at a time within the step, or at the end of the last step.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if the sample is not finite.
    fn sample_at(&self, time: f64) -> Result<Self::Sample, MotionError>;

    /// Ends the step at a time within it, and returns the state there.
    fn cut(&mut self, time: f64) -> State;

    /// Checks that the step may be taken as far as this time.
    ///
    /// # Errors
    /// The reason why it may not.
    fn permit(&self, _: f64) -> Result<(), MotionError> {
        Ok(())
    }

    /// Accepts the step that was begun.
    fn take(&mut self) {}

    /// Prepares the next step towards `end` after a step was taken. Returns the change, if any,
    /// after which the motion is not known.
    ///
    /// # Errors
    /// The reason why the next step fails.
    fn finish(&mut self, end: f64) -> Result<Option<Self::Change>, MotionError>;

    /// Returns true if the torque with this index is switched on.
    fn is_on(&self, _: usize) -> bool {
        false
    }

    /// Switches a torque on or off. The change takes effect at the next [`System::change`].
    fn switch(&mut self, _: usize, _: bool) {}

    /// Updates the acting torques after switches at a time.
    ///
    /// # Errors
    /// The errors of [`System::begin`].
    fn change(&mut self, _: f64) -> Result<(), MotionError> {
        Ok(())
    }

    /// Returns to the last plausible state of a motion that has diverged since a time.
    fn retreat(&mut self, _: f64) {}

    /// Records that a state is sampled.
    fn sampled(&mut self, _: State) {}

    /// Records that an event, with its index, has happened in a state.
    ///
    /// # Errors
    /// The reason why the motion ends there.
    fn crossed(&mut self, _: (&Event, usize), _: State) -> Result<(), MotionError> {
        Ok(())
    }
}
