//! Ctrl-C in the middle of a long computation.
//!
//! Work runs detached from Python, which is asked for signals as time passes. It has its lock while another thread of Python computes, and lets it
//! go after some milliseconds: to ask costs that much then, whatever the piece of work is.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::prelude::*;

use crate::error::refused;

/// Time between two looks for signals.
const PAUSE: Duration = Duration::from_millis(20);

/// How many times as long as a look itself takes the next one waits: a thread of Python that has the lock slows work down by a twentieth.
const PATIENCE: u32 = 20;

/// Rows that are copied at once: some milliseconds.
const PIECE: usize = 1 << 17;

/// The stack of a thread of its own, as large as that of a program, in bytes.
const STACK: usize = 8 << 20;

/// What a signal that has come raises, if one has: on any thread, but only the main one hears of signals.
fn signal() -> Option<PyErr> {
    Python::attach(|py| py.check_signals().err())
}

/// When to look for signals again, and what one has raised.
#[derive(Debug)]
pub(crate) struct Watch {
    next: Instant,
    raised: Option<PyErr>,
}

impl Watch {
    /// From now on.
    pub(crate) fn new() -> Self {
        Self { next: Instant::now() + PAUSE, raised: None }
    }

    /// Whether to go on; to be asked as often as may be.
    pub(crate) fn goes_on(&mut self) -> bool {
        let now = Instant::now();
        if self.raised.is_none() && now >= self.next {
            self.raised = signal();
            self.next = Instant::now() + PAUSE.max(PATIENCE * now.elapsed());
        }
        self.raised.is_none()
    }

    /// The end of the work.
    ///
    /// # Errors
    /// `KeyboardInterrupt`, or what the handler of the signal raises.
    pub(crate) fn ended(self) -> PyResult<()> {
        self.raised.map_or(Ok(()), Err)
    }
}

/// Runs `work` detached, and gives it something to ask at every step whether to go on: it ends when Python has a signal to handle.
///
/// # Errors
/// `KeyboardInterrupt`, or what the handler of the signal raises.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> T + Send,
) -> PyResult<T> {
    let mut watch = Watch::new();
    let outcome = py.detach(|| work(&mut |_time| watch.goes_on()));
    watch.ended().map(|()| outcome)
}

/// Runs `work` detached on a thread of its own, and gives it something to ask whether to go on. A signal is heard while a piece of work lasts that asks
/// nothing, as to read a large file: the caller has it at once, and `work` ends where it asks next.
///
/// # Errors
/// `KeyboardInterrupt`, or what the handler of the signal raises.
pub(crate) fn watched_apart<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send + 'static,
) -> PyResult<T> {
    let ends = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = channel();
    let ended = Arc::clone(&ends);
    let run = move || {
        let found = work(&|| !ended.load(Ordering::Relaxed));
        // Nobody waits for it after a signal.
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
        // It has panicked, as else it would have sent something.
        (None, worker) => match worker.join() {
            Err(panic) => std::panic::resume_unwind(panic),
            Ok(()) => Err(refused("the computation has ended without a result", None)),
        },
    }
}

/// A copy of an array's rows, piece by piece, with a look for signals between them.
///
/// # Errors
/// `KeyboardInterrupt`, or what the handler of the signal raises.
pub(crate) fn copied<T: Copy>(py: Python<'_>, rows: &[T]) -> PyResult<Vec<T>> {
    let mut all = Vec::with_capacity(rows.len());
    for piece in rows.chunks(PIECE) {
        all.extend_from_slice(piece);
        py.check_signals()?;
    }
    Ok(all)
}
