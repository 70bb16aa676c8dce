//! How much a search may cost.

use std::sync::atomic::{AtomicU64, Ordering};

/// Steps that a search may take, on all threads together.
///
/// What is done in each piece of work does not depend on the threads, so neither does whether there were enough.
#[derive(Debug)]
pub(crate) struct Work {
    done: AtomicU64,
    limit: u64,
}

impl Work {
    pub(crate) const fn of(limit: u64) -> Self {
        Self { done: AtomicU64::new(0), limit }
    }

    /// Takes steps; false if there were not that many.
    pub(crate) fn take(&self, steps: u64) -> bool {
        self.done.fetch_add(steps, Ordering::Relaxed).saturating_add(steps) <= self.limit
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

    /// Were more steps taken than there were?
    pub(crate) fn is_spent(&self) -> bool {
        self.done.load(Ordering::Relaxed) > self.limit
    }
}
