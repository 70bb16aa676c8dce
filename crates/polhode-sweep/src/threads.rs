//! Processing of a sweep's parts in threads.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;

use crate::error::SweepError;

/// Processes each part, in ascending order; a thread processes one part at a time.
///
/// After an error, which is returned, and after `stop`, only the parts in progress are completed.
pub(crate) fn each(
    parts: u64,
    threads: usize,
    stop: &AtomicBool,
    work: impl Fn(u64) -> Result<(), SweepError> + Sync,
) -> Result<(), SweepError> {
    let (next, failed) = (AtomicU64::new(0), Mutex::new(None));
    let turn = || {
        while !stop.load(Ordering::Relaxed) {
            let part = next.fetch_add(1, Ordering::Relaxed);
            if part >= parts {
                return;
            }
            if let Err(error) = work(part) {
                stop.store(true, Ordering::Relaxed);
                if let Ok(mut failed) = failed.lock() {
                    failed.get_or_insert(error);
                }
                return;
            }
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(usize::try_from(parts).unwrap_or(usize::MAX)) {
            // If the system refuses more threads, the existing ones do all the work.
            if thread::Builder::new().spawn_scoped(scope, turn).is_err() {
                break;
            }
        }
        turn();
    });
    match failed.into_inner() {
        Ok(Some(error)) => Err(error),
        _ => Ok(()),
    }
}
