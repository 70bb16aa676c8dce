//! Worked solutions.

use std::path::PathBuf;

use polhode_scenario::report::explain_exactly;
use pyo3::prelude::*;

use crate::error::Raise;
use crate::scenario;

/// Line width of the text, characters.
const WIDTH: usize = 100;

/// Worked solution in all formats.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Explained {
    json: String,
    text: String,
    markdown: String,
    html: String,
    latex: String,
}

/// Explains a scenario from a file or a text. Paths in a text are relative to `path`.
///
/// # Errors
/// `PolhodeError` if the scenario cannot be read or computed.
#[pyfunction]
pub(crate) fn explain_scenario(py: Python<'_>, path: PathBuf, text: Option<String>) -> PyResult<Explained> {
    py.detach(|| {
        let file = scenario::read(path, text).map_err(Raise::raise)?;
        let document = explain_exactly(&file.scenario, &file.exact())
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
