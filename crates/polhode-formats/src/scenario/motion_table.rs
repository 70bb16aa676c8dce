//! The table of a prescribed motion: times with attitudes or with ω, as CSV.
//!
//! The columns are those of the trajectory table: `time_s`, and `attitude_w … attitude_z`, or `omega_body_x_rad_s …`, or
//! `omega_space_x_rad_s …`, in any order. Fields are separated by commas; blank lines and what follows a `#` are for people.

use std::ops::Range;
use std::sync::Arc;

use polhode::body::{Finding, Severity};
use polhode::math::Attitude;
use polhode::motion::{RateAxes, Uncertainty};

use super::reader::Value;
use super::rows::Rows;
use super::tree::Known;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::{FormatError, FormatErrorKind};
use crate::{file, unit};

/// A larger table has more rows than a spline has any use for.
const LARGEST_FILE: u64 = 256 << 20;

/// What a table can be of, in the order in which it is looked for.
pub(super) const COLUMNS: [&str; 3] = ["attitude", "omega_body", "omega_space"];

/// The names of the columns of each.
const NAMES: [&[&str]; 3] = [
    &["attitude_w", "attitude_x", "attitude_y", "attitude_z"],
    &["omega_body_x_rad_s", "omega_body_y_rad_s", "omega_body_z_rad_s"],
    &["omega_space_x_rad_s", "omega_space_y_rad_s", "omega_space_z_rad_s"],
];

/// Reads the file that `table` names, relative to the scenario.
pub(super) fn read(table: &Value<'_>, columns: Option<&str>) -> Result<Arc<Rows>, FormatError> {
    let path = table.path()?;
    if let Some(Known::Rows(rows)) = table.known() {
        return Ok(rows.clone());
    }
    let bytes = file::bytes(&path, table.string()?, LARGEST_FILE).map_err(|kind| {
        let missing = matches!(kind, FormatErrorKind::Io { .. });
        let error = table.error(kind);
        let hint = format!("paths are relative to the scenario: this one is {path:?}");
        if missing { error.with_hint(hint) } else { error }
    })?;
    let rows = rows(&bytes, columns).map_err(|error| {
        FormatError::of_content(&path, &bytes, error).named_in(table.source().path, table.place())
    })?;
    let rows = Arc::new(rows);
    table.keep(Known::Rows(rows.clone()));
    Ok(rows)
}

/// What is known of the motion between the rows.
pub(super) fn finding(uncertainty: &Uncertainty) -> Finding {
    /// Beyond this the torque is a guess.
    const COARSE: f64 = 0.01;
    let Uncertainty { attitude, omega, acceleration, relative, time, is_noisy } = *uncertainty;
    let known = format!(
        "between its rows the attitude is within {attitude:.0e} rad, ω within {omega:.0e} rad/s, dω/dt within \
         {acceleration:.0e} rad/s² ({:.1e} of the greatest)",
        relative
    );
    let (code, severity, message) = match (relative > COARSE, is_noisy) {
        (true, true) => (
            "prescribed.noisy",
            Severity::Warning,
            format!(
                "the table is rounded or noisy, most at t = {time} s, and so is the torque: {known}; smooth it first"
            ),
        ),
        (true, false) => (
            "prescribed.coarse",
            Severity::Warning,
            format!(
                "the table is too coarse for the torque at t = {time} s: {known}; give rows nearer together"
            ),
        ),
        (false, _) => ("prescribed.table", Severity::Info, known),
    };
    Finding { code, severity, message, place: None }
}

fn rows(bytes: &[u8], columns: Option<&str>) -> Result<Rows, ContentError> {
    let text = str::from_utf8(bytes).map_err(|error| {
        let place = ContentPlace::Text(error.valid_up_to()..error.valid_up_to() + 1);
        let kind = ContentErrorKind::Unsupported { what: "text that is not UTF-8".to_owned() };
        ContentError::new(kind, place).hint("save the table as UTF-8")
    })?;
    let mut lines = fields(text);
    let Some((_, header)) = lines.next() else {
        return Err(missing("lines")
            .hint("write a header such as time_s,attitude_w,attitude_x,attitude_y,attitude_z"));
    };
    let width = header.len();
    let (kind, places) = chosen(text, &header, columns)?;
    let (mut times, mut numbers) = (Vec::new(), Vec::new());
    for (line, fields) in lines {
        if fields.len() != width {
            let rule = format!("{width} fields long, as the header is; it has {}", fields.len());
            let kind = ContentErrorKind::Value {
                what: "the line".to_owned(),
                value: text[line.clone()].to_owned(),
                rule,
            };
            return Err(ContentError::new(kind, ContentPlace::Text(line)));
        }
        let mut row = [0.0; 5];
        for (slot, place) in row.iter_mut().zip(&places) {
            *slot = number(text, fields.get(*place).cloned().unwrap_or_default())?;
        }
        let [time, rest @ ..] = row;
        let late = times.last().is_some_and(|last| time <= *last);
        if late {
            let (what, rule) = ("time_s".to_owned(), "after that of the row before".to_owned());
            let kind = ContentErrorKind::Value { what, value: time.to_string(), rule };
            return Err(ContentError::new(kind, ContentPlace::Text(line)));
        }
        if kind == 0 {
            Attitude::from_quaternion(rest).map_err(|_| {
                let (what, rule) = ("the attitude".to_owned(), "a quaternion that is not zero".to_owned());
                let kind = ContentErrorKind::Value { what, value: text[line.clone()].to_owned(), rule };
                ContentError::new(kind, ContentPlace::Text(line))
            })?;
        }
        times.push(time);
        numbers.push(rest);
    }
    Ok(match kind {
        0 => {
            let attitudes = numbers.iter().filter_map(|q| Attitude::from_quaternion(*q).ok()).collect();
            Rows::Attitude { times, attitudes }
        }
        _ => {
            let axes = if kind == 1 { RateAxes::Body } else { RateAxes::Space };
            Rows::Omega { axes, times, omega: numbers.iter().map(|[x, y, z, _]| [*x, *y, *z]).collect() }
        }
    })
}

/// Of which kind the table is, and where its numbers stand: the time first.
fn chosen(
    text: &str,
    header: &[Range<usize>],
    columns: Option<&str>,
) -> Result<(usize, Vec<usize>), ContentError> {
    let place = |name: &str| header.iter().position(|field| text[field.clone()].trim_matches('"') == name);
    let time = place("time_s").ok_or_else(|| missing("column time_s").hint("the time is in s"))?;
    let found = |kind: usize| {
        let places: Option<Vec<usize>> = NAMES[kind].iter().map(|name| place(name)).collect();
        places.map(|places| (kind, [vec![time], places].concat()))
    };
    let kinds = (0..COLUMNS.len()).filter(|kind| columns.is_none_or(|name| name == COLUMNS[*kind]));
    kinds.clone().find_map(found).ok_or_else(|| {
        let names = kinds.map(|kind| NAMES[kind].join(", ")).collect::<Vec<_>>().join("; or ");
        missing("columns of the motion").hint(format!("the columns are {names}"))
    })
}

/// The lines that are not blank, each with its fields, all as places in the text.
fn fields(text: &str) -> impl Iterator<Item = (Range<usize>, Vec<Range<usize>>)> {
    let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let next = move || {
        while at < text.len() {
            let start = at;
            let line = text[start..].split_inclusive('\n').next().unwrap_or_default();
            at += line.len();
            let line = line.split('#').next().unwrap_or_default();
            if !line.trim().is_empty() {
                let mut from = start;
                let mut all = Vec::new();
                for field in line.trim_end().split(',') {
                    let left = from + (field.len() - field.trim_start().len());
                    all.push(left..left + field.trim().len());
                    from += field.len() + 1;
                }
                return Some((start..start + line.trim_end().len(), all));
            }
        }
        None
    };
    std::iter::from_fn(next)
}

fn number(text: &str, field: Range<usize>) -> Result<f64, ContentError> {
    let written = &text[field.clone()];
    let fail = |kind| Err(ContentError::new(kind, ContentPlace::Text(field.clone())));
    match written.parse::<f64>().ok().or_else(|| unit::bare(written)) {
        Some(number) if number.is_finite() => Ok(number),
        Some(_) => {
            let (what, found) = ("the number".to_owned(), written.to_owned());
            fail(ContentErrorKind::NotFinite { what, found })
        }
        None => {
            let found = if written.is_empty() { "nothing".to_owned() } else { written.to_owned() };
            fail(ContentErrorKind::Expected { what: "a number".to_owned(), found })
        }
    }
}

fn missing(what: &str) -> ContentError {
    ContentError::new(ContentErrorKind::Missing { what: what.to_owned() }, ContentPlace::Whole)
}
