//! Worked solutions.

use std::path::PathBuf;

use polhode_scenario::report::{Formalism, LagrangianError, explain_exactly, lagrangian};
use pyo3::prelude::*;

use crate::error::{Raise, refused};
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

/// Explains a scenario from a file or a text, by the formalism "newton", "lagrange" or "hamilton".
/// Paths in a text are relative to `path`.
///
/// # Errors
/// `PolhodeError` if the scenario cannot be read or computed, or has no known Lagrangian.
#[pyfunction]
pub(crate) fn explain_scenario(
    py: Python<'_>,
    path: PathBuf,
    text: Option<String>,
    formalism: &str,
) -> PyResult<Explained> {
    py.detach(|| {
        let file = scenario::read(path, text).map_err(Raise::raise)?;
        let of_motion = |error: polhode::motion::MotionError| {
            file.placed(&error).map_or_else(|| error.raise(), Raise::raise)
        };
        let by = |formalism| {
            lagrangian(&file.scenario, formalism, &file.exact()).map_err(|error| match error {
                LagrangianError::Motion(error) => of_motion(error),
                error => refused(error.to_string(), Some(error.hint())),
            })
        };
        let document = match formalism {
            "lagrange" => by(Formalism::Lagrange)?,
            "hamilton" => by(Formalism::Hamilton)?,
            _ => explain_exactly(&file.scenario, &file.exact()).map_err(of_motion)?,
        };
        Ok(Explained {
            json: document.to_json().to_string(),
            text: document.to_text(WIDTH),
            markdown: document.to_markdown(),
            html: document.to_html(),
            latex: document.to_latex(),
        })
    })
}
