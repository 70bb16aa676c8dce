//! Table of a prescribed motion: times with attitudes or ω, as CSV.
//!
//! The columns are those of the trajectory table: `time_s`, and `attitude_w … attitude_z`, or
//! `omega_body_x_rad_s …`, or `omega_space_x_rad_s …`, in any order. Fields are separated by
//! commas. Blank lines and text after `#` are ignored.

use std::ops::Range;
use std::sync::Arc;

use polhode::body::{Finding, Severity};
use polhode::math::Attitude;
use polhode::motion::{RateAxes, Uncertainty};
use polhode_source::ContentError;
use polhode_source::FormatError;
use polhode_source::csv;
use polhode_source::csv::{fields, missing};
use polhode_source::toml::reader::Value;
use polhode_source::toml::tree::Known;

use super::rows::Rows;

/// Kinds of tables, in the order in which they are searched.
pub(crate) const COLUMNS: [&str; 3] = ["attitude", "omega_body", "omega_space"];

/// Column names of each kind.
const NAMES: [&[&str]; 3] = [
    &["attitude_w", "attitude_x", "attitude_y", "attitude_z"],
    &["omega_body_x_rad_s", "omega_body_y_rad_s", "omega_body_z_rad_s"],
    &["omega_space_x_rad_s", "omega_space_y_rad_s", "omega_space_z_rad_s"],
];

/// Reads the file named by `table`, relative to the scenario.
pub(crate) fn read(table: &Value<'_>, columns: Option<&str>) -> Result<Arc<Rows>, FormatError> {
    let path = table.path()?;
    if let Some(rows) = table.known_as::<Rows>() {
        return Ok(rows);
    }
    let bytes = csv::bytes(table, &path)?;
    let rows = rows(&bytes, columns).map_err(|error| {
        FormatError::of_content(&path, &bytes, error).named_in(table.source().path, table.place())
    })?;
    let rows = Arc::new(rows);
    table.keep(Known::File(rows.clone()));
    Ok(rows)
}

/// Returns a finding on the uncertainty of the motion between the rows.
pub(crate) fn finding(uncertainty: &Uncertainty) -> Finding {
    /// Relative uncertainty of dω/dt above which the torque is unreliable.
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
                "the table is rounded or noisy, mostly at t = {time} s, and so is its torque: {known}; smooth the table first"
            ),
        ),
        (true, false) => (
            "prescribed.coarse",
            Severity::Warning,
            format!(
                "the table is too coarse for the torque at t = {time} s: {known}; give rows at shorter intervals"
            ),
        ),
        (false, _) => ("prescribed.table", Severity::Info, known),
    };
    Finding { code, severity, message, place: None }
}

fn rows(bytes: &[u8], columns: Option<&str>) -> Result<Rows, ContentError> {
    let text = csv::text(bytes)?;
    let mut lines = fields(text);
    let Some((_, header)) = lines.next() else {
        return Err(missing("lines")
            .hint("write a header such as time_s,attitude_w,attitude_x,attitude_y,attitude_z"));
    };
    let width = header.len();
    let (kind, places) = chosen(text, &header, columns)?;
    let (mut times, mut numbers) = (Vec::new(), Vec::new());
    for (line, fields) in lines {
        let [time, rest @ ..] = csv::numbers::<5>(text, &line, &fields, width, &places)?;
        csv::ascending(&times, time, line.clone())?;
        if kind == 0 {
            let rule = "a quaternion that is not zero";
            let refused = |_| csv::value("the attitude", &text[line.clone()], rule, line.clone());
            Attitude::from_quaternion(rest).map_err(refused)?;
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

/// Returns the kind of the table and the positions of its columns, the time first.
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
