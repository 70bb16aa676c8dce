//! A run of an integrator: its steps, its samples, its events, and how it ends.

use super::derivative_log::DerivativeLog;
use super::ending::Ending;
use super::sample::Sample;
use crate::math::vector::AngularMomentum;
use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event, EventAction};
use crate::motion::model::event_detection::{EventDetector, EventSide, Found, Watched};
use crate::motion::model::state::State;
use crate::motion::model::torque::total_potential;
use crate::motion::solve::propagate::balanced::Balanced;
use crate::motion::solve::propagate::stepper::Stepper;

/// The limit on the number of events of a run.
pub(super) const MOST_EVENTS: usize = 1_000_000;

/// A run of an integrator.
pub(super) struct Integration<'a> {
    stepper: Stepper<'a>,
    events: &'a [Event],
    watch: EventDetector<'a>,
    has_potential: bool,
    /// True if a torque may be NaN in some states: the end of each step is looked at.
    has_partial: bool,
    wanted: &'a [f64],
    pub(super) samples: Vec<Sample>,
    pub(super) crossings: Vec<Crossing>,
    /// The derivatives of the motion, if they are wanted.
    pub(super) derivatives: Option<DerivativeLog>,
}

impl<'a> Integration<'a> {
    /// From `start`, to be sampled at the times `wanted`.
    pub(super) fn new(
        stepper: Stepper<'a>,
        (events, sides): (&'a [Event], &[EventSide]),
        start: State,
        wanted: &'a [f64],
    ) -> Self {
        let (rotor, torques) = stepper.subject();
        // Energy that comes and goes with a switch is no potential.
        let has_potential = !stepper.is_changing() && !events.iter().any(Event::switches);
        Self {
            watch: EventDetector::new(rotor, torques, (events, sides), &start),
            samples: Vec::with_capacity(wanted.len()),
            crossings: Vec::new(),
            derivatives: None,
            stepper,
            events,
            has_potential,
            has_partial: torques.iter().any(|torque| torque.model().is_partial()),
            wanted,
        }
    }

    /// With the derivatives that the stepper finds.
    pub(super) fn with_derivatives(self) -> Self {
        Self { derivatives: Some(DerivativeLog::default()), ..self }
    }

    /// On which side of each event's value it is.
    pub(super) fn event_sides(&self) -> Vec<EventSide> {
        self.watch.sides()
    }

    pub(super) const fn stepper(&self) -> &Stepper<'a> {
        &self.stepper
    }

    /// Runs to the last time, as far as it can; gives the sample of the start, and how it ended. `progress` is told the time after
    /// each step; `false` ends the work.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] at the start; [`MotionError::Stopped`] if `progress` said so.
    pub(super) fn run(
        &mut self,
        start: State,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(Sample, Ending), MotionError> {
        // The start as it was given, not as it comes back from principal axes.
        let given = self.sample(Balanced { state: start, work: 0.0, impulse: AngularMomentum::ZERO })?;
        while self.next_wanted().is_some_and(|t| t <= start.time) {
            self.push(given);
        }
        let end = self.wanted.last().copied().unwrap_or(start.time);
        while self.stepper.time() < end {
            let ended = self.advance(end);
            if !progress(self.stepper.time()) {
                return Err(MotionError::Stopped { time: self.stepper.time() });
            }
            if ended == Ok(None) {
                continue;
            }
            let now = match ended {
                Err(MotionError::RunAway { time, .. }) => self.return_to(time),
                _ => self.stepper.now(),
            };
            // The end itself is a sample, if it is one of a finite motion.
            let time = now.state.time;
            if self.samples.last().is_none_or(|last| last.state.time < time)
                && let Ok(last) = if time > start.time { self.sample(now) } else { Ok(given) }
            {
                // Where it runs away, the last plausible state is before the last step.
                if matches!(ended, Err(MotionError::RunAway { .. })) {
                    self.samples.push(last);
                } else {
                    self.push(last);
                }
            }
            let time = self.samples.last().map_or(start.time, |last| last.state.time);
            return Ok((given, Ending::of(ended, time)));
        }
        Ok((given, Ending::Complete))
    }

    /// One step, shortened to a switch on its way; the event that stops the motion, if one does.
    fn advance(&mut self, end: f64) -> Result<Option<usize>, MotionError> {
        let from = self.stepper.time();
        if let Err(cause) = self.stepper.step(end) {
            // It may have gone too far to see that it should not have.
            self.stepper.cut(from);
            return Err(cause);
        }
        // A step may reach a little beyond where its torque is a number.
        if self.has_partial && self.sample(self.stepper.now()).is_err() {
            self.stepper.cut(from);
            return Err(self.stepper.explained(MotionError::NotFinite { time: from }));
        }
        let found = {
            let stepper = &self.stepper;
            let motion =
                Watched { state: &|time| stepper.at(time).state, rates: &|state| stepper.rates_of(state) };
            self.watch.look([from, stepper.time()], &motion)
        };
        let found = found.inspect_err(|_| self.stepper.cut(from))?;
        for (k, first) in found.iter().enumerate() {
            self.fill(first.time, false)?;
            if first.repeats {
                let EventAction::Switch { torque, on } = self.act(first.event) else { continue };
                if self.stepper.is_on(torque) == on {
                    continue;
                }
                self.stepper.cut(first.time);
                return Err(MotionError::Chatter { event: first.event, time: first.time });
            }
            if self.act(first.event) == EventAction::Record {
                self.happen(first, self.stepper.at(first.time).state)?;
                continue;
            }
            // The step ends here. What else is due now, except for rounding, happens now; once, though it may be
            // passed again soon.
            let stepper = &self.stepper;
            let due = self.watch.due(found.get(k..).unwrap_or_default(), &|time| stepper.at(time).state);
            self.stepper.cut(first.time);
            let state = self.stepper.now().state;
            for crossing in &due {
                self.happen(crossing, state)?;
                if let EventAction::Switch { torque, on } = self.act(crossing.event) {
                    self.stepper.switch(torque, on);
                }
            }
            self.watch.cut(&state, &due);
            if due.iter().any(|f| self.events.get(f.event).is_some_and(Event::switches)) {
                self.change(first.time)?;
            }
            self.fill(first.time, true)?;
            let stop = due.iter().find(|f| self.act(f.event) == EventAction::Stop);
            return stop
                .map_or_else(|| look_ahead(&mut self.stepper, end).map(|()| None), |f| Ok(Some(f.event)));
        }
        self.fill(self.stepper.time(), true)?;
        look_ahead(&mut self.stepper, end).map(|()| None)
    }

    /// Looks again at what acts now, after a switch. Where its time changes, so does the state after it: by (ẋ⁻ − ẋ⁺) δt.
    fn change(&mut self, time: f64) -> Result<(), MotionError> {
        let before = self.stepper.rates_at(time);
        self.stepper.change()?;
        if let Some(times) = self.derivatives.as_mut().and_then(DerivativeLog::take_switch) {
            let after = self.stepper.rates_at(time);
            self.stepper.jump(&times, [before[0] - after[0], before[1] - after[1]]);
        }
        Ok(())
    }

    /// Forgets what came after a time, that of the last plausible state.
    fn return_to(&mut self, time: f64) -> Balanced {
        self.samples.retain(|sample| sample.state.time <= time);
        self.crossings.retain(|crossing| crossing.state.time <= time);
        if let Some(derivatives) = &mut self.derivatives {
            derivatives.forget_after(time);
        }
        self.stepper.last_plausible().unwrap_or_else(|| self.stepper.now())
    }

    fn act(&self, event: usize) -> EventAction {
        self.events.get(event).map_or(EventAction::Record, Event::action)
    }

    /// Writes an event down.
    fn happen(
        &mut self,
        &Found { time, event, rising, .. }: &Found,
        state: State,
    ) -> Result<(), MotionError> {
        if self.crossings.len() == MOST_EVENTS {
            return Err(MotionError::TooManyEvents { time, most: MOST_EVENTS });
        }
        let state = State { time, ..state };
        if let (Some(derivatives), Some(of)) = (&mut self.derivatives, self.events.get(event)) {
            derivatives.cross(&self.stepper, (of, event), state)?;
        }
        let name = self.events.get(event).map_or("", Event::name).to_owned();
        self.crossings.push(Crossing { event, name, state, rising });
        Ok(())
    }

    fn next_wanted(&self) -> Option<f64> {
        self.wanted.get(self.samples.len()).copied()
    }

    /// Samples the last step up to a time, or to just before it.
    fn fill(&mut self, until: f64, included: bool) -> Result<(), MotionError> {
        while let Some(t) = self.next_wanted().filter(|&t| t < until || included && t == until) {
            let now = t == self.stepper.time();
            let sample = self.sample(if now { self.stepper.now() } else { self.stepper.at(t) })?;
            self.push(sample);
        }
        Ok(())
    }

    fn push(&mut self, sample: Sample) {
        if let Some(derivatives) = &mut self.derivatives {
            derivatives.sample(&self.stepper, sample.state);
        }
        self.samples.push(sample);
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

/// Gives up as soon as it can be seen that the motion runs away, or that the end is too many steps away.
pub(super) fn look_ahead(stepper: &mut Stepper<'_>, end: f64) -> Result<(), MotionError> {
    stepper.require_bounded(end)
}
