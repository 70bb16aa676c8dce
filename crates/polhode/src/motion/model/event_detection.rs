//! Event detection along an interval of a motion with dense output.
//!
//! An interval is examined in pieces, in each of which the body turns by less than a third of a radian. A crossing shows as a change of
//! sign, and is located to the rounding of the time. Where the sign is the same at both ends, but the function turns back between them,
//! the place where it is nearest to zero is looked for: two crossings in one piece are found too. What can be missed is two crossings
//! within a piece in which the function turns back more than once, as of one that changes much faster than the body turns, and two
//! within a hundredth of the piece next to where the look-out begins.

use crate::math::root::{dip, root};
use crate::motion::model::event::{Event, Gap};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// A body turns by less than this in a piece, rad.
const TURN: f64 = 0.3;

/// Pieces of a stretch, at least and at most.
const PIECES: [f64; 2] = [4.0, 256.0];

/// The part of a piece over which a slope is taken.
const SLOPE: f64 = 1.0 / 256.0;

/// The events, and on which side of each value the motion is.
#[derive(Debug)]
pub(crate) struct EventDetector<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    events: &'a [Event],
    sides: Vec<EventSide>,
}

/// On which side of an event's value a motion was last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventSide {
    /// At the value, and has not left it: a motion that starts there has not passed it.
    At,
    /// Above.
    Above,
    /// Below.
    Below,
}

/// A crossing that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) time: f64,
    pub(crate) event: usize,
    pub(crate) rising: bool,
}

impl<'a> EventDetector<'a> {
    /// From a start, whose sides of the events' values are these if a motion goes on there.
    pub(crate) fn new(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        (events, sides): (&'a [Event], &[EventSide]),
        start: &State,
    ) -> Self {
        let mut watch = Self { rotor, torques, events, sides: sides.to_vec() };
        if sides.len() != events.len() {
            watch.sides = vec![EventSide::At; events.len()];
            watch.arm(start, &[]);
        }
        watch
    }

    /// On which side of each value the motion is.
    pub(crate) fn sides(&self) -> Vec<EventSide> {
        self.sides.clone()
    }

    /// True if an event happens in this state, but for rounding.
    pub(crate) fn is_due(&self, event: usize, state: &State) -> bool {
        self.events.get(event).is_some_and(|event| event.gap(self.rotor, self.torques, state).may_be_zero())
    }

    /// Begins anew from a state at which these events have just happened.
    pub(crate) fn arm(&mut self, state: &State, happened: &[usize]) {
        for (k, (event, side)) in self.events.iter().zip(&mut self.sides).enumerate() {
            let gap = event.gap(self.rotor, self.torques, state);
            let is_at = happened.contains(&k) || gap.may_be_zero();
            *side = if is_at { EventSide::At } else { EventSide::of(gap.gap) };
        }
    }

    /// All crossings from one time to another, in the order of time; `at` gives the motion there.
    pub(crate) fn look(&mut self, [from, to]: [f64; 2], at: &dyn Fn(f64) -> State) -> Vec<Found> {
        if self.events.is_empty() {
            return Vec::new();
        }
        let turn = at(from).omega.norm().max(at(to).omega.norm()) * (to - from);
        let count = (turn / TURN).ceil().clamp(PIECES[0], PIECES[1]) as u32;
        let width = (to - from) / f64::from(count);
        // Each place, and one beside it for the slope: before the end, after all others.
        let place = |k: u32| match k {
            k if k == count => [to, to - SLOPE * width],
            k => [from + f64::from(k) * width, from + (f64::from(k) + SLOPE) * width],
        };
        let places: Vec<[f64; 2]> = (0..=count).map(place).collect();
        let states: Vec<[State; 2]> = places.iter().map(|times| times.map(at)).collect();
        let mut found = Vec::new();
        for (index, (event, side)) in self.events.iter().zip(&mut self.sides).enumerate() {
            let gap = |state: &State| event.gap(self.rotor, self.torques, state);
            let nodes: Vec<EventSample> = places
                .iter()
                .zip(&states)
                .map(|(times, [a, b])| EventSample::of(*times, [gap(a), gap(b)]))
                .collect();
            for (time, rising) in crossings(&nodes, side, &|time| gap(&at(time)).gap) {
                if event.sense().takes(rising) && !gap(&at(time)).is_opposite {
                    found.push(Found { time, event: index, rising });
                }
            }
        }
        found.sort_by(|a, b| a.time.total_cmp(&b.time));
        found
    }
}

/// A function at one time.
#[derive(Clone, Copy, Debug)]
struct EventSample {
    time: f64,
    gap: f64,
    slope: f64,
    /// True if the gap may be zero.
    is_at: bool,
}

impl EventSample {
    fn of([time, beside]: [f64; 2], [here, there]: [Gap; 2]) -> Self {
        let slope = (there.gap - here.gap) / (beside - time);
        Self { time, gap: here.gap, slope, is_at: here.may_be_zero() }
    }
}

/// Where a function changes its sign, and whether it rises there; `side` is that of the first node, and becomes that of the last.
fn crossings(nodes: &[EventSample], side: &mut EventSide, gap_at: &dyn Fn(f64) -> f64) -> Vec<(f64, bool)> {
    let mut found = Vec::new();
    // The last time at which the function was on its side for certain.
    let Some(mut since) = nodes.first().map(|node| node.time) else { return found };
    for pair in nodes.windows(2) {
        let &[left, right] = pair else { continue };
        let Some(sign) = side.sign() else {
            if !right.is_at {
                (*side, since) = (EventSide::of(right.gap), right.time);
            }
            continue;
        };
        let f = |time: f64| sign * gap_at(time);
        if sign * right.gap < 0.0 {
            found.push((zero(&f, [since, right.time]), sign < 0.0));
            *side = EventSide::of(right.gap);
        } else if let Some(there) =
            turning(&left, &right, sign).then(|| dip(f, [left.time, right.time])).flatten()
        {
            found.push((zero(&f, [left.time, there]), sign < 0.0));
            found.push((zero(&f, [there, right.time]), sign > 0.0));
        }
        if right.gap != 0.0 {
            since = right.time;
        }
    }
    found
}

/// The zero of `f` in a bracket; its start if `f` is not what it was there, by rounding.
fn zero(f: &dyn Fn(f64) -> f64, bracket: [f64; 2]) -> f64 {
    let [a, b] = bracket.map(f);
    if (a > 0.0) == (b > 0.0) { bracket[0] } else { root(f, bracket, [a, b]) }
}

/// True if a function of this sign at two nodes can have been zero between them: it turns back, and its tangents meet beyond zero.
fn turning(left: &EventSample, right: &EventSample, sign: f64) -> bool {
    let ([a, b], [slope_a, slope_b]) =
        ([left, right].map(|n| sign * n.gap), [left, right].map(|n| sign * n.slope));
    if !(a > 0.0 && b > 0.0 && slope_a < 0.0 && slope_b > 0.0) {
        return false;
    }
    let width = right.time - left.time;
    let meet = (b - a - slope_b * width) / (slope_a - slope_b);
    !(meet > 0.0 && meet < width && a + slope_a * meet > 0.0)
}

impl EventSide {
    const fn of(gap: f64) -> Self {
        if gap > 0.0 { Self::Above } else { Self::Below }
    }

    const fn sign(self) -> Option<f64> {
        match self {
            Self::At => None,
            Self::Above => Some(1.0),
            Self::Below => Some(-1.0),
        }
    }
}
