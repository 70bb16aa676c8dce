//! Ctrl-C during long computations.
//!
//! Work runs without Python's lock, and periodically takes it to check for signals. If another
//! Python thread holds the lock, such a check takes some milliseconds, independent of the work.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::prelude::*;

use crate::error::refused;

/// Interval between two checks for signals.
const PAUSE: Duration = Duration::from_millis(20);

/// Minimum interval between checks as a multiple of the duration of a check. It limits the slowdown
/// by a busy Python thread to 5 %.
const PATIENCE: u32 = 20;

/// Number of rows copied between checks; some milliseconds of work.
const PIECE: usize = 1 << 17;

/// Stack size of the worker thread, bytes; the same as that of a program.
const STACK: usize = 8 << 20;

/// Returns the exception of a pending signal, if there is one. Python delivers signals to its main
/// thread only.
fn signal() -> Option<PyErr> {
    Python::attach(|py| py.check_signals().err())
}

/// Schedule of signal checks, with the exception of a signal.
#[derive(Debug)]
pub(crate) struct Watch {
    next: Instant,
    raised: Option<PyErr>,
}

impl Watch {
    /// Creates a schedule that starts now.
    pub(crate) fn new() -> Self {
        Self { next: Instant::now() + PAUSE, raised: None }
    }

    /// Returns true if the work may continue; call it as often as possible.
    pub(crate) fn goes_on(&mut self) -> bool {
        let now = Instant::now();
        if self.raised.is_none() && now >= self.next {
            self.raised = signal();
            self.next = Instant::now() + PAUSE.max(PATIENCE * now.elapsed());
        }
        self.raised.is_none()
    }

    /// Ends the work.
    ///
    /// # Errors
    /// `KeyboardInterrupt`, or another exception of the signal handler.
    pub(crate) fn ended(self) -> PyResult<()> {
        self.raised.map_or(Ok(()), Err)
    }
}

/// Runs `work` without Python's lock. `work` calls its argument at every step, and stops if that
/// returns false because of a signal.
///
/// # Errors
/// `KeyboardInterrupt`, or another exception of the signal handler.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> T + Send,
) -> PyResult<T> {
    let mut watch = Watch::new();
    let outcome = py.detach(|| work(&mut |_time| watch.goes_on()));
    watch.ended().map(|()| outcome)
}

/// Works like [`watched`] for work that calls a shared function, mostly at short intervals.
///
/// # Errors
/// `KeyboardInterrupt`, or another exception of the signal handler.
pub(crate) fn watched_here<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send,
) -> PyResult<T> {
    let watch = Mutex::new(Watch::new());
    let goes_on = || watch.lock().unwrap_or_else(PoisonError::into_inner).goes_on();
    let outcome = py.detach(|| work(&goes_on));
    watch.into_inner().unwrap_or_else(PoisonError::into_inner).ended().map(|()| outcome)
}

/// Runs `work` without Python's lock on a thread of its own. A signal interrupts the caller
/// immediately, even during a step without checks, such as reading a large file. `work` itself
/// stops at its next check.
///
/// # Errors
/// `KeyboardInterrupt`, or another exception of the signal handler.
pub(crate) fn watched_apart<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send + 'static,
) -> PyResult<T> {
    let ends = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = channel();
    let ended = Arc::clone(&ends);
    let run = move || {
        let found = work(&|| !ended.load(Ordering::Relaxed));
        // After a signal nobody receives the result.
        let _ = sender.send(found);
    };
    let worker = thread::Builder::new().stack_size(STACK).spawn(run)?;
    let mut watch = Watch::new();
    let look = &mut watch;
    let found = py.detach(move || {
        loop {
            match receiver.recv_timeout(PAUSE) {
                Ok(found) => return Some(found),
                Err(RecvTimeoutError::Timeout) if look.goes_on() => {}
                Err(_) => return None,
            }
        }
    });
    ends.store(true, Ordering::Relaxed);
    watch.ended()?;
    match (found, worker) {
        (Some(found), _) => Ok(found),
        // The worker panicked, otherwise it would have sent a result.
        (None, worker) => match worker.join() {
            Err(panic) => std::panic::resume_unwind(panic),
            Ok(()) => Err(refused("the computation ended without a result", None)),
        },
    }
}

/// Copies the rows of an array piece by piece, with checks for signals in between.
///
/// # Errors
/// `KeyboardInterrupt`, or another exception of the signal handler.
pub(crate) fn copied<T: Copy>(py: Python<'_>, rows: &[T]) -> PyResult<Vec<T>> {
    let mut all = Vec::with_capacity(rows.len());
    for piece in rows.chunks(PIECE) {
        all.extend_from_slice(piece);
        py.check_signals()?;
    }
    Ok(all)
}
