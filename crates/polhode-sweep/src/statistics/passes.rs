//! Passes over all parts, in threads.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use crate::batch::Batch;
use crate::error::SweepError;
use crate::threads;

/// Parts of a sweep, and the function that reads them.
pub(super) struct Parts<'a> {
    pub(super) count: u64,
    pub(super) threads: usize,
    pub(super) read: &'a (dyn Fn(u64) -> Result<Batch, SweepError> + Sync),
}

/// Merged results, and results that wait for an earlier part.
struct Ordered<T> {
    next: u64,
    waiting: BTreeMap<u64, T>,
    merged: Option<T>,
}

impl Parts<'_> {
    /// Computes a result for each part and merges them in the order of the parts. So sums of
    /// floating-point numbers do not depend on the threads. `None` without parts.
    pub(super) fn in_order<T: Send>(
        &self,
        of: impl Fn(u64) -> Result<T, SweepError> + Sync,
        merge: impl Fn(T, T) -> T + Sync,
    ) -> Result<Option<T>, SweepError> {
        let ordered = Mutex::new(Ordered { next: 0, waiting: BTreeMap::new(), merged: None });
        self.each(|part| {
            let found = of(part)?;
            if let Ok(mut ordered) = ordered.lock() {
                ordered.waiting.insert(part, found);
                loop {
                    let next = ordered.next;
                    let Some(found) = ordered.waiting.remove(&next) else { break };
                    ordered.next += 1;
                    ordered.merged = Some(match ordered.merged.take() {
                        Some(merged) => merge(merged, found),
                        None => found,
                    });
                }
            }
            Ok(())
        })?;
        Ok(ordered.into_inner().ok().and_then(|ordered| ordered.merged))
    }

    /// Adds counts over all parts; each thread has its own array.
    pub(super) fn counts(
        &self,
        length: usize,
        count: impl Fn(&Batch, &mut [u64]) + Sync,
    ) -> Result<Vec<u64>, SweepError> {
        let spare = Mutex::new(Vec::<Vec<u64>>::new());
        self.each(|part| {
            let batch = (self.read)(part)?;
            let taken = spare.lock().ok().and_then(|mut spare| spare.pop());
            let mut counts = taken.unwrap_or_else(|| vec![0; length]);
            count(&batch, &mut counts);
            if let Ok(mut spare) = spare.lock() {
                spare.push(counts);
            }
            Ok(())
        })?;
        let mut total = vec![0; length];
        for counts in spare.into_inner().unwrap_or_default() {
            total.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
        Ok(total)
    }

    fn each(&self, work: impl Fn(u64) -> Result<(), SweepError> + Sync) -> Result<(), SweepError> {
        threads::each(self.count, self.threads, &AtomicBool::new(false), work)
    }
}
