//! Many bodies of one kind in SIMD lanes, each with its own time and step.
//!
//! When a body reaches the last time or fails, the next one takes its lane. No lane is idle until
//! no body waits. Lanes do not influence each other, so every result is bit-identical to that of a
//! single body.

use std::sync::Arc;
use std::thread;

use super::Expansion;
use super::acting::Acting;
use super::base::ExpansionPoint;
use super::recurrence::Recurrence;
use super::row::smaller;
use super::stepper::torque_rate;
use super::sums::{OneBody, SeriesSums, SeveralBodies};
use crate::math::frame::{Body, Principal};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::solve::limits::{MOST_STEPS, require_tolerance};
use crate::motion::solve::propagate::bound::Bound;
use crate::motion::solve::propagate::half_turn::Torsions;
use crate::motion::solve::propagate::piece::Piece;
use crate::motion::solve::start::{require_few_pulses, require_finite};

/// Body with its torques and its start.
#[derive(Clone, Debug)]
pub(in crate::motion) struct BatchBody<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    start: State,
    pub(in crate::motion) acting: Arc<Acting>,
}

impl<'a> BatchBody<'a> {
    /// `acting`: the decomposition of these torques.
    pub(in crate::motion) const fn new(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        start: State,
        acting: Arc<Acting>,
    ) -> Self {
        Self { rotor, torques, start, acting }
    }

    /// Returns the decomposed torques if they and the body are equal to these.
    pub(in crate::motion) fn acting_if_equal(
        &self,
        rotor: &Rotor,
        torques: &[TorqueModel],
    ) -> Option<Arc<Acting>> {
        let is_equal = self.rotor == rotor && self.torques == torques;
        is_equal.then(|| Arc::clone(&self.acting))
    }

    /// Returns true if both bodies can be in one batch.
    pub(in crate::motion) fn is_like(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.acting, &other.acting) || self.acting.kind == other.acting.kind
    }
}

/// Computes the states of bodies of one kind at many times. `states` holds, for each body in turn,
/// its states at all times.
///
/// The times must be ascending, and not before any start. If a body fails, its last good state,
/// with the time of that state, is repeated for the remaining times. Its index is returned, with
/// the cause.
pub(in crate::motion) fn advance<'a: 'b, 'b>(
    bodies: impl Iterator<Item = &'b BatchBody<'a>>,
    times: &[f64],
    tolerance: f64,
    states: &mut [State],
) -> Vec<(usize, MotionError)> {
    let bodies: Vec<_> = bodies.collect();
    side_by_side(&bodies, times, tolerance, states)
}

/// Takes a slice, so that the code for each machine is compiled only once.
fn side_by_side(
    bodies: &[&BatchBody<'_>],
    times: &[f64],
    tolerance: f64,
    states: &mut [State],
) -> Vec<(usize, MotionError)> {
    let mut failures = Vec::new();
    with_room(&mut || failures = in_vectors(Advance { bodies, times, tolerance, states: &mut *states }));
    failures.sort_by_key(|(body, _)| *body);
    failures
}

/// Runs work on a thread with a large stack in unoptimised builds. There every intermediate vector
/// has its own place on the stack. The sum is several megabytes, and the default stack has two.
fn with_room(work: &mut (dyn FnMut() + Send)) {
    const ROOM: usize = 64 << 20;
    let mut in_thread = || {
        thread::scope(|scope| thread::Builder::new().stack_size(ROOM).spawn_scoped(scope, &mut *work).is_ok())
    };
    // Fallback if the system cannot create such a thread.
    if !cfg!(debug_assertions) || !in_thread() {
        work();
    }
}

struct Advance<'a, 'b> {
    bodies: &'b [&'b BatchBody<'a>],
    times: &'b [f64],
    tolerance: f64,
    states: &'b mut [State],
}

impl Work for Advance<'_, '_> {
    type Output = Vec<(usize, MotionError)>;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> Self::Output {
        if S::Many::LANES == 1 {
            return self.one_by_one(s.many(0.0), |batch| batch.run(SeveralBodies(s)));
        }
        let Some(mut batch) = Batch::of(self, s.many(0.0)) else { return Vec::new() };
        batch.run(SeveralBodies(s));
        batch.failures
    }

    /// Runs the bodies one by one. A single body already fills registers of two numbers, and a
    /// second code path would double the build time.
    #[inline(always)]
    fn run_narrow<S: Machine>(self, s: S) -> Self::Output {
        self.one_by_one(0.0, |batch| batch.run(OneBody(s)))
    }
}

impl<'a, 'b> Advance<'a, 'b> {
    /// Runs a batch for each body. Sums for a single body read beyond the known coefficients. A
    /// previous body must not leave its own there, because those of a failed body are infinite.
    #[inline(always)]
    fn one_by_one<N: Number>(
        self,
        zero: N,
        run: impl Fn(&mut Batch<'a, '_, N>),
    ) -> Vec<(usize, MotionError)> {
        let Self { bodies, times, tolerance, states } = self;
        let mut failures = Vec::new();
        for (k, body) in bodies.iter().enumerate() {
            let states = states.get_mut(k * times.len()..(k + 1) * times.len()).unwrap_or_default();
            let alone = Advance { bodies: core::slice::from_ref(body), times, tolerance, states };
            if let Some(mut batch) = Batch::of(alone, zero) {
                run(&mut batch);
                failures.extend(batch.failures.into_iter().map(|(_, cause)| (k, cause)));
            }
        }
        failures
    }
}

/// Bodies in progress, and bodies that wait.
struct Batch<'a, 'b, N> {
    work: Advance<'a, 'b>,
    /// Index of the first waiting body.
    waiting: usize,
    failures: Vec<(usize, MotionError)>,
    lanes: Vec<Option<Lane<'a>>>,
    /// Number of rounds. In each round every lane takes a step.
    rounds: u64,
    expansion: Box<Expansion<N>>,
    /// Points at which the expansions start.
    base: ExpansionPoint<N>,
    omega_scale: N,
    /// Last requested time of each lane's body, or its start without any times.
    end: N,
    /// First requested time that the body has not reached; infinite if there is none.
    next: N,
    /// Half of the plausibility bound on |ω|; from here on the bound is checked.
    fast: N,
}

/// Body in a lane.
#[derive(Debug)]
struct Lane<'a> {
    body: usize,
    start: State,
    piece: Piece<'a>,
    to_body: Rotation<Body, Principal>,
    /// Number of requested times that it has reached.
    sampled: usize,
    bound: Bound<ExpansionPoint>,
    /// Torsions among the torques. The motion ends where one of them is twisted by half a turn.
    torsions: Torsions,
    /// Number of rounds before the body entered the lane.
    rounds: u64,
}

impl<'a, 'b, N: Number> Batch<'a, 'b, N> {
    /// Returns `None` if the list of bodies is empty.
    fn of(work: Advance<'a, 'b>, zero: N) -> Option<Self> {
        let first = work.bodies.first()?;
        let piece = Piece::new(first.rotor, first.torques.iter(), &first.start);
        Some(Self {
            waiting: 0,
            failures: Vec::new(),
            lanes: (0..N::LANES).map(|_| None).collect(),
            rounds: 0,
            expansion: Expansion::of(zero, &piece, &first.acting.decomposition, work.tolerance, false),
            base: ExpansionPoint::all(zero),
            omega_scale: zero,
            end: zero,
            next: zero.like(f64::INFINITY),
            fast: zero,
            work,
        })
    }

    #[inline(always)]
    fn run<M: Recurrence<N = N>>(&mut self, s: M) {
        loop {
            self.board();
            if self.lanes.iter().all(Option::is_none) {
                return;
            }
            self.start();
            self.expansion.expand(s);
            self.begin();
            self.step(s);
            self.rounds += 1;
        }
    }

    /// Puts waiting bodies into free lanes.
    fn board(&mut self) {
        for k in 0..N::LANES {
            while self.lanes[k].is_none() && self.waiting < self.work.bodies.len() {
                let index = self.waiting;
                self.waiting += 1;
                let body = &self.work.bodies[index];
                match Lane::of(index, body, &self.work, self.rounds) {
                    Ok(lane) => {
                        self.expansion.set(k, &lane.piece, &body.acting.decomposition);
                        self.base.put(k, &ExpansionPoint::new(&body.start, lane.to_body));
                        self.omega_scale.put(k, body.start.omega.norm().max(torque_rate(&lane.piece)));
                        self.end.put(k, self.work.times.last().copied().unwrap_or(body.start.time));
                        self.next.put(k, self.work.next(&lane));
                        self.fast.put(k, 0.5 * lane.bound.most());
                        self.lanes[k] = Some(lane);
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
    #[inline(always)]
    fn start(&mut self) {
        self.expansion.start(&self.base.start());
        if self.expansion.inside.is_some() {
            for (k, lane) in self.lanes.iter().enumerate() {
                if let Some(lane) = lane {
                    self.expansion.start_wheels(k, self.base.time.lane(k), &lane.piece);
                }
            }
        }
    }

    /// Checks what is known before the step: torques that nothing balances, and requested times
    /// equal to the start.
    fn begin(&mut self) {
        for k in 0..N::LANES {
            let time = self.base.time.lane(k);
            if let Some(torque) = self.expansion.unbalanced(k) {
                self.give_up(k, MotionError::TorqueWithoutInertia { torque, time });
            } else if self.lanes[k].as_ref().is_some_and(|lane| lane.rounds == self.rounds) {
                self.sample(k, &self.base.lane(k));
                if !(self.end.lane(k) > time) {
                    self.lanes[k] = None;
                }
            }
        }
    }

    /// Takes one step in every lane, not beyond its end.
    #[inline(always)]
    fn step<M: SeriesSums<N = N>>(&mut self, s: M) {
        let time = self.base.time;
        let (allowed, rest) = (self.expansion.step(self.omega_scale), self.end - time);
        let wanted = smaller(allowed, self.expansion.reach());
        let h = wanted.zip(rest, |wanted, rest| if wanted >= rest { rest } else { wanted });
        let is_last = wanted.zip(rest, |wanted, rest| f64::from(u8::from(wanted >= rest)));
        let mut until =
            is_last.zip3(self.end, time + h, |is_last, end, until| if is_last == 1.0 { end } else { until });
        let mut head = self.base.plus(&self.expansion.at(s, until - time), until);
        let is_good = (time + h).zip3(time, head.not_finite(), |until, time, not_finite| {
            f64::from(u8::from((until > time) & (not_finite == 0.0)))
        });
        for k in (0..N::LANES).filter(|k| is_good.lane(*k) == 0.0) {
            let (time, step) = (time.lane(k), h.lane(k));
            let is_stuck = !step.is_nan() && !(time + step > time);
            let stuck = MotionError::StepTooSmall { time, step };
            let cause = if is_stuck { stuck } else { MotionError::NotFinite { time } };
            let now = [time, self.base.lane(k).rate()];
            let explained = self.lanes[k].as_ref().map(|lane| lane.bound.explained(cause.clone(), now));
            self.give_up(k, explained.unwrap_or(cause));
        }
        let half_turns = self.half_turns(&head);
        if !half_turns.is_empty() {
            for &(k, after) in &half_turns {
                until.put(k, time.lane(k) + after);
            }
            let there = self.base.plus(&self.expansion.at(s, until - time), until);
            for (k, _) in &half_turns {
                head.put(*k, &there.lane(*k));
            }
        }
        self.sample_within(s, until);
        let before = core::mem::replace(&mut self.base, head);
        for (k, _) in half_turns {
            self.end_at_half_turn(k);
        }
        self.look_ahead(allowed, &before);
    }

    /// Returns the lanes in which a torsion reaches half a turn in the step, and the time from its
    /// start.
    fn half_turns(&self, head: &ExpansionPoint<N>) -> Vec<(usize, f64)> {
        let lanes = self.lanes.iter().enumerate();
        let sprung =
            lanes.filter_map(|(k, lane)| Some((k, lane.as_ref().filter(|l| !l.torsions.is_empty())?)));
        let found = sprung.filter_map(|(k, lane)| {
            let [base, head] = [self.base.lane(k), head.lane(k)];
            let cosine = |rest| self.expansion.cosine(k, rest, (base.rotation(), lane.to_body));
            let after =
                lane.torsions.half_turn(head.time - base.time, head.rate().max(base.rate()), cosine)?;
            Some((k, after))
        });
        found.collect()
    }

    /// Ends the motion of a lane whose base is at half a turn of a torsion. This is an error unless
    /// it is the last time.
    fn end_at_half_turn(&mut self, k: usize) {
        let base = self.base.lane(k);
        self.sample(k, &base);
        if self.end.lane(k) > base.time {
            self.give_up(k, MotionError::HalfTurn { time: base.time });
        } else {
            self.lanes[k] = None;
        }
    }

    /// Samples the step at the requested times before its end, in all lanes simultaneously.
    #[inline(always)]
    fn sample_within<M: SeriesSums<N = N>>(&mut self, s: M, until: N) {
        loop {
            let start = self.base.time;
            let time =
                self.next.zip3(until, start, |next, until, start| if next < until { next } else { start });
            let is_within = |k: &usize| self.next.lane(*k) < until.lane(*k);
            let within: Vec<usize> = (0..N::LANES).filter(is_within).collect();
            if within.is_empty() {
                return;
            }
            let there = self.base.plus(&self.expansion.at(s, time - start), time);
            for k in within {
                self.sample(k, &there.lane(k));
            }
        }
    }

    /// Checks the results of a step. A body at its end frees its lane, and a body that cannot reach
    /// its end fails.
    #[inline(always)]
    fn look_ahead(&mut self, allowed: N, before: &ExpansionPoint<N>) {
        let (time, rate) = (self.base.time, self.base.rate());
        self.omega_scale = self.omega_scale.zip(rate, f64::max);
        let is_far = (self.end - time)
            .zip(allowed, |rest, step| f64::from(u8::from(rest >= 0.5 * MOST_STEPS as f64 * step)));
        let is_due = self.next.zip(time, |next, time| f64::from(u8::from(next <= time)));
        let is_fast = rate.zip(self.fast, |rate, fast| f64::from(u8::from(rate >= fast)));
        let is_long = 2 * self.rounds > MOST_STEPS;
        let news = is_far + is_due + is_fast;
        for k in (0..N::LANES).filter(|k| is_long || news.lane(*k) != 0.0) {
            let base = self.base.lane(k);
            let end = self.end.lane(k);
            self.sample(k, &base);
            let Some(lane) = &mut self.lanes[k] else { continue };
            let step = self.rounds + 1 - lane.rounds;
            let now = [base.time, base.rate()];
            let began = || {
                let before = before.lane(k);
                (before.time, before.rate(), before)
            };
            let goes_on = (lane.bound.require(step, now[1], began))
                .and_then(|()| lane.bound.require_few_steps(step, allowed.lane(k), now, end));
            if let Err(cause) = goes_on {
                self.give_up(k, cause);
            } else if !(end > base.time) {
                self.lanes[k] = None;
            }
        }
    }

    /// Stores a point of a lane for all requested times up to its time that are not yet stored.
    fn sample(&mut self, k: usize, place: &ExpansionPoint) {
        let Some(lane) = &mut self.lanes[k] else { return };
        while self.work.next(lane) <= place.time {
            self.work.write(lane.body, lane.sampled, place.state(lane.to_body));
            lane.sampled += 1;
        }
        self.next.put(k, self.work.next(lane));
    }

    /// Ends the motion of a lane with an error, at the base.
    fn give_up(&mut self, k: usize, cause: MotionError) {
        let Some(lane) = self.lanes[k].take() else { return };
        let mut base = self.base.lane(k);
        let mut sampled = lane.sampled;
        if let (MotionError::RunAway { .. }, Some(plausible)) = (&cause, lane.bound.last_plausible()) {
            base = plausible;
            sampled = sampled.min(self.work.times.partition_point(|time| *time <= base.time));
        }
        // Return the start as given, without the rounding of the conversion to principal axes.
        let last = if base.time > lane.start.time { base.state(lane.to_body) } else { lane.start };
        self.work.fill(lane.body, sampled, last);
        self.next.put(k, f64::INFINITY);
        self.failures.push((lane.body, cause));
    }
}

impl Advance<'_, '_> {
    /// Returns the first requested time that a body has not reached; infinite if there is none.
    fn next(&self, lane: &Lane<'_>) -> f64 {
        self.times.get(lane.sampled).copied().unwrap_or(f64::INFINITY)
    }

    fn write(&mut self, body: usize, sample: usize, state: State) {
        if let Some(place) = self.states.get_mut(body * self.times.len() + sample) {
            *place = state;
        }
    }

    /// Stores the same state for all times of a body from index `from` on.
    fn fill(&mut self, body: usize, from: usize, state: State) {
        for sample in from..self.times.len() {
            self.write(body, sample, state);
        }
    }
}

impl<'a> Lane<'a> {
    fn of(
        index: usize,
        body: &BatchBody<'a>,
        work: &Advance<'_, '_>,
        rounds: u64,
    ) -> Result<Self, MotionError> {
        let BatchBody { rotor, torques, start, .. } = *body;
        require_finite(rotor, torques, &[], &start)?;
        let end = work.times.last().copied().unwrap_or(start.time);
        require_few_pulses(rotor, torques, &|_| false, [start.time, end])?;
        require_tolerance(work.tolerance)?;
        let piece = Piece::first(rotor, torques.iter(), &start)?;
        let torsions = Torsions::of(piece.torques.iter().copied(), start.attitude);
        if torsions.is_half_turn(start.attitude) && end > start.time {
            return Err(MotionError::HalfTurn { time: start.time });
        }
        let mut bound = Bound::new(&piece, &start);
        bound.end(end);
        Ok(Self {
            body: index,
            start,
            bound,
            torsions,
            piece,
            to_body: rotor.principal().rotation(),
            sampled: 0,
            rounds,
        })
    }
}

#[cfg(test)]
mod tests;
