//! Mass budgets of parts lists.

use std::path::PathBuf;

use numpy::PyArray2;
use polhode::math::{Body, Part, Position, Rotation};
use polhode_budget::Basis;
use polhode_budget::read as budget;
use polhode_budget::read::{BudgetFile, Questions};
use polhode_budget::report::{BudgetReport, Scope};
use polhode_document::layout::WIDTH;
use polhode_source::FormatError;
use pyo3::prelude::*;

use crate::arrays::matrix;
use crate::error::{Raise, refused};

/// Result in the formats of the command, with the draws as arrays.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Budgeted<'py> {
    json: String,
    text: String,
    markdown: String,
    page: String,
    is_beyond: bool,
    /// Draws of each configuration, one row per draw.
    draws: Vec<Bound<'py, PyArray2<f64>>>,
    /// Each configuration as a part of a scenario, TOML.
    scenarios: Vec<String>,
}

/// Options that override those of the file.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asked {
    is_basic: Option<bool>,
    about: Option<[f64; 3]>,
    axes: Option<[[f64; 3]; 3]>,
    draws: Option<usize>,
    seed: Option<u64>,
    configuration: Option<String>,
}

/// Reads a parts list from a file or a text. Paths in a text are relative to `path`. `head` is the
/// number of header lines of a text that was generated from a table.
///
/// # Errors
/// `PolhodeError` if the list cannot be read, or does not give a physical body.
#[pyfunction]
pub(crate) fn budget_list(
    py: Python<'_>,
    path: PathBuf,
    text: Option<String>,
    head: Option<usize>,
    asked: Asked,
) -> PyResult<Budgeted<'_>> {
    let axes = asked.axes.map(Rotation::<Body, Part>::from_matrix).transpose().map_err(Raise::raise)?;
    let report = py.detach(|| {
        let read = match &text {
            None => budget::read(&path),
            Some(text) => budget::from_text(&path, text),
        };
        let file = read.map_err(|error| match head {
            Some(head) if error.path() == path => of_table(&error, head),
            _ => error.raise(),
        })?;
        report(file, &asked, axes)
    })?;
    let draws = report.draws().map(|bodies| matrix(py, &bodies)).collect::<PyResult<_>>()?;
    let names = report.names();
    let scenarios = names.iter().map(|name| report.to_scenario(name.as_deref()));
    let scenarios = scenarios.collect::<Result<_, _>>().map_err(Raise::raise)?;
    let [json, text, markdown, page] = py.detach(|| {
        let document = report.to_document();
        let json = report.to_json().to_string();
        [json, document.to_text(WIDTH), document.to_markdown(), document.to_html()]
    });
    Ok(Budgeted { json, text, markdown, page, is_beyond: report.is_beyond(), draws, scenarios })
}

fn report(file: BudgetFile, asked: &Asked, axes: Option<Rotation<Body, Part>>) -> PyResult<BudgetReport> {
    let basis = asked.is_basic.map(|is_basic| if is_basic { Basis::Basic } else { Basis::Predicted });
    let questions = Questions {
        basis: basis.unwrap_or(file.questions.basis),
        about: asked.about.map(Position::from_array).or(file.questions.about),
        axes: axes.or(file.questions.axes),
        draws: asked.draws.or(file.questions.draws),
        seed: asked.seed.unwrap_or(file.questions.seed),
    };
    if let Some(draws) = questions.draws.filter(|draws| *draws > budget::MOST_DRAWS) {
        let rule = format!("draws = {draws} must be at most {}", budget::MOST_DRAWS);
        return Err(refused(rule, None));
    }
    if questions.draws == Some(0) && !file.limits.is_empty() {
        let hint = "leave draws out";
        return Err(refused("the limits of the file need draws, but draws is 0", Some(hint)));
    }
    let configuration = asked.configuration.as_deref();
    BudgetReport::of_file(file, &questions, configuration, Scope::Full, &mut |_, _| ()).map_err(Raise::raise)
}

/// Returns the error with the row of the dataframe, from 0, instead of a place in the generated
/// text.
fn of_table(error: &FormatError, head: usize) -> PyErr {
    let row = error.place().and_then(|place| place.line.checked_sub(head + 2));
    let message = match row {
        Some(row) => format!("row {row}: {}", error.message()),
        None => error.message(),
    };
    refused(message, error.hint().as_deref())
}
