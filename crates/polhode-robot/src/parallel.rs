//! Parallel processing of files, with results in order.

use std::num::NonZero;
use std::sync::{Mutex, PoisonError, mpsc};
use std::thread;

/// Returns the number of threads available to this process.
pub(crate) fn threads() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// Returns the result of each item, computed on `threads` threads. `done` receives the index of
/// each finished item.
pub(crate) fn map<I: Send, T: Send>(
    items: Vec<I>,
    threads: usize,
    work: impl Fn(I) -> T + Sync,
    mut done: impl FnMut(usize),
) -> Vec<T> {
    if cfg!(target_family = "wasm") {
        // A module for WebAssembly has one thread; the code of others would make it larger.
        let one = |(k, item)| {
            let result = work(item);
            done(k);
            result
        };
        return items.into_iter().enumerate().map(one).collect();
    }
    let threads = threads.min(items.len());
    let items = Mutex::new(items.into_iter().enumerate());
    let next = || items.lock().unwrap_or_else(PoisonError::into_inner).next();
    let (sender, results) = mpsc::channel();
    let (work, next) = (&work, &next);
    let mut all: Vec<(usize, T)> = thread::scope(|scope| {
        let run = |sender: mpsc::Sender<(usize, T)>| {
            move || {
                while let Some((k, item)) = next() {
                    // The receiver is gone only if the whole computation has failed.
                    if sender.send((k, work(item))).is_err() {
                        return;
                    }
                }
            }
        };
        let mut started = 0;
        for _ in 0..threads {
            // If a thread cannot be started, the others do its work.
            started += usize::from(thread::Builder::new().spawn_scoped(scope, run(sender.clone())).is_ok());
        }
        if started == 0 {
            run(sender)();
        } else {
            drop(sender);
        }
        let told = results.iter().inspect(|(k, _)| done(*k));
        told.collect()
    });
    all.sort_unstable_by_key(|(k, _)| *k);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order_on_any_number_of_threads() {
        let items: Vec<u64> = (0..100).collect();
        for threads in [0, 1, 3, 200] {
            let mut told = 0;
            let squares = map(items.clone(), threads, |k| k * k, |_| told += 1);
            assert_eq!(squares, items.iter().map(|k| k * k).collect::<Vec<_>>());
            assert_eq!(told, items.len());
        }
        assert_eq!(map(Vec::<u8>::new(), 2, |k| k, |_| ()), [0_u8; 0]);
    }
}
