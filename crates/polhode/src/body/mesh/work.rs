//! Step budgets of searches.

use core::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Callback that long computations call repeatedly: false stops them.
pub(crate) type GoesOn<'a> = dyn Fn() -> bool + Sync + 'a;

/// Step budget of a search, shared by all threads, with a callback that can stop it.
///
/// The steps of each piece of work do not depend on the threads. Therefore it does not depend on
/// them whether the budget was sufficient, unless the search was stopped.
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

    /// Takes steps; returns false if the budget is exceeded or the search was stopped.
    pub(crate) fn take(&self, steps: u64) -> bool {
        let before = self.done.fetch_add(steps, Ordering::Relaxed);
        let after = before.saturating_add(steps);
        let is_asked = before / OFTEN != after / OFTEN;
        after <= self.limit && if is_asked { self.goes_on() } else { !self.ended.load(Ordering::Relaxed) }
    }

    /// Calls the callback and returns true if the search may continue; for work that is not counted
    /// in steps.
    pub(crate) fn goes_on(&self) -> bool {
        if !self.ended.load(Ordering::Relaxed) && !(self.goes_on)() {
            self.ended.store(true, Ordering::Relaxed);
        }
        !self.ended.load(Ordering::Relaxed)
    }

    /// Exhausts the budget.
    pub(crate) fn take_all(&self) {
        self.done.fetch_max(self.limit.saturating_add(1), Ordering::Relaxed);
    }

    /// Returns the number of steps taken.
    #[cfg(test)]
    pub(crate) fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    /// Returns true if the budget was exceeded or the search was stopped.
    pub(crate) fn is_spent(&self) -> bool {
        self.not_enough().is_some()
    }

    /// Returns the number of steps that were not sufficient, if the budget was exceeded or the
    /// search was stopped.
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

/// Number of steps between calls of the callback: a few milliseconds.
const OFTEN: u64 = 1 << 16;
