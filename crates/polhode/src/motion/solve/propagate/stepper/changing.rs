//! Steps of a body whose mass properties change: what is beside those of the ball in its place.

use std::borrow::Cow;

use super::{Stepper, Steps};
use crate::math::vector::AngularVelocity;
use crate::motion::error::MotionError;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

impl<'a> Stepper<'a> {
    /// What happens to a state as mass goes, or moves within the body, at once.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`]
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

    /// The body as it is at a time of the last step, or now; `None` where that is not known.
    pub(crate) fn rotor_at(&self, time: f64) -> Option<Cow<'a, Rotor>> {
        match &self.piece.changing {
            None => Some(Cow::Borrowed(self.rotor)),
            Some((body, _)) => body.rotor(time).map(Cow::Owned),
        }
    }

    /// True if its mass properties change.
    pub(crate) fn is_changing(&self) -> bool {
        self.history.is_some()
    }

    /// Work and impulse of the last step.
    pub(super) fn account(&mut self) {
        let (span, Self { ledger, steps, piece, .. }) = ([self.from, self.time()], self);
        if let Some(ledger) = ledger {
            ledger.reach(piece, span, &|time| steps.at(time).state);
        }
    }
}
