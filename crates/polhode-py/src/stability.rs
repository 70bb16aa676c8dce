//! Stability of steady motions.

use std::path::{Path, PathBuf};

use polhode_document::SourceInfo;
use polhode_scenario::read::ScenarioFile;
use polhode_scenario::report::{GroundStabilityReport, StabilityReport};
use pyo3::prelude::*;

use crate::error::{Raise, refused};
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
        let file = scenario::read(path.clone(), text).map_err(Raise::raise)?;
        if file.scenario.prescribed().is_some() {
            let hint = "delete [prescribed], or use polhode.explain for the torque that the motion needs";
            return Err(refused("the motion is prescribed, so its stability is not defined", Some(hint)));
        }
        if file.scenario.history().is_some() {
            let hint =
                "polhode.simulate computes its motion; delete [mass_history] for the body at the start";
            return Err(refused("the mass properties change, so steady motions are not defined", Some(hint)));
        }
        let source = source(&path, &file);
        match file.scenario.ground() {
            Some(ground) => {
                let report = GroundStabilityReport::of_scenario(source, &file.scenario, ground);
                let report = report.map_err(Raise::raise)?;
                Ok((report.to_json().to_string(), report.to_text()))
            }
            None => {
                let report = StabilityReport::of_scenario(source, &file.scenario);
                Ok((report.to_json().to_string(), report.to_text()))
            }
        }
    })
}

/// Returns the source information of a scenario.
pub(crate) fn source(path: &Path, file: &ScenarioFile) -> SourceInfo {
    let title = file.scenario.title().unwrap_or("scenario");
    SourceInfo::new(path.display().to_string(), "scenario").described(title)
}
