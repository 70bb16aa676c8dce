//! Work on several threads, with results that do not depend on their number.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Maximum number of concurrent threads; at least one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Threads(usize);

impl Threads {
    pub(crate) fn of(count: usize) -> Self {
        Self(count.max(1))
    }

    /// Returns the number of threads that the machine offers to this process.
    pub(crate) fn of_machine() -> Self {
        Self(thread::available_parallelism().map_or(1, usize::from))
    }

    /// Returns the number of threads for work on this many triangles: those of the machine, or one
    /// if starting others, or asking for their number, takes longer than they save.
    pub(crate) fn for_triangles(count: usize) -> Self {
        if count < WORTH_THREADS { Self(1) } else { Self::of_machine() }
    }

    pub(crate) const fn count(self) -> usize {
        self.0
    }

    /// Returns the results of all pieces of work, in their order.
    pub(crate) fn map<T: Send>(self, pieces: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
        let threads = self.0.min(pieces);
        // A module for WebAssembly has one thread; the code of others would make it larger.
        if threads <= 1 || cfg!(target_family = "wasm") {
            return (0..pieces).map(work).collect();
        }
        let next = AtomicUsize::new(0);
        let run = || {
            let mut done = Vec::new();
            loop {
                let piece = next.fetch_add(1, Ordering::Relaxed);
                if piece >= pieces {
                    return done;
                }
                done.push((piece, work(piece)));
            }
        };
        let mut results = thread::scope(|scope| {
            // If a thread cannot be created, the others do its work.
            let spawn = |_| thread::Builder::new().spawn_scoped(scope, run).ok();
            let others: Vec<_> = (1..threads).filter_map(spawn).collect();
            let mut results = run();
            for other in others {
                match other.join() {
                    Ok(more) => results.extend(more),
                    Err(panic) => std::panic::resume_unwind(panic),
                }
            }
            results
        });
        results.sort_unstable_by_key(|result| result.0);
        results.into_iter().map(|result| result.1).collect()
    }

    /// Returns the results of all pieces of `piece` items each (the last may have fewer), in their
    /// order.
    pub(crate) fn map_pieces<T: Send>(
        self,
        items: usize,
        piece: usize,
        work: impl Fn(core::ops::Range<usize>) -> T + Sync,
    ) -> Vec<T> {
        self.map(items.div_ceil(piece), |k| work(k * piece..((k + 1) * piece).min(items)))
    }
}

/// Number of triangles from which two threads are faster than one: 20,480 triangles take as long on
/// both, and asking for the number of threads takes 30 µs.
const WORTH_THREADS: usize = 1 << 14;
