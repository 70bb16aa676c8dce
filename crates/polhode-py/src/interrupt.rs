//! Ctrl-C in the middle of a long computation.
//!
//! Work runs detached from Python, which is asked for signals between its pieces.

use pyo3::prelude::*;

/// Calls between two looks at the clock of Python: so many steps take some milliseconds.
const STRIDE: u32 = 1024;

/// What a signal that has come raises, if one has: on any thread, but only the main one hears of signals.
pub(crate) fn signal() -> Option<PyErr> {
    Python::attach(|py| py.check_signals().err())
}

/// Runs `work` detached, and gives it something to ask at every step whether to go on: it ends when Python has a signal to handle.
///
/// # Errors
/// `KeyboardInterrupt`, or what the handler of the signal raises.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> T + Send,
) -> PyResult<T> {
    let (outcome, raised) = py.detach(|| {
        let (mut steps, mut raised) = (0_u32, None);
        let outcome = work(&mut |_time| {
            steps = steps.wrapping_add(1);
            if raised.is_none() && steps.is_multiple_of(STRIDE) {
                raised = signal();
            }
            raised.is_none()
        });
        (outcome, raised)
    });
    raised.map_or(Ok(outcome), Err)
}
