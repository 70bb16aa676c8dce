//! Worker threads: each takes the next portion of the members until none is left.

use core::num::NonZero;
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use super::closed::Closed;
use super::motion::MemberMotion;
use super::{EnsembleOutcome, Member, MemberFailure};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Members that a thread takes at a time: enough to fill vectors with members of a kind, and little to wait for.
const PORTION: usize = 64;

/// So many threads, the caller's own among them.
pub(super) struct Workers {
    threads: NonZero<usize>,
}

/// Some members, and the place for their states.
pub(super) struct Portion<'a> {
    /// The first of them.
    first: usize,
    pub(super) members: &'a [Member],
    /// Their closed forms, where those are kept.
    pub(super) closed: &'a [Closed],
    /// Times for each.
    times: usize,
    write: &'a mut dyn FnMut(usize, &[State]),
    outcome: EnsembleOutcome,
    report: &'a mut dyn FnMut(usize) -> bool,
}

impl Portion<'_> {
    /// Puts down states of a member (of the portion, from 0), from one of its times on.
    pub(super) fn put(&mut self, member: usize, from: usize, states: &[State]) {
        (self.write)(member * self.times + from, states);
    }

    /// Writes down that a member can go no further, after so many of its times: it stays where it was.
    pub(super) fn fail(&mut self, member: usize, reached: usize, last: State, cause: MotionError) {
        for time in reached..self.times {
            self.put(member, time, &[last]);
        }
        self.give_up(member, cause);
    }

    /// Writes down that a member can go no further, whose states say so already.
    pub(super) fn give_up(&mut self, member: usize, cause: MotionError) {
        self.outcome.failures.push(MemberFailure { member: self.first + member, cause });
    }

    /// Puts down the motion of a member that is computed alone.
    pub(super) fn put_motion(&mut self, member: usize, motion: MemberMotion) {
        let start = self.members[member].start;
        for (time, state) in motion.at_all(self.times, start).enumerate() {
            self.put(member, time, &[state]);
        }
        self.outcome.add(self.first + member, motion);
    }

    /// Says that so many more members are done; false if the others need not be.
    #[must_use]
    pub(super) fn done(&mut self, members: usize) -> bool {
        (self.report)(members)
    }
}

impl Workers {
    pub(super) const fn new(threads: NonZero<usize>) -> Self {
        Self { threads }
    }

    /// Has all states filled, in place: nothing depends on who does which portion, nor when.
    ///
    /// # Errors
    /// [`MotionError::Cancelled`] if `progress` gave false.
    pub(super) fn fill<S: From<State> + Send>(
        &self,
        (members, closed): (&[Member], &[Closed]),
        times: usize,
        states: &mut [S],
        progress: &mut dyn FnMut(usize) -> bool,
        compute: &(dyn Fn(&mut Portion<'_>) + Sync),
    ) -> Result<EnsembleOutcome, MotionError> {
        let done = AtomicUsize::new(0);
        let goes_on = AtomicBool::new(true);
        let portions =
            members.chunks(PORTION).zip(states.chunks_mut(PORTION.saturating_mul(times))).enumerate();
        let portions = Mutex::new(portions);
        let outcome = Mutex::new(EnsembleOutcome::default());
        let work = |report: &mut dyn FnMut(usize) -> bool| {
            while goes_on.load(Ordering::Relaxed) {
                let next = portions.lock().unwrap_or_else(PoisonError::into_inner).next();
                let Some((k, (members, places))) = next else { break };
                let mut portion = Portion {
                    first: k * PORTION,
                    members,
                    closed: closed.get(k * PORTION..).unwrap_or_default(),
                    times,
                    write: &mut |from, states| {
                        for (place, state) in places.iter_mut().skip(from).zip(states) {
                            *place = S::from(*state);
                        }
                    },
                    outcome: EnsembleOutcome::default(),
                    report,
                };
                compute(&mut portion);
                outcome.lock().unwrap_or_else(PoisonError::into_inner).extend(portion.outcome);
            }
        };
        let mut told = 0;
        let count = |members: usize| done.fetch_add(members, Ordering::Relaxed) + members;
        thread::scope(|scope| {
            for _ in 1..self.threads.get().min(members.len().div_ceil(PORTION)) {
                let helper = || {
                    work(&mut |members| {
                        count(members);
                        goes_on.load(Ordering::Relaxed)
                    });
                };
                // What cannot be had is done without.
                if thread::Builder::new().spawn_scoped(scope, helper).is_err() {
                    break;
                }
            }
            work(&mut |members| {
                told = count(members);
                let goes = progress(told);
                goes_on.fetch_and(goes, Ordering::Relaxed);
                goes
            });
        });
        let (done, goes_on) = (done.into_inner(), goes_on.into_inner());
        // What others did last.
        if !goes_on || told < done && !progress(done) {
            return Err(MotionError::Cancelled { done });
        }
        Ok(outcome.into_inner().unwrap_or_else(PoisonError::into_inner).sorted())
    }
}
