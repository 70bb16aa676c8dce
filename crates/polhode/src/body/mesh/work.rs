//! How much a search may cost.

use core::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Asked again and again by what takes time: false ends it.
pub(crate) type GoesOn<'a> = dyn Fn() -> bool + Sync + 'a;

/// Steps that a search may take, on all threads together, as long as it goes on.
///
/// What is done in each piece of work does not depend on the threads, so neither does whether there were enough, unless it was ended.
pub(crate) struct Work<'a> {
    done: AtomicU64,
    limit: u64,
    goes_on: &'a GoesOn<'a>,
    ended: AtomicBool,
}

impl<'a> Work<'a> {
    pub(crate) const fn of(limit: u64, goes_on: &'a GoesOn<'a>) -> Self {
        Self { done: AtomicU64::new(0), limit, goes_on, ended: AtomicBool::new(false) }
    }

    /// Takes steps; false if there were not that many, or if it is ended.
    pub(crate) fn take(&self, steps: u64) -> bool {
        let before = self.done.fetch_add(steps, Ordering::Relaxed);
        let after = before.saturating_add(steps);
        let is_asked = before / OFTEN != after / OFTEN;
        after <= self.limit && if is_asked { self.goes_on() } else { !self.ended.load(Ordering::Relaxed) }
    }

    /// Asks whether it goes on, of what is not counted in steps.
    pub(crate) fn goes_on(&self) -> bool {
        if !self.ended.load(Ordering::Relaxed) && !(self.goes_on)() {
            self.ended.store(true, Ordering::Relaxed);
        }
        !self.ended.load(Ordering::Relaxed)
    }

    /// Leaves none.
    pub(crate) fn take_all(&self) {
        self.done.fetch_max(self.limit.saturating_add(1), Ordering::Relaxed);
    }

    /// Steps taken.
    #[cfg(test)]
    pub(crate) fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    /// Were more steps taken than there were, or was it ended?
    pub(crate) fn is_spent(&self) -> bool {
        self.not_enough().is_some()
    }

    /// The steps that were not enough.
    pub(crate) fn not_enough(&self) -> Option<u64> {
        let done = self.done.load(Ordering::Relaxed);
        (done > self.limit || self.ended.load(Ordering::Relaxed)).then_some(done.min(self.limit))
    }
}

impl fmt::Debug for Work<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Work").field("done", &self.done).field("limit", &self.limit).finish_non_exhaustive()
    }
}

/// Steps after which it is asked whether the search goes on: a few milliseconds.
const OFTEN: u64 = 1 << 16;
