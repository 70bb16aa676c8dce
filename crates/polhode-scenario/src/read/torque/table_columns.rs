//! Columns of a table of torques: names and units.

use std::ops::Range;

use polhode_source::csv::{self, missing};
use polhode_source::unit::{self, Dimension};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use crate::read::rows::TorqueRows;

/// Adds a row, converted from the units of the columns to SI.
pub(super) fn push(
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

/// Column that is read.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Column {
    pub(super) place: usize,
    /// Value of the column's unit in SI.
    unit: f64,
}

/// Names of the columns.
const NAMES: [&str; 4] = ["time", "torque_x", "torque_y", "torque_z"];
pub(super) const HEADER: &str = "time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m";

/// Finds the four columns and their units.
pub(super) fn columns(
    names: &[&str],
    place: impl Fn(usize) -> ContentPlace,
) -> Result<[Column; 4], ContentError> {
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

/// Returns the number of the column with this name, and its unit: 1 and `mN m` for
/// `torque_x [mN m]`.
///
/// The suffix `n_m` means N m, as in the tables written by polhode.
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
