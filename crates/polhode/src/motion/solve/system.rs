//! Systems that move step by step.

use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;

/// A sample, which has a state.
pub(in crate::motion) trait Sampled: Copy {
    /// Time, attitude and ω.
    fn state(&self) -> State;
}

/// A system that moves step by step: a rotor, a body on the ground, a rotor in gimbals.
///
/// A step is begun, looked into and taken. Systems whose step is taken when it begins go back where it is cut.
pub(in crate::motion) trait System {
    /// Sample of the motion.
    type Sample: Sampled;
    /// Change after which the motion is not known; [`Infallible`](core::convert::Infallible) of systems that have none.
    type Change;

    /// Time that the last step has reached, s.
    fn time(&self) -> f64;

    /// Begins a step, which ends at `end` or before, and returns its end. Until `first_look` only the end of
    /// steps is sampled.
    ///
    /// # Errors
    /// The reason why a step fails; the time stays that of the last one.
    fn begin(&mut self, end: f64, first_look: f64) -> Result<f64, MotionError>;

    /// State at a time within the step.
    fn state_at(&self, time: f64) -> State;

    /// Ω and ω̇ by the equations of motion in a state, body axes; `None` where they are not at hand.
    fn rates_of(&self, _: &State) -> Option<[Direction<Body>; 2]> {
        None
    }

    /// Sample at a time within the step, or at that of the last one.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`].
    fn sample_at(&self, time: f64) -> Result<Self::Sample, MotionError>;

    /// Ends the step at a time within it, and returns the state there.
    fn cut(&mut self, time: f64) -> State;

    /// Refuses a step that must not be taken as far as this time.
    ///
    /// # Errors
    /// The reason.
    fn permit(&self, _: f64) -> Result<(), MotionError> {
        Ok(())
    }

    /// Takes the step.
    fn take(&mut self) {}

    /// Prepares the next step on the way to `end`, after this one was taken; returns the change after which the
    /// motion is not known.
    ///
    /// # Errors
    /// The reason why there is none.
    fn finish(&mut self, end: f64) -> Result<Option<Self::Change>, MotionError>;

    /// True if a torque is switched on.
    fn is_on(&self, _: usize) -> bool {
        false
    }

    /// Switches a torque on or off, from the next [`System::change`] on.
    fn switch(&mut self, _: usize, _: bool) {}

    /// Looks again at what acts, after switches at a time.
    ///
    /// # Errors
    /// As [`System::begin`].
    fn change(&mut self, _: f64) -> Result<(), MotionError> {
        Ok(())
    }

    /// Goes back to its last plausible state, of a motion that has run away since a time.
    fn retreat(&mut self, _: f64) {}

    /// Notes that a state is sampled.
    fn sampled(&mut self, _: State) {}

    /// Notes that an event, by its number, has happened in a state.
    ///
    /// # Errors
    /// The reason why the motion ends there.
    fn crossed(&mut self, _: (&Event, usize), _: State) -> Result<(), MotionError> {
        Ok(())
    }
}
