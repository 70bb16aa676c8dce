//! The numbers of a scenario that can be turned in a notebook.

use std::path::PathBuf;

use polhode_scenario::read::Draft;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::error::{Raise, refused};

/// The numbers of a text that can be turned, whose files are found beside `path`, the most telling first: a list of objects as JSON, which has `key`,
/// `label`, `value`, `unit`, `si`, `what`, `low`, `high` and `scale`.
#[pyfunction]
pub(crate) fn scenario_knobs(py: Python<'_>, path: PathBuf, text: String) -> PyResult<String> {
    let draft = py.detach(|| {
        let mut draft = Draft::trusting(&path, &text);
        draft.read(&Disk, text).map(|_| draft)
    });
    let knobs = polhode_live::knobs(&draft.map_err(Raise::raise)?.numbers());
    serde_json::to_string(&knobs).map_err(|error| refused(&error, None))
}
