//! Many bodies of one kind, side by side: one in each lane, each with its own time and step.
//!
//! When a body has come to the last time, or can go no further, the next one takes its lane. So no lane is idle until none is left, and
//! what a lane does never depends on its neighbours: every body has the bits that it has alone.

use super::Expansion;
use super::base::Base;
use super::stepper::torque_rate;
use super::sums::{SideBySide, Sums};
use super::torque::{Shape, StepStart, from_outside};
use crate::math::frame::{Body as BodyFrame, Principal};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::motion::course::require_few_steps;
use crate::motion::error::MotionError;
use crate::motion::propagate::piece::Piece;
use crate::motion::propagate::stepper::{Bound, Rule, first_piece, require_untwisted};
use crate::motion::rotor::Rotor;
use crate::motion::simulation::require_finite;
use crate::motion::state::State;
use crate::motion::torque::TorqueModel;
use crate::motion::wheel::{Motor, Wheel};

/// What bodies that are expanded side by side have in common: their numbers differ, and nothing else.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) struct Kind {
    torques: Vec<Shape>,
    /// Wheels or friction.
    has_inside: bool,
    tolerance: u64,
}

/// The kind of a body; `None` for what is computed body by body: schedules, and what has no series.
pub(in crate::motion) fn kind(rotor: &Rotor, torques: &[TorqueModel], tolerance: f64) -> Option<Kind> {
    let has_series =
        |torque: &TorqueModel| torque.roughness().is_none() && !matches!(torque, TorqueModel::Scheduled(_));
    let is_steady = |wheel: &Wheel| !matches!(wheel.motor(), Motor::Torque { schedule: Some(_), .. });
    if !torques.iter().all(has_series) || !rotor.wheels().iter().all(is_steady) {
        return None;
    }
    let models: Vec<_> = torques.iter().collect();
    Some(Kind {
        torques: from_outside(&models).map(|model| Shape::of(model, rotor)).collect(),
        has_inside: !rotor.wheels().is_empty() || torques.iter().any(|torque| torque.sink() != 0.0),
        tolerance: tolerance.to_bits(),
    })
}

/// A body, what turns it, and where it starts.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Body<'a> {
    pub(in crate::motion) rotor: &'a Rotor,
    pub(in crate::motion) torques: &'a [TorqueModel],
    pub(in crate::motion) start: State,
}

/// The states of bodies of one kind at the times, which are ascending, none before any start: body by body, each at all times.
///
/// A body that can go no further repeats its last good state from there on, which keeps its time; it is among those that are returned,
/// with the cause.
pub(in crate::motion) fn advance(
    bodies: &[Body<'_>],
    times: &[f64],
    tolerance: f64,
    states: &mut [State],
) -> Vec<(usize, MotionError)> {
    let mut failures = in_vectors(Advance { bodies, times, tolerance, states });
    failures.sort_by_key(|(body, _)| *body);
    failures
}

struct Advance<'a, 'b> {
    bodies: &'b [Body<'a>],
    times: &'b [f64],
    tolerance: f64,
    states: &'b mut [State],
}

impl Work for Advance<'_, '_> {
    type Output = Vec<(usize, MotionError)>;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> Self::Output {
        let Some(mut fleet) = Fleet::of(self, s.eight(0.0)) else { return Vec::new() };
        fleet.run(SideBySide(s));
        fleet.failures
    }
}

/// The bodies under way, and those that wait.
struct Fleet<'a, 'b, N> {
    work: Advance<'a, 'b>,
    /// The first of the bodies that wait.
    waiting: usize,
    failures: Vec<(usize, MotionError)>,
    lanes: Vec<Option<Lane<'a>>>,
    expansion: Box<Expansion<N>>,
    /// What the expansion is about.
    base: Base<N>,
    omega_scale: N,
}

/// The body of a lane.
#[derive(Debug)]
struct Lane<'a> {
    body: usize,
    start: State,
    piece: Piece<'a>,
    to_body: Rotation<BodyFrame, Principal>,
    /// The last of the times, or the start where there is none.
    end: f64,
    /// How many of the times it has come to.
    sampled: usize,
    bound: Bound,
    /// True if a spring or wire is among the torques: its twist is watched.
    is_sprung: bool,
    steps: u64,
}

impl<'a, 'b, N: Number> Fleet<'a, 'b, N> {
    /// `None` if there is nobody to go.
    fn of(work: Advance<'a, 'b>, zero: N) -> Option<Self> {
        let first = work.bodies.first()?;
        let piece = Piece::new(first.rotor, first.torques.iter(), &first.start);
        Some(Self {
            waiting: 0,
            failures: Vec::new(),
            lanes: (0..N::LANES).map(|_| None).collect(),
            expansion: Box::new(Expansion::of(zero, &piece, work.tolerance, false)),
            base: Base::all(zero),
            omega_scale: zero,
            work,
        })
    }

    #[inline(always)]
    fn run<M: Sums<N = N>>(&mut self, s: M) {
        loop {
            self.board();
            if self.lanes.iter().all(Option::is_none) {
                return;
            }
            self.start();
            self.expansion.expand(s);
            self.begin();
            self.step(s);
        }
    }

    /// Bodies that wait take the lanes that are free.
    fn board(&mut self) {
        for lane in 0..N::LANES {
            while self.lanes[lane].is_none() && self.waiting < self.work.bodies.len() {
                let index = self.waiting;
                self.waiting += 1;
                let body = self.work.bodies[index];
                match Lane::of(index, &body, &self.work) {
                    Ok(new) => {
                        self.expansion.set(lane, &new.piece);
                        self.base.put(lane, &Base::new(&body.start, new.to_body));
                        self.omega_scale.put(lane, body.start.omega.norm().max(torque_rate(&new.piece)));
                        self.lanes[lane] = Some(new);
                    }
                    Err(cause) => {
                        self.failures.push((index, cause));
                        self.work.fill(index, 0, body.start);
                    }
                }
            }
        }
    }

    /// Starts a step in every lane.
    fn start(&mut self) {
        for (k, lane) in self.lanes.iter().enumerate() {
            if let Some(lane) = lane {
                let Base { time, orientation, .. } = self.base.lane(k);
                let start =
                    StepStart { time, attitude: orientation.rotation(), omega: self.base.lane(k).omega() };
                self.expansion.start(k, &start, &lane.piece);
            }
        }
    }

    /// Looks at what is known before the step: is there a torque that nothing balances, and which of the times are the start?
    fn begin(&mut self) {
        for k in 0..N::LANES {
            let Some(lane) = &mut self.lanes[k] else { continue };
            let base = self.base.lane(k);
            if let Some(torque) = self.expansion.unbalanced(k) {
                self.give_up(k, MotionError::TorqueWithoutInertia { torque, time: base.time });
            } else if lane.steps == 0 {
                lane.sample(&mut self.work, &base);
                if !(lane.end > base.time) {
                    self.lanes[k] = None;
                }
            }
        }
    }

    /// One step of every lane, not beyond its end.
    #[inline(always)]
    fn step<M: Sums<N = N>>(&mut self, s: M) {
        let allowed = self.expansion.step(self.omega_scale);
        let (mut h, mut end) = (allowed.like(0.0), self.base.time);
        for k in 0..N::LANES {
            let Some(lane) = &self.lanes[k] else { continue };
            let (time, rest) = (self.base.time.lane(k), lane.end - self.base.time.lane(k));
            let wanted = allowed.lane(k).min(self.expansion.reach(k));
            let step = if wanted >= rest { rest } else { wanted };
            if step.is_nan() {
                self.give_up(k, MotionError::NotFinite { time });
            } else if !(time + step > time) {
                self.give_up(k, MotionError::StepTooSmall { time, step });
            } else {
                h.put(k, step);
                end.put(k, if wanted >= rest { lane.end } else { time + step });
            }
        }
        let head = self.base.plus(&self.expansion.at(s, h), end);
        for k in 0..N::LANES {
            let Some(lane) = &self.lanes[k] else { continue };
            let time = self.base.time.lane(k);
            let (from, to) = (self.base.lane(k), head.lane(k));
            if !to.is_finite() {
                self.give_up(k, MotionError::NotFinite { time });
            } else if let Err(cause) = lane.require_untwisted(&from, &to) {
                self.give_up(k, cause);
            }
        }
        self.sample_within(s, head.time);
        self.base = head;
        self.look_ahead(allowed);
    }

    /// Samples the step at the times before its end, in every lane at once.
    #[inline(always)]
    fn sample_within<M: Sums<N = N>>(&mut self, s: M, end: N) {
        loop {
            let (mut is_any, mut time) = (false, self.base.time);
            for (k, lane) in self.lanes.iter().enumerate() {
                let next = lane.as_ref().and_then(|lane| self.work.times.get(lane.sampled));
                if let Some(&next) = next.filter(|next| **next < end.lane(k)) {
                    time.put(k, next);
                    is_any = true;
                }
            }
            if !is_any {
                return;
            }
            let there = self.base.plus(&self.expansion.at(s, time - self.base.time), time);
            for (k, lane) in self.lanes.iter_mut().enumerate() {
                if let Some(lane) = lane {
                    lane.sample(&mut self.work, &there.lane(k));
                }
            }
        }
    }

    /// Looks at where a step has led: what comes to its end makes room, and what will not come there gives up.
    fn look_ahead(&mut self, allowed: N) {
        for k in 0..N::LANES {
            let Some(lane) = &mut self.lanes[k] else { continue };
            let base = self.base.lane(k);
            lane.steps += 1;
            lane.sample(&mut self.work, &base);
            let scale = self.omega_scale.lane(k).max(base.omega().norm());
            self.omega_scale.put(k, scale);
            let rate = (lane.to_body * base.omega()).norm();
            let goes_on = require_few_steps(lane.steps, allowed.lane(k), base.time, lane.end)
                .and_then(|()| lane.bound.require(base.time, rate));
            if let Err(cause) = goes_on {
                self.give_up(k, cause);
            } else if !(lane.end > base.time) {
                self.lanes[k] = None;
            }
        }
    }

    /// The body of a lane goes no further than the base.
    fn give_up(&mut self, k: usize, cause: MotionError) {
        let Some(lane) = self.lanes[k].take() else { return };
        // The start as it was given, not as it comes back from principal axes.
        let last = if lane.steps == 0 { lane.start } else { self.base.lane(k).state(lane.to_body) };
        self.work.fill(lane.body, lane.sampled, last);
        self.failures.push((lane.body, cause));
    }
}

impl Advance<'_, '_> {
    /// The same state for all times of a body from one on.
    fn fill(&mut self, body: usize, from: usize, state: State) {
        let times = self.times.len();
        if let Some(rest) = self.states.get_mut(body * times + from..(body + 1) * times) {
            rest.fill(state);
        }
    }
}

impl<'a> Lane<'a> {
    fn of(index: usize, body: &Body<'a>, work: &Advance<'_, '_>) -> Result<Self, MotionError> {
        let Body { rotor, torques, start } = *body;
        require_finite(rotor, torques, &start)?;
        let piece = first_piece(Rule::Taylor, rotor, torques.iter(), &start, work.tolerance)?;
        Ok(Self {
            body: index,
            start,
            bound: Bound::new(&piece, &start),
            is_sprung: torques.iter().any(|torque| torque.name() == "torsion"),
            piece,
            to_body: rotor.principal().rotation(),
            end: work.times.last().copied().unwrap_or(start.time),
            sampled: 0,
            steps: 0,
        })
    }

    /// Writes a place down for all times that are its own, or that come before the start.
    fn sample(&mut self, work: &mut Advance<'_, '_>, place: &Base) {
        while work.times.get(self.sampled).is_some_and(|time| *time <= place.time) {
            if let Some(state) = work.states.get_mut(self.body * work.times.len() + self.sampled) {
                *state = place.state(self.to_body);
            }
            self.sampled += 1;
        }
    }

    /// # Errors
    /// [`MotionError::HalfTurn`]
    fn require_untwisted(&self, from: &Base, to: &Base) -> Result<(), MotionError> {
        if !self.is_sprung {
            return Ok(());
        }
        let torques = self.piece.torques.iter().copied();
        require_untwisted(torques, &from.state(self.to_body), &to.state(self.to_body))
    }
}
