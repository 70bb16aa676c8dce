//! How many threads there are to use.

use std::num::NonZero;
use std::thread;

use pyo3::prelude::*;

/// As many as the process may use at a time: by its affinity, and by the quota of its control group.
#[pyfunction]
pub(crate) fn available_threads() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
