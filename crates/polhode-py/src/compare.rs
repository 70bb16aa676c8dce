//! Comparison of two robot models.

use std::path::PathBuf;

use polhode_document::Report as _;
use polhode_robot::compare::{Request, run};
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::error::{Raise, refused};

/// Compares two models; returns the result as JSON and as text.
///
/// # Errors
/// `PolhodeError` if a model or the map cannot be read.
#[pyfunction]
pub(crate) fn compare_files(
    py: Python<'_>,
    a: PathBuf,
    b: PathBuf,
    tolerance: f64,
    map: Option<PathBuf>,
    roots: Vec<PathBuf>,
) -> PyResult<(String, String)> {
    let tolerance = format!("{tolerance:e}").parse().map_err(|why: String| refused(why, None))?;
    let request = Request { a, b, tolerance: Some(tolerance), map, roots };
    py.detach(|| {
        let comparison = run(&request, &Disk).map_err(Raise::raise)?;
        Ok((comparison.to_json().to_string(), comparison.to_text(None)))
    })
}
