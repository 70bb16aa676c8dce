//! `[[torque]]` of model `table`: times with torques, as CSV or Parquet.
//!
//! Column names include units: `time_s`, `torque_x_n_m`, `torque_y_n_m`, `torque_z_n_m`, or other
//! units in brackets, `time [ms]`, `torque_x [mN m]`. The order is arbitrary; other columns are
//! ignored.

use std::sync::Arc;

use polhode::motion::torque::{Interpolation, Schedule, Tabulated, TorqueAxes, TorqueModel};
use polhode_source::FormatError;
use polhode_source::csv;
use polhode_source::csv::{fields, missing};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::tree::Known;
use polhode_source::{ContentError, ContentPlace};

#[cfg(feature = "parquet")]
use super::parquet::of_parquet;
use super::table_columns::{HEADER, columns, push};
use super::{allow, schedule};
use crate::read::rows::TorqueRows;

/// Reads `axes = "body" | "space"`, `table = "torques.csv"`,
/// `interpolation = "steps" | "linear" | "spline"`, `scale`. The table must cover the time in which
/// it acts, up to the end of the run.
pub(crate) fn table(table: &Table<'_>, end: Option<f64>) -> Result<TorqueModel, FormatError> {
    allow(table, &["axes", "table", "interpolation", "scale"])?;
    let axes = match table.require("axes", "axes = \"body\"")?.choice(&["body", "space"])? {
        "body" => TorqueAxes::Body,
        _ => TorqueAxes::Space,
    };
    let form = table.require("table", "table = \"torques.csv\"")?;
    let between = table.require("interpolation", "interpolation = \"linear\"")?;
    let interpolation = match between.choice(&["steps", "linear", "spline"])? {
        "steps" => Interpolation::Steps,
        "linear" => Interpolation::Linear,
        _ => Interpolation::Spline,
    };
    let scale = table.get("scale").map_or(Ok(1.0), |scale| scale.number())?;
    let rows = read(&form)?;
    let torques: Vec<_> = rows.torques.iter().map(|n| n.map(|component| scale * component)).collect();
    let tabulated = Tabulated::new(axes, interpolation, &rows.times, &torques);
    let tabulated = tabulated.map_err(|error| form.motion(error))?;
    covers(&form, &rows.times, schedule::schedule(table)?, end)?;
    Ok(TorqueModel::Tabulated(Box::new(tabulated)))
}

/// Refuses a table that does not cover the time in which the torque acts.
fn covers(
    form: &Value<'_>,
    times: &[f64],
    schedule: Option<Schedule>,
    end: Option<f64>,
) -> Result<(), FormatError> {
    let (Some(end), [first, .., last]) = (end, times) else { return Ok(()) };
    let [from, until] = schedule.and_then(|schedule| schedule.as_window()).unwrap_or([0.0, end]);
    let (from, until) = (from.max(0.0), until.min(end));
    if from < until && (*first > from || *last < until) {
        let rule =
            format!("defined while the torque acts, from {from} to {until} s; it covers {first} to {last} s");
        let (from, until) = (first.max(from), last.min(until));
        let hint = match from < until {
            true => {
                format!(
                    "give more rows, or limit the time of the torque: from = \"{from} s\", until = \"{until} s\""
                )
            }
            false => "give more rows: none is within the run".to_owned(),
        };
        return Err(form.invalid(rule).with_hint(hint));
    }
    Ok(())
}

/// Reads the file named by `table`, relative to the scenario.
fn read(table: &Value<'_>) -> Result<Arc<TorqueRows>, FormatError> {
    let path = table.path()?;
    if let Some(rows) = table.known_as::<TorqueRows>() {
        return Ok(rows);
    }
    let bytes = csv::bytes(table, &path)?;
    let rows = if bytes.starts_with(b"PAR1") { of_parquet(&bytes) } else { of_text(&bytes) };
    let rows = rows.map_err(|error| {
        FormatError::of_content(&path, &bytes, error).named_in(table.source().path, table.place())
    })?;
    let rows = Arc::new(rows);
    table.keep(Known::File(rows.clone()));
    Ok(rows)
}

fn of_text(bytes: &[u8]) -> Result<TorqueRows, ContentError> {
    let text = csv::text(bytes)?;
    let mut lines = fields(text);
    let Some((_, header)) = lines.next() else {
        return Err(missing("lines").hint(format!("write a header such as {HEADER}")));
    };
    let names: Vec<&str> = header.iter().map(|field| text[field.clone()].trim_matches('"')).collect();
    let columns = columns(&names, |k| ContentPlace::Text(header.get(k).cloned().unwrap_or_default()))?;
    let places: Vec<usize> = columns.iter().map(|column| column.place).collect();
    let mut rows = TorqueRows::default();
    for (line, fields) in lines {
        let row = csv::numbers::<4>(text, &line, &fields, header.len(), &places)?;
        push(&mut rows, &columns, row, line)?;
    }
    Ok(rows)
}

#[cfg(not(feature = "parquet"))]
fn of_parquet(_: &[u8]) -> Result<TorqueRows, ContentError> {
    let what = "Parquet: this program was built without it".to_owned();
    let error =
        ContentError::new(polhode_source::ContentErrorKind::Unsupported { what }, ContentPlace::Whole);
    Err(error.hint("write the table as CSV"))
}
