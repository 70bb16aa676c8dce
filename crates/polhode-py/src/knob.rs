//! Numbers of a scenario that a notebook can vary interactively.

use std::path::PathBuf;

use polhode_scenario::read::Draft;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::error::{Raise, refused};

/// Returns the adjustable numbers of a text, the most important first. Paths in the text are
/// relative to `path`. The result is a JSON list of objects with `key`, `label`, `value`, `unit`,
/// `si`, `what`, `low`, `high` and `scale`.
#[pyfunction]
pub(crate) fn scenario_knobs(py: Python<'_>, path: PathBuf, text: String) -> PyResult<String> {
    let draft = py.detach(|| {
        let mut draft = Draft::trusting(&path, &text);
        draft.read(&Disk, text).map(|_| draft)
    });
    let knobs = polhode_web::knobs(&draft.map_err(Raise::raise)?.numbers());
    serde_json::to_string(&knobs).map_err(|error| refused(&error, None))
}
