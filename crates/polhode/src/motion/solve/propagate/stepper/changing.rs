//! Extensions of [`Stepper`] for a body with changing mass properties. The integrator steps a ball
//! in place of the body.

use std::borrow::Cow;

use super::{Stepper, Steps};
use crate::math::vector::AngularVelocity;
use crate::motion::error::MotionError;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

impl<'a> Stepper<'a> {
    /// Applies an instantaneous change of the mass properties to a state: mass leaves, or moves
    /// within the body.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if the body before the change is not known.
    pub(super) fn jump_of_mass(&mut self, history: &MassHistory, state: State) -> Result<State, MotionError> {
        let time = state.time;
        let pivot = self.rotor.is_pivoted().then(|| self.rotor.point());
        let before = self.rotor_at(time).ok_or(MotionError::NotFinite { time })?.into_owned();
        let after = history.rotor(time, pivot)?;
        let mut there = state;
        if history.keeps_momentum(time) {
            let momentum = before.angular_momentum(state.omega);
            there.omega = after.acceleration(AngularVelocity::ZERO, momentum.as_quantity()).as_quantity();
            let more = there.omega - state.omega;
            match &mut self.steps {
                Steps::Taylor(taylor) => taylor.kick(more),
                Steps::Dop853(dop853) => dop853.kick(more),
                Steps::Splitting(_) => {}
            }
        }
        if let Some(ledger) = &mut self.ledger {
            ledger.jump([&before, &after], [&state, &there]);
        }
        Ok(there)
    }

    /// Returns the body at a time of the last step, or now; `None` if it is not known.
    pub(crate) fn rotor_at(&self, time: f64) -> Option<Cow<'a, Rotor>> {
        match &self.piece.changing {
            None => Some(Cow::Borrowed(self.rotor)),
            Some((body, _)) => body.rotor(time).map(Cow::Owned),
        }
    }

    /// Returns true if the mass properties change.
    pub(crate) fn is_changing(&self) -> bool {
        self.history.is_some()
    }

    /// Updates work and impulse for the last step.
    pub(super) fn account(&mut self) {
        let (span, Self { ledger, steps, piece, .. }) = ([self.from, self.time()], self);
        if let Some(ledger) = ledger {
            ledger.reach(piece, span, &|time| steps.at(time).state);
        }
    }
}
