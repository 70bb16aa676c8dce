//! Entry point of the command `polhode`, for `python/polhode_command`.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Exit status after a panic.
const PANICKED: u8 = 101;

/// Runs the command with these arguments, the first of which is its name, and returns its exit
/// status.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    // The panic message has been printed already.
    py.detach(|| std::panic::catch_unwind(|| polhode_cli::run(arguments)).unwrap_or(PANICKED))
}
