//! Rotor under torques as a [`System`].

use core::convert::Infallible;

use super::derivative_log::DerivativeLog;
use super::sample::Sample;
use crate::math::frame::Body;
use crate::math::vector::{AngularMomentum, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;
use crate::motion::model::torque::total_potential;
use crate::motion::solve::propagate::balanced::Balanced;
use crate::motion::solve::propagate::stepper::Stepper;
use crate::motion::solve::system::{Sampled, System};

/// Rotor under torques, integrated step by step.
pub(super) struct Turning<'a> {
    stepper: Stepper<'a>,
    has_potential: bool,
    /// True if a torque may be NaN in some states. The end of each step is then checked.
    has_partial: bool,
    /// Derivatives of the motion, if requested.
    pub(super) derivatives: Option<DerivativeLog>,
    /// Last plausible state of a motion that has diverged.
    plausible: Option<Balanced>,
}

impl<'a> Turning<'a> {
    /// Creates the system from a stepper, and the events that may switch its torques.
    pub(super) fn new(stepper: Stepper<'a>, events: &[Event]) -> Self {
        let (_, torques) = stepper.subject();
        // A torque that is switched has no potential.
        let has_potential = !stepper.is_changing() && !events.iter().any(Event::switches);
        let has_partial = torques.iter().any(|torque| torque.model().is_partial());
        Self { stepper, has_potential, has_partial, derivatives: None, plausible: None }
    }

    /// Enables the record of derivatives.
    pub(super) fn with_derivatives(self) -> Self {
        Self { derivatives: Some(DerivativeLog::default()), ..self }
    }

    pub(super) const fn stepper(&self) -> &Stepper<'a> {
        &self.stepper
    }

    /// Returns the sample of the start as given, without the rounding of the conversion to
    /// principal axes.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if energy or momentum are not finite.
    pub(super) fn first(&self, start: State) -> Result<Sample, MotionError> {
        self.sample(Balanced { state: start, work: 0.0, impulse: AngularMomentum::ZERO })
    }

    fn sample(&self, balanced: Balanced) -> Result<Sample, MotionError> {
        let (_, torques) = self.stepper.subject();
        let time = balanced.state.time;
        let rotor = &*self.stepper.rotor_at(time).ok_or(MotionError::NotFinite { time })?;
        let potential =
            self.has_potential.then(|| total_potential(torques, rotor, &balanced.state)).flatten();
        Sample::of(rotor, self.stepper.switched_on(), potential, balanced)
    }
}

impl Sampled for Sample {
    fn state(&self) -> State {
        self.state
    }
}

impl System for Turning<'_> {
    type Sample = Sample;
    type Change = Infallible;

    fn time(&self) -> f64 {
        self.plausible.as_ref().map_or_else(|| self.stepper.time(), |last| last.state.time)
    }

    fn begin(&mut self, end: f64, _: f64) -> Result<f64, MotionError> {
        let from = self.stepper.time();
        if let Err(cause) = self.stepper.step(end) {
            // The step may have ended where the failure is no longer visible, so return to its
            // start.
            self.stepper.cut(from);
            return Err(cause);
        }
        // A step may end slightly beyond the states in which its torque is finite.
        if self.has_partial && self.sample(self.stepper.now()).is_err() {
            self.stepper.cut(from);
            return Err(self.stepper.explained(MotionError::NotFinite { time: from }));
        }
        Ok(self.stepper.time())
    }

    fn state_at(&self, time: f64) -> State {
        self.stepper.at(time).state
    }

    fn rates_of(&self, state: &State) -> Option<[Direction<Body>; 2]> {
        self.stepper.rates_of(state)
    }

    fn sample_at(&self, time: f64) -> Result<Sample, MotionError> {
        self.sample(match &self.plausible {
            Some(last) => *last,
            None if time == self.stepper.time() => self.stepper.now(),
            None => self.stepper.at(time),
        })
    }

    fn cut(&mut self, time: f64) -> State {
        self.stepper.cut(time);
        self.stepper.now().state
    }

    fn finish(&mut self, end: f64) -> Result<Option<Infallible>, MotionError> {
        // Stop as soon as the motion diverges, or the end is too many steps away.
        self.stepper.require_bounded(end).map(|()| None)
    }

    fn is_on(&self, torque: usize) -> bool {
        self.stepper.is_on(torque)
    }

    fn switch(&mut self, torque: usize, on: bool) {
        self.stepper.switch(torque, on);
    }

    /// Updates the derivatives too: a change δt of the time of a switch changes the state after it
    /// by (ẋ⁻ − ẋ⁺) δt.
    fn change(&mut self, time: f64) -> Result<(), MotionError> {
        let before = self.stepper.rates_at(time);
        self.stepper.change()?;
        if let Some(times) = self.derivatives.as_mut().and_then(DerivativeLog::take_switch) {
            let after = self.stepper.rates_at(time);
            self.stepper.jump(&times, [before[0] - after[0], before[1] - after[1]]);
        }
        Ok(())
    }

    fn retreat(&mut self, time: f64) {
        if let Some(derivatives) = &mut self.derivatives {
            derivatives.forget_after(time);
        }
        self.plausible = self.stepper.last_plausible();
    }

    fn sampled(&mut self, state: State) {
        if let Some(derivatives) = &mut self.derivatives {
            derivatives.sample(&self.stepper, state);
        }
    }

    fn crossed(&mut self, of: (&Event, usize), state: State) -> Result<(), MotionError> {
        match &mut self.derivatives {
            Some(derivatives) => derivatives.cross(&self.stepper, of, state),
            None => Ok(()),
        }
    }
}
