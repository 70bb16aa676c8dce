//! Event detection along an interval of a motion with dense output.
//!
//! An interval is divided into pieces. In each piece the body turns by less than 0.3 rad, and the
//! phase of a formula or function advances by less than that. Pieces are halved where the gap of an
//! event reverses or is not yet resolved. A passage is located to the rounding of the time. Two
//! passages within 10⁻³ of the length of a piece are missed if neither values nor slopes at the
//! ends of the piece show them. An example is a short pulse of a formula.
//!
//! A function may be constant along the exact motion, such as the kinetic energy of a torque-free
//! body. Then its rate by the equations of motion is zero, and its change in a step is the error of
//! the step. Such a change is not a crossing.

use super::passage::{Course, Passages, Pieces};
use crate::math::frame::Body;
use crate::math::frequency::frequency;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

pub use super::passage::EventSide;

/// Safety factor of the residual that a function has at a crossing.
const RESIDUAL: f64 = 4.0;

/// Rounding of the rate of a function, relative to the size of its terms times the rate of change
/// of the state.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Motion within an interval.
pub(crate) struct Watched<'m> {
    /// State as a function of time.
    pub(crate) state: &'m dyn Fn(f64) -> State,
    /// Ω and ω̇ from the equations of motion, body axes. `None` if the motion has no errors that
    /// accumulate, or if the equations are not available.
    pub(crate) rates: &'m dyn Fn(&State) -> Option<[Direction<Body>; 2]>,
}

/// Sampling times in a part of an interval, and the states at these times.
struct Looks {
    pieces: Pieces,
    states: Vec<[State; 2]>,
}

impl Looks {
    fn of(part: [f64; 2], angle: f64, at: &dyn Fn(f64) -> State) -> Self {
        let pieces = Pieces::of(part, angle);
        let states = pieces.times().iter().map(|times| times.map(at)).collect();
        Self { pieces, states }
    }
}

/// Detector of events, with the side of each value on which the motion is.
#[derive(Debug)]
pub(crate) struct EventDetector<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    events: &'a [Event],
    sides: Vec<EventSide>,
    /// Passages of the last interval, one entry per event.
    last: Vec<Passages>,
    /// Last time at which an interval was cut.
    cut: f64,
    /// Events that happened at that time, and whether they were rising.
    happened: Vec<(usize, bool)>,
    /// Residual of each event's function at the crossings found at that time.
    residuals: Vec<f64>,
    /// Largest value of each event's function while it only drifted; 0 once the function has
    /// exceeded it.
    drifts: Vec<f64>,
}

/// A detected crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) time: f64,
    pub(crate) event: usize,
    pub(crate) rising: bool,
    /// True if the event has already happened at this time, in the same direction. If it switches a
    /// torque again, torques are switched on and off without end.
    pub(crate) repeats: bool,
}

impl<'a> EventDetector<'a> {
    /// Creates a detector at the start of a motion. `sides` holds the sides of the preceding motion
    /// if this one continues it, and is empty otherwise.
    pub(crate) fn new(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        (events, sides): (&'a [Event], &[EventSide]),
        start: &State,
    ) -> Self {
        let side = |event: &Event| {
            let gap = event.gap(rotor, torques, start);
            if gap.may_be_zero() { EventSide::At } else { EventSide::of(gap.gap) }
        };
        let sides = match sides.len() == events.len() {
            true => sides.to_vec(),
            false => events.iter().map(side).collect(),
        };
        let [residuals, drifts] = [0, 1].map(|_| vec![0.0; events.len()]);
        Self {
            rotor,
            torques,
            events,
            sides,
            last: Vec::new(),
            cut: start.time,
            happened: Vec::new(),
            residuals,
            drifts,
        }
    }

    /// Returns the events.
    pub(crate) const fn events(&self) -> &'a [Event] {
        self.events
    }

    /// Returns the side of each value on which the motion is.
    pub(crate) fn sides(&self) -> Vec<EventSide> {
        self.sides.clone()
    }

    /// Returns the first of these crossings and all that happen at the same time to within
    /// rounding, at most one for each event. `at` gives the motion in the last interval.
    pub(crate) fn due(&self, found: &[Found], at: &dyn Fn(f64) -> State) -> Vec<Found> {
        let mut due: Vec<Found> = Vec::new();
        for crossing in found {
            let is_due = due.first().is_none_or(|first| {
                due.iter().all(|known| known.event != crossing.event)
                    && self.is_simultaneous(first.time, crossing, at)
            });
            if is_due {
                due.push(*crossing);
            }
        }
        due
    }

    /// Checks if a crossing is at `time`, or if it is later and the gap stays within its rounding
    /// in between.
    fn is_simultaneous(&self, time: f64, crossing: &Found, at: &dyn Fn(f64) -> State) -> bool {
        let (Some(event), Some(passages)) = (self.events.get(crossing.event), self.last.get(crossing.event))
        else {
            return false;
        };
        let is_zero = |time: f64| event.gap(self.rotor, self.torques, &at(time)).gap.abs() <= passages.noise;
        let middle = time + 0.5 * (crossing.time - time);
        crossing.time <= Pieces::same(time) || is_zero(time) && is_zero(middle)
    }

    /// Cuts the last interval at the time of a state at which these events have just happened. The
    /// motion may follow other equations from there on.
    pub(crate) fn cut(&mut self, state: &State, happened: &[Found]) {
        let (time, until) = (state.time, Pieces::same(state.time));
        if time > self.cut {
            self.happened.clear();
        }
        self.cut = time;
        let events = self.events.iter().zip(&self.last).zip(self.sides.iter_mut().zip(&mut self.residuals));
        for (index, ((event, passages), (side, residual))) in events.enumerate() {
            *side = passages.side(until);
            *residual = 0.0;
            for &(at, rising) in &passages.passages {
                if at <= until && Pieces::same(at) >= time {
                    *residual = event.gap(self.rotor, self.torques, state).gap.abs();
                    // It was recorded before the interval was cut.
                    if event.sense().takes(rising) {
                        self.happened.push((index, rising));
                    }
                }
            }
        }
        for found in happened {
            self.happened.push((found.event, found.rising));
            if let Some(side) = self.sides.get_mut(found.event) {
                *side = if found.rising { EventSide::Above } else { EventSide::Below };
            }
        }
    }

    /// Finds all crossings from one time to another, in ascending order.
    ///
    /// # Errors
    /// [`MotionError::EventTooFast`]
    pub(crate) fn look(
        &mut self,
        [from, to]: [f64; 2],
        motion: &Watched<'_>,
    ) -> Result<Vec<Found>, MotionError> {
        if self.events.is_empty() {
            return Ok(Vec::new());
        }
        let at = motion.state;
        let turn = at(from).omega.norm().max(at(to).omega.norm()) * (to - from);
        let looks = Looks::of([from, to], turn, at);
        self.last.clear();
        let mut found = Vec::new();
        for (index, event) in self.events.iter().enumerate() {
            let before = self.sides[index];
            let residual = if from <= self.cut { RESIDUAL * self.residuals[index] } else { 0.0 };
            let course = (before, residual.max(self.drifts[index]));
            let states = || looks.states.iter().flatten();
            // A formula may have a short pulse between these states.
            let is_constant = !event.may_be_fast() && self.is_constant(event, states(), motion);
            let passages = match is_constant {
                true => Some(Passages::none(before, self.noise(event, states()))),
                false => self.passages(event, course, ([from, to], turn), (&looks, at)),
            };
            let mut passages =
                passages.ok_or(MotionError::EventTooFast { event: index, time: from, until: to })?;
            let is_changed = passages.side(to) != before || !passages.passages.is_empty();
            let there: Vec<State> = match event.may_be_fast() && is_changed {
                true => passages.passages.iter().map(|(time, _)| at(*time)).collect(),
                false => Vec::new(),
            };
            let is_drift =
                event.may_be_fast() && is_changed && self.is_constant(event, states().chain(&there), motion);
            if is_constant || is_drift {
                let gap = |state: &State| event.gap_alone(self.rotor, self.torques, state);
                let is_off = |gap: &f64| before == EventSide::At || EventSide::of(*gap) != before;
                let off = states().map(gap).filter(is_off).map(f64::abs);
                let drift = off.fold(self.drifts[index], f64::max);
                self.drifts[index] = drift;
                passages = Passages::none(before, passages.noise);
            } else if passages.is_known() {
                self.drifts[index] = 0.0;
            }
            for &(time, rising) in &passages.passages {
                let known = |as_now: bool| {
                    let is_it = |&(event, rose): &(usize, bool)| event == index && (rose == rising) == as_now;
                    time <= self.cut && self.happened.iter().any(is_it)
                };
                let [repeats, turns_back] = [known(true), known(false)];
                let is_opposite = || event.gap(self.rotor, self.torques, &at(time)).is_opposite;
                // A switch has reversed a passage that had just happened: this is one event.
                if event.sense().takes(rising) && (repeats || !turns_back) && !is_opposite() {
                    found.push(Found { time, event: index, rising, repeats });
                }
            }
            self.sides[index] = passages.side(to);
            self.last.push(passages);
        }
        found.sort_by(|a, b| a.time.total_cmp(&b.time));
        Ok(found)
    }

    /// Finds the passages of an event's gap.
    /// `side` is the side before the interval. Up to `floor` the gap may be zero. Returns `None`
    /// for a function that changes too fast.
    fn passages(
        &self,
        event: &Event,
        (mut side, mut floor): (EventSide, f64),
        (interval, turn): ([f64; 2], f64),
        (looks, at): (&Looks, &dyn Fn(f64) -> State),
    ) -> Option<Passages> {
        let function = |time: f64| event.gap_alone(self.rotor, self.torques, &at(time));
        let [from, to] = interval;
        let size = |time: f64| event.gap(self.rotor, self.torques, &at(time)).scale;
        let phase = match event.may_be_fast() {
            true => frequency(&function, interval, size(from).max(size(to))) * (to - from),
            false => 0.0,
        };
        let angle = turn.max(phase);
        let parts = Pieces::parts(interval, angle)?;
        let mut all = Passages::none(side, 0.0);
        for part in &parts {
            let own;
            let looks = if parts.len() == 1 && angle == turn {
                looks
            } else {
                own = Looks::of(*part, angle / parts.len() as f64, at);
                &own
            };
            let mut scale = 0.0_f64;
            let mut values = Vec::with_capacity(looks.states.len());
            for [state, beside] in &looks.states {
                let gap = event.gap(self.rotor, self.torques, state);
                scale = scale.max(gap.scale);
                values.push([gap.gap, event.gap_alone(self.rotor, self.torques, beside)]);
            }
            let course = Course { pieces: &looks.pieces, values: &values, scale, floor, function: &function };
            let passages = course.passages(side);
            side = passages.side(part[1]);
            if passages.is_known() {
                floor = 0.0;
            }
            all.extend(passages);
        }
        Some(all)
    }

    /// Returns the rounding of an event's gap in these states.
    fn noise<'s>(&self, event: &Event, states: impl Iterator<Item = &'s State>) -> f64 {
        let scale = |state: &State| event.gap(self.rotor, self.torques, state).scale;
        Passages::rounding(states.map(scale).fold(0.0, f64::max))
    }

    /// Checks if the rate of an event's gap is zero, to within rounding, by the equations of motion
    /// in these states.
    fn is_constant<'s>(
        &self,
        event: &Event,
        mut states: impl Iterator<Item = &'s State>,
        motion: &Watched<'_>,
    ) -> bool {
        states.all(|state| {
            let Some(rates) = (motion.rates)(state) else { return false };
            let (omega, [_, acceleration]) = (state.omega.norm(), rates.map(Direction::norm));
            let growth = if acceleration > 0.0 { acceleration / omega } else { 0.0 };
            let scale = event.gap(self.rotor, self.torques, state).scale;
            event.rate(self.rotor, state, rates).abs() <= ROUNDING * scale * (omega + growth)
        })
    }
}
