//! Loop over the steps of a system: samples, events, and the ending.

use super::ending::{Ending, Halt};
use crate::motion::contact::ContactChange;
use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event, EventAction};
use crate::motion::model::event_detection::{EventDetector, Found, Watched};
use crate::motion::model::state::State;
use crate::motion::solve::limits::MOST_EVENTS;
use crate::motion::solve::system::{Sampled, System};

/// Run of a system through the times at which it is sampled.
pub(super) struct March<'a, S: System> {
    pub(super) system: S,
    events: &'a [Event],
    detector: EventDetector<'a>,
    wanted: &'a [f64],
    pub(super) samples: Vec<S::Sample>,
    pub(super) crossings: Vec<Crossing>,
}

impl<'a, S: System<Change: Into<ContactChange>>> March<'a, S> {
    /// Creates a run that is sampled at the times `wanted`, with the events of the detector.
    pub(super) fn new(system: S, detector: EventDetector<'a>, wanted: &'a [f64]) -> Self {
        let samples = Vec::with_capacity(wanted.len());
        Self { system, events: detector.events(), detector, wanted, samples, crossings: Vec::new() }
    }

    /// Returns the event detector, which stores the side of each event's value on which the motion
    /// is.
    pub(super) const fn detector(&self) -> &EventDetector<'a> {
        &self.detector
    }

    /// Runs from the sample `start` to the last time, or as far as possible. If `halted` is given,
    /// the motion does not begin. `progress` receives the time after each step; if it returns
    /// `false`, the computation stops.
    ///
    /// # Errors
    /// [`MotionError::Stopped`] if `progress` returned `false`.
    pub(super) fn run(
        &mut self,
        start: S::Sample,
        halted: Option<Halt>,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Ending, MotionError> {
        let begun = start.state().time;
        while self.next_wanted().is_some_and(|t| t <= begun) {
            self.push(start);
        }
        let end = self.wanted.last().copied().unwrap_or(begun);
        let mut ended = Ok(halted);
        while ended == Ok(None) && self.system.time() < end {
            ended = self.step(end);
            if !progress(self.system.time()) {
                return Err(MotionError::Stopped { time: self.system.time() });
            }
        }
        if ended == Ok(None) {
            return Ok(Ending::Complete);
        }
        let run_away = match ended {
            Err(MotionError::RunAway { time, .. }) => Some(time),
            _ => None,
        };
        if let Some(time) = run_away {
            self.samples.retain(|sample| sample.state().time <= time);
            self.crossings.retain(|crossing| crossing.state.time <= time);
            self.system.retreat(time);
        }
        // The state at the end becomes a sample, if it is finite.
        let time = self.system.time();
        if self.last_sampled().is_none_or(|last| last < time)
            && let Ok(last) = if time > begun { self.system.sample_at(time) } else { Ok(start) }
        {
            // If the motion diverges, the last plausible state is before the last step.
            if run_away.is_some() {
                self.samples.push(last);
            } else {
                self.push(last);
            }
        }
        Ok(Ending::of(ended, self.last_sampled().unwrap_or(begun)))
    }

    /// Takes one step, shortened to a switch or a stop within it. Returns the reason if the motion
    /// ends there.
    fn step(&mut self, end: f64) -> Result<Option<Halt>, MotionError> {
        let from = self.system.time();
        // Events are located within each step.
        let first_look = if self.events.is_empty() { self.next_wanted().unwrap_or(end) } else { from };
        let to = self.system.begin(end, first_look)?;
        let found = {
            let system = &self.system;
            let motion =
                Watched { state: &|time| system.state_at(time), rates: &|state| system.rates_of(state) };
            self.detector.look([from, to], &motion)
        };
        let found = found.inspect_err(|_| {
            self.system.cut(from);
        })?;
        for (k, first) in found.iter().enumerate() {
            self.fill(first.time, false)?;
            if first.repeats {
                let EventAction::Switch { torque, on } = self.act(first.event) else { continue };
                if self.system.is_on(torque) == on {
                    continue;
                }
                self.system.cut(first.time);
                return Err(MotionError::Chatter { event: first.event, time: first.time });
            }
            if self.act(first.event) == EventAction::Record {
                self.happen(first, self.system.state_at(first.time))?;
                continue;
            }
            // The step ends here. All events that are due at this time, up to rounding, happen now.
            // Each happens only once, even if it is passed again soon.
            let system = &self.system;
            let due = self.detector.due(found.get(k..).unwrap_or_default(), &|time| system.state_at(time));
            let state = self.system.cut(first.time);
            for crossing in &due {
                self.happen(crossing, state)?;
                if let EventAction::Switch { torque, on } = self.act(crossing.event) {
                    self.system.switch(torque, on);
                }
            }
            self.detector.cut(&state, &due);
            if due.iter().any(|f| self.events.get(f.event).is_some_and(Event::switches)) {
                self.system.change(first.time)?;
            }
            self.fill(first.time, true)?;
            self.system.take();
            let stop = due.iter().find(|f| self.act(f.event) == EventAction::Stop);
            return match stop {
                Some(f) => Ok(Some(Halt::Event(f.event))),
                None => self.finish(end),
            };
        }
        self.fill(to, true)?;
        self.system.take();
        self.finish(end)
    }

    fn finish(&mut self, end: f64) -> Result<Option<Halt>, MotionError> {
        Ok(self.system.finish(end)?.map(|change| Halt::Change(change.into())))
    }

    fn act(&self, event: usize) -> EventAction {
        self.events.get(event).map_or(EventAction::Record, Event::action)
    }

    /// Records an event.
    fn happen(
        &mut self,
        &Found { time, event, rising, .. }: &Found,
        state: State,
    ) -> Result<(), MotionError> {
        if self.crossings.len() == MOST_EVENTS {
            return Err(MotionError::TooManyEvents { time, most: MOST_EVENTS });
        }
        let state = State { time, ..state };
        let Some(of) = self.events.get(event) else { return Ok(()) };
        self.system.crossed((of, event), state)?;
        self.crossings.push(Crossing { event, name: of.name().to_owned(), state, rising });
        Ok(())
    }

    fn next_wanted(&self) -> Option<f64> {
        self.wanted.get(self.samples.len()).copied()
    }

    fn last_sampled(&self) -> Option<f64> {
        self.samples.last().map(|last| last.state().time)
    }

    /// Samples the step up to a time, or to just before it if `included` is false.
    fn fill(&mut self, until: f64, included: bool) -> Result<(), MotionError> {
        self.system.permit(until)?;
        while let Some(t) = self.next_wanted().filter(|&t| t < until || included && t == until) {
            let sample = self.system.sample_at(t)?;
            self.push(sample);
        }
        Ok(())
    }

    fn push(&mut self, sample: S::Sample) {
        self.system.sampled(sample.state());
        self.samples.push(sample);
    }
}
