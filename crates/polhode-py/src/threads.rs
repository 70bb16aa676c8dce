//! Number of available threads.

use std::num::NonZero;
use std::thread;

use pyo3::prelude::*;

/// Returns the number of threads that the process may use, limited by its affinity and by the quota
/// of its control group.
#[pyfunction]
pub(crate) fn available_threads() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
