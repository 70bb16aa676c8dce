//! The command `polhode`, for `python/polhode_command`.

use std::ffi::OsString;

use pyo3::prelude::*;

/// The status of a program that ends by a panic.
const PANICKED: u8 = 101;

/// Runs the command with these arguments, the first of which is its name, and gives its exit status.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    // A panic has been printed as the program prints it.
    py.detach(|| std::panic::catch_unwind(|| polhode_cli::run(arguments)).unwrap_or(PANICKED))
}
