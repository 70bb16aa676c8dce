//! Stability of steady motions.

use std::path::{Path, PathBuf};

use polhode_document::{Report as _, SourceInfo};
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::request::stability::Stability;
use pyo3::prelude::*;

use crate::error::Raise;
use crate::scenario;

/// Returns the stability report on a scenario's body as JSON and as text. The scenario is a file or
/// a text; paths in a text are relative to `path`.
///
/// # Errors
/// `PolhodeError` if the scenario cannot be read, or has no steady motion.
#[pyfunction]
pub(crate) fn scenario_stability(
    py: Python<'_>,
    path: PathBuf,
    text: Option<String>,
) -> PyResult<(String, String)> {
    py.detach(|| {
        let file = scenario::read(path, text).map_err(Raise::raise)?;
        let report = Stability::of_scenario(&file).map_err(Raise::raise)?;
        Ok((report.to_json().to_string(), report.to_text(None)))
    })
}

/// Returns the source information of a scenario.
pub(crate) fn source(path: &Path, file: &ScenarioFile) -> SourceInfo {
    let title = file.scenario.title().unwrap_or("scenario");
    SourceInfo::new(path.display().to_string(), "scenario").described(title)
}
