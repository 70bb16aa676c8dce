//! Worker threads: each takes the next portion of the members until all are done.

use core::num::NonZero;
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

use super::motion::MemberMotion;
use super::prepared::Prepared;
use super::{EnsembleOutcome, Member, MemberFailure};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Number of members in a portion: enough to fill SIMD vectors with members of a kind, and a short
/// wait at the end.
pub(super) const PORTION: usize = 64;

/// Number of threads, including the calling thread.
pub(super) struct Workers {
    threads: NonZero<usize>,
}

/// Some members, with access to the storage of their states.
pub(super) struct Portion<'a> {
    /// Index of the first member of the portion.
    first: usize,
    pub(super) members: &'a [Member],
    /// Closed forms and decomposed torques, if they are kept.
    pub(super) prepared: &'a [Prepared],
    /// Number of times per member.
    times: usize,
    write: &'a mut dyn FnMut(usize, &[State]),
    outcome: EnsembleOutcome,
    report: &'a mut dyn FnMut(usize) -> bool,
}

impl Portion<'_> {
    /// Stores states of a member (index within the portion, from 0), from the time with index
    /// `from` on.
    pub(super) fn put(&mut self, member: usize, from: usize, states: &[State]) {
        (self.write)(member * self.times + from, states);
    }

    /// Records that a member failed after `reached` of its times. Its last state is repeated.
    pub(super) fn fail(&mut self, member: usize, reached: usize, last: State, cause: MotionError) {
        for time in reached..self.times {
            self.put(member, time, &[last]);
        }
        self.give_up(member, cause);
    }

    /// Records that a member failed; its states are stored already.
    pub(super) fn give_up(&mut self, member: usize, cause: MotionError) {
        self.outcome.failures.push(MemberFailure { member: self.first + member, cause });
    }

    /// Stores the motion of a member that was computed separately.
    pub(super) fn put_motion(&mut self, member: usize, motion: MemberMotion) {
        let start = self.members[member].start;
        for (time, state) in motion.at_all(self.times, start).enumerate() {
            self.put(member, time, &[state]);
        }
        self.outcome.add(self.first + member, motion);
    }

    /// Reports that `members` more members are done. Returns false if the computation is to stop.
    #[must_use]
    pub(super) fn done(&mut self, members: usize) -> bool {
        (self.report)(members)
    }
}

impl Workers {
    pub(super) const fn new(threads: NonZero<usize>) -> Self {
        Self { threads }
    }

    /// Computes all states in place. The result does not depend on which thread computes which
    /// portion, or when.
    ///
    /// # Errors
    /// [`MotionError::Cancelled`] if `progress` returned false.
    pub(super) fn fill<S: From<State> + Send>(
        &self,
        (members, prepared): (&[Member], &[Prepared]),
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
                    prepared: prepared.get(k * PORTION..).unwrap_or_default(),
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
                // Continue with fewer threads if the system provides no more.
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
        // Report what other threads finished last.
        if !goes_on || told < done && !progress(done) {
            return Err(MotionError::Cancelled { done });
        }
        Ok(outcome.into_inner().unwrap_or_else(PoisonError::into_inner).sorted())
    }
}
