//! Ctrl-C in the middle of a long computation.
//!
//! Work runs detached from Python. Where it can be cut into pieces, Python is asked between them. The integrator cannot be: it only
//! tells how far it is, so what it tells unwinds it. That is no panic: no message is printed, and nothing is left half done, as the
//! computation owns all that it writes.

use std::panic::{self, AssertUnwindSafe};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// Calls between two looks at the clock of Python: so many steps take some milliseconds.
const STRIDE: u32 = 1024;

/// What a signal that has come raises, if one has: on any thread, but only the main one hears of signals.
pub(crate) fn signal() -> Option<PyErr> {
    Python::attach(|py| py.check_signals().err())
}

/// What unwinds.
struct Interrupted(PyErr);

/// Runs `work` detached, and gives it something to call at every step, which ends it when Python has a signal to handle.
///
/// # Errors
/// `KeyboardInterrupt`, or what the handler of the signal raises.
pub(crate) fn watched<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut dyn FnMut(f64)) -> T + Send,
) -> PyResult<T> {
    let outcome = py.detach(|| {
        let mut steps = 0_u32;
        let mut look = |_time: f64| {
            steps = steps.wrapping_add(1);
            if steps.is_multiple_of(STRIDE)
                && let Some(signal) = signal()
            {
                panic::resume_unwind(Box::new(Interrupted(signal)));
            }
        };
        panic::catch_unwind(AssertUnwindSafe(|| work(&mut look)))
    });
    outcome.map_err(|payload| match payload.downcast::<Interrupted>() {
        Ok(interrupted) => interrupted.0,
        Err(_) => PyRuntimeError::new_err("a defect of polhode: please report it"),
    })
}
