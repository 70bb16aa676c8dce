//! Worked solutions.

use std::path::PathBuf;

use polhode_scenario::report::explain;
use pyo3::prelude::*;

use crate::error::Raise;
use crate::scenario;

/// Characters in a line of the text.
const WIDTH: usize = 100;

/// A worked solution in all its forms.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Explained {
    json: String,
    text: String,
    markdown: String,
    html: String,
    latex: String,
}

/// Works a scenario through: of a file, or of a text, whose files are found beside `path`.
///
/// # Errors
/// `PolhodeError` if it cannot be read, or cannot be computed.
#[pyfunction]
pub(crate) fn explain_scenario(py: Python<'_>, path: PathBuf, text: Option<String>) -> PyResult<Explained> {
    py.detach(|| {
        let file = scenario::read(path, text).map_err(Raise::raise)?;
        let document = explain(&file.scenario)
            .map_err(|error| file.placed(&error).map_or_else(|| error.raise(), Raise::raise))?;
        Ok(Explained {
            json: document.to_json().to_string(),
            text: document.to_text(WIDTH),
            markdown: document.to_markdown(),
            html: document.to_html(),
            latex: document.to_latex(),
        })
    })
}
