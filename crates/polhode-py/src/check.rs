//! Checks of the inertias of a robot model.

use std::path::PathBuf;

use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::{Inspection, inspect};
use polhode_robot::policy::Policy;
use polhode_robot::read::{ReadOptions, read_model};
use polhode_robot::report::CheckReport;
use pyo3::prelude::*;

use crate::error::Raise;

/// Checks a model; returns the result as JSON, as text, and as a table of its links.
///
/// # Errors
/// `PolhodeError` if the model cannot be read.
#[pyfunction]
pub(crate) fn check_file(
    py: Python<'_>,
    path: PathBuf,
    roots: Vec<PathBuf>,
    nearest: bool,
) -> PyResult<(String, String, String)> {
    py.detach(|| {
        let model =
            read_model(&path, &ReadOptions { roots, ..ReadOptions::default() }).map_err(Raise::raise)?;
        let found = inspect(&model, &Shapes::default());
        let Inspection { geometry, findings } = if nearest { found } else { found.without_nearest() };
        let judged = Policy::default().judge(|path| path.to_string_lossy().into_owned(), &model, findings);
        let report = CheckReport::new(model, geometry, judged);
        Ok((report.to_json().to_string(), report.to_text(), report.to_table()))
    })
}
