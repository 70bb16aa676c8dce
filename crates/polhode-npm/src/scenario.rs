//! Motions and worked solutions of scenarios.

use polhode::motion::Ending;
use polhode_document::Report as _;
use polhode_scenario::request::{explain, simulate};
use polhode_source::Failure;
use polhode_source::files::Files;
use polhode_table::output::Table;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::outcome::Outcome;

/// Output format of a worked solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Format {
    #[default]
    Markdown,
    Html,
    Latex,
    Text,
    Json,
}

/// Line width of a worked solution as text, characters.
const WIDTH: usize = 100;

/// Computes a motion: its summary, and the columns of its table.
pub(crate) fn simulate(request: &simulate::Request, files: &dyn Files) -> Outcome {
    simulated(request, files).into()
}

fn simulated(request: &simulate::Request, files: &dyn Files) -> Result<Outcome, Failure> {
    let motion = simulate::run(request, files)?;
    if let Ending::Failed { cause, .. } = motion.trajectory.ending() {
        return Err(Failure::of_motion(&request.file, cause.clone()));
    }
    let table = Table::of(&motion.trajectory, &motion.scenario().into());
    let rows = table.rows();
    let columns = table.columns().iter().enumerate().map(|(k, column)| {
        json!({ "name": column.name, "unit": column.unit, "description": column.description, "values": { "f64": [k * rows, rows] } })
    });
    let columns: Vec<Value> = columns.collect();
    let numbers = table.columns().iter().flat_map(|column| (0..rows).map(|row| column.value(row))).collect();
    Ok(Outcome::Done { value: json!({ "summary": motion.to_json(), "columns": columns }), numbers })
}

/// Writes the worked solution of a scenario.
pub(crate) fn explain(request: &explain::Request, format: Format, files: &dyn Files) -> Outcome {
    let written = explain::run(request, files).map(|solution| {
        let document = solution.0;
        Outcome::of(match format {
            Format::Markdown => document.to_markdown().into(),
            Format::Html => document.to_html().into(),
            Format::Latex => document.to_latex().into(),
            Format::Text => document.to_text(WIDTH).into(),
            Format::Json => document.to_json(),
        })
    });
    written.into()
}
