//! A `[[torque]]` of model `table`: times with torques, as CSV or Parquet.
//!
//! Columns name their units: `time_s`, `torque_x_n_m`, `torque_y_n_m`, `torque_z_n_m`, or with other units in brackets, `time [ms]`,
//! `torque_x [mN m]`, in any order; others are not read.

use std::ops::Range;
use std::sync::Arc;

use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
use ::parquet::record::Field;
use bytes::Bytes;
use polhode::motion::torque::{Interpolation, Schedule, Tabulated, TorqueAxes, TorqueModel};
use polhode_source::FormatError;
use polhode_source::csv;
use polhode_source::csv::{fields, missing};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::tree::Known;
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{allow, schedule};
use crate::read::rows::TorqueRows;

/// `axes = "body" | "space"`, `table = "torques.csv"`, `interpolation = "steps" | "linear" | "spline"`, `scale`; the table has to cover
/// the time in which it acts, up to the end of the run.
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

/// Refuses a table that begins after it acts, or ends before.
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
        let rule = format!("as long as it acts, {from} to {until} s: it is from {first} to {last} s");
        let (from, until) = (first.max(from), last.min(until));
        let hint = match from < until {
            true => {
                format!("give more rows, or say when it acts: from = \"{from} s\", until = \"{until} s\"")
            }
            false => "give more rows: it has none at the times of the run".to_owned(),
        };
        return Err(form.invalid(rule).with_hint(hint));
    }
    Ok(())
}

/// Reads the file that `table` names, relative to the scenario.
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

fn of_parquet(bytes: &[u8]) -> Result<TorqueRows, ContentError> {
    let broken = |error: ::parquet::errors::ParquetError| {
        let kind = ContentErrorKind::Unsupported { what: format!("this Parquet file ({error})") };
        ContentError::new(kind, ContentPlace::Whole)
            .hint("write it without compression, or with LZ4 or Snappy")
    };
    let file = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(broken)?;
    // A row has a field for each of these, whatever is nested in it.
    let schema = file.metadata().file_metadata().schema();
    let names: Vec<&str> = schema.get_fields().iter().map(|field| field.name()).collect();
    let columns = columns(&names, |_| ContentPlace::Whole)?;
    let mut rows = TorqueRows::default();
    for row in file.get_row_iter(None).map_err(broken)? {
        let row = row.map_err(broken)?;
        let fields: Vec<&Field> = row.get_column_iter().map(|(_, field)| field).collect();
        let mut numbers = [0.0; 4];
        for (slot, column) in numbers.iter_mut().zip(&columns) {
            let field = fields.get(column.place).copied().unwrap_or(&Field::Null);
            *slot = number(field).ok_or_else(|| {
                let what = names.get(column.place).copied().unwrap_or_default().to_owned();
                let rule = format!("a finite number; it is that of row {}", rows.times.len() + 1);
                let kind = ContentErrorKind::Value { what, value: field.to_string(), rule };
                ContentError::new(kind, ContentPlace::Whole)
            })?;
        }
        push(&mut rows, &columns, numbers, 0..0)
            .map_err(|error| ContentError { place: ContentPlace::Whole, ..error })?;
    }
    Ok(rows)
}

/// A finite number.
fn number(field: &Field) -> Option<f64> {
    let number = match *field {
        Field::Double(x) => x,
        Field::Float(x) => f64::from(x),
        Field::Int(n) => f64::from(n),
        Field::Long(n) => n as f64,
        _ => return None,
    };
    number.is_finite().then_some(number)
}

/// Adds a row, in the columns' units.
fn push(
    rows: &mut TorqueRows,
    columns: &[Column; 4],
    row: [f64; 4],
    line: Range<usize>,
) -> Result<(), ContentError> {
    let [time, torque @ ..]: [f64; 4] = std::array::from_fn(|k| row[k] * columns[k].unit);
    csv::ascending(&rows.times, time, line)?;
    rows.times.push(time);
    rows.torques.push(torque);
    Ok(())
}

/// A column that is read.
#[derive(Clone, Copy, Debug, Default)]
struct Column {
    place: usize,
    /// What one of its unit is in SI.
    unit: f64,
}

/// The columns, and a header that has them.
const NAMES: [&str; 4] = ["time", "torque_x", "torque_y", "torque_z"];
const HEADER: &str = "time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m";

/// Where the four columns stand, and in which units.
fn columns(names: &[&str], place: impl Fn(usize) -> ContentPlace) -> Result<[Column; 4], ContentError> {
    let mut columns = [None; 4];
    for (k, name) in names.iter().enumerate() {
        let Some((n, unit)) = split(name) else { continue };
        let dimension = if n == 0 { Dimension::TIME } else { Dimension::TORQUE };
        let refused = |what: String, value: &str, rule: String| {
            ContentError::new(ContentErrorKind::Value { what, value: value.to_owned(), rule }, place(k))
        };
        if unit.is_empty() {
            let question = format!("in which unit is {}?", NAMES[n]);
            let kind = ContentErrorKind::Unclear { question, found: String::new() };
            let hint = format!(
                "name the unit in the header: {HEADER}, or {} [{}]",
                NAMES[n],
                ["ms", "mN m"][n.min(1)]
            );
            return Err(ContentError::new(kind, place(k)).hint(hint));
        }
        let unit = unit::factor(&unit, dimension).map_err(|wrong| {
            refused(format!("the unit of {}", NAMES[n]), &unit, format!("a unit that polhode knows: {wrong}"))
        })?;
        if columns[n].replace(Column { place: k, unit }).is_some() {
            return Err(refused("the column".to_owned(), name, "named once".to_owned()));
        }
    }
    let mut found = [Column::default(); 4];
    for ((slot, column), name) in found.iter_mut().zip(columns).zip(NAMES) {
        let lacking = || missing(&format!("column {name}")).hint(format!("the columns are {HEADER}"));
        *slot = column.ok_or_else(lacking)?;
    }
    Ok(found)
}

/// Which column a name is, and its unit: of `torque_x [mN m]` 1 and `mN m`; `n_m` is N m, as in the tables that polhode writes.
fn split(name: &str) -> Option<(usize, String)> {
    let name = name.trim();
    let n = NAMES.iter().rposition(|known| name.starts_with(known))?;
    let rest = name[NAMES[n].len()..].trim();
    if let Some(unit) = rest.strip_prefix(['[', '(']) {
        return Some((n, unit.trim_end_matches([']', ')']).trim().to_owned()));
    }
    match rest.strip_prefix('_') {
        Some("n_m") => Some((n, "N m".to_owned())),
        Some(unit) => Some((n, unit.replace('_', " "))),
        None => rest.is_empty().then(|| (n, String::new())),
    }
}
