//! Event detection along an interval of a motion with dense output.
//!
//! An interval is divided into pieces in which the body turns by less than a third of a radian; pieces are halved
//! where an event's function turns back or is not yet resolved. A passage is located to the rounding of the time. Not
//! found are two passages within a part of 10⁻³ of a piece that neither values nor slopes at the ends of the piece
//! show, as of a function that changes much faster than the body turns.

use super::passage::{Course, Passages, Pieces};
use crate::motion::model::event::{Event, Gap};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

pub use super::passage::EventSide;

/// Safety factor of the residual of a function where it vanished.
const RESIDUAL: f64 = 4.0;

/// The events, and the side of each value on which the motion is.
#[derive(Debug)]
pub(crate) struct EventDetector<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    events: &'a [Event],
    sides: Vec<EventSide>,
    /// The passages of the last interval, event by event.
    last: Vec<Passages>,
    /// The last time at which an interval was cut.
    cut: f64,
    /// The events that have happened there, and whether they rose.
    happened: Vec<(usize, bool)>,
    /// Residual of each event's function where it vanished there.
    residuals: Vec<f64>,
}

/// A crossing that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) time: f64,
    pub(crate) event: usize,
    pub(crate) rising: bool,
    /// True if the event has happened at this time already, in the same direction. Torques are switched on and off
    /// without end, if it switches one again.
    pub(crate) repeats: bool,
}

impl<'a> EventDetector<'a> {
    /// Begins at a start. A motion that continues has the sides of another; they are empty otherwise.
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
        let residuals = vec![0.0; events.len()];
        Self {
            rotor,
            torques,
            events,
            sides,
            last: Vec::new(),
            cut: start.time,
            happened: Vec::new(),
            residuals,
        }
    }

    /// The side of each value on which the motion is.
    pub(crate) fn sides(&self) -> Vec<EventSide> {
        self.sides.clone()
    }

    /// The first of these crossings and those that happen at its time, too, except for rounding: once for each event.
    /// `at` gives the motion in the last interval.
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

    /// True if a crossing is at a time, or after it and the event's function stays within its rounding until then.
    fn is_simultaneous(&self, time: f64, crossing: &Found, at: &dyn Fn(f64) -> State) -> bool {
        let (Some(event), Some(passages)) = (self.events.get(crossing.event), self.last.get(crossing.event))
        else {
            return false;
        };
        let is_zero = |time: f64| event.gap(self.rotor, self.torques, &at(time)).gap.abs() <= passages.noise;
        let middle = time + 0.5 * (crossing.time - time);
        crossing.time <= Pieces::same(time) || is_zero(time) && is_zero(middle)
    }

    /// Cuts the last interval at the time of a state in which these events have just happened. The motion may be
    /// another from there on.
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
                    // It was written down before the interval was cut.
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

    /// All crossings from one time to another, in ascending order; `at` gives the motion there.
    pub(crate) fn look(&mut self, [from, to]: [f64; 2], at: &dyn Fn(f64) -> State) -> Vec<Found> {
        if self.events.is_empty() {
            return Vec::new();
        }
        let turn = at(from).omega.norm().max(at(to).omega.norm()) * (to - from);
        let pieces = Pieces::of([from, to], turn);
        let states: Vec<[State; 2]> = pieces.times().iter().map(|times| times.map(at)).collect();
        self.last.clear();
        let mut found = Vec::new();
        for (index, (event, side)) in self.events.iter().zip(&mut self.sides).enumerate() {
            let gap = |state: &State| event.gap(self.rotor, self.torques, state);
            let gaps: Vec<[Gap; 2]> = states.iter().map(|[a, b]| [gap(a), gap(b)]).collect();
            let scale = gaps.iter().flatten().fold(0.0_f64, |scale, gap| scale.max(gap.scale));
            let values: Vec<[f64; 2]> = gaps.iter().map(|pair| pair.map(|gap| gap.gap)).collect();
            let function = |time: f64| gap(&at(time)).gap;
            let residual = self.residuals.get(index).filter(|_| from <= self.cut).copied();
            let floor = RESIDUAL * residual.unwrap_or(0.0);
            let course = Course { pieces: &pieces, values: &values, scale, floor, function: &function };
            let passages = course.passages(*side);
            for &(time, rising) in &passages.passages {
                let known = |as_now: bool| {
                    let is_it = |&(event, rose): &(usize, bool)| event == index && (rose == rising) == as_now;
                    time <= self.cut && self.happened.iter().any(is_it)
                };
                let [repeats, turns_back] = [known(true), known(false)];
                // A switch has turned back what had just passed: that is one event.
                if event.sense().takes(rising) && (repeats || !turns_back) && !gap(&at(time)).is_opposite {
                    found.push(Found { time, event: index, rising, repeats });
                }
            }
            *side = passages.side(to);
            self.last.push(passages);
        }
        found.sort_by(|a, b| a.time.total_cmp(&b.time));
        found
    }
}
