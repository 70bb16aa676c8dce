//! What the columns of a parts list are.

use super::number::Unit;
use super::sheet::{Cell, Sheet};
use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::suggestion::nearest;
use crate::unit::Dimension;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Key {
    Name,
    Parent,
    Quantity,
    Mass,
    X,
    Y,
    Z,
    Ixx,
    Iyy,
    Izz,
    Ixy,
    Ixz,
    Iyz,
    AtX,
    AtY,
    AtZ,
}

/// The number of keys.
pub(super) const KEYS: usize = NAMES.len();

/// Each key's name and, of a number, what it measures.
pub(super) const NAMES: [(&str, Option<Dimension>); 16] = {
    const MASS: Option<Dimension> = Some(Dimension::MASS);
    const LENGTH: Option<Dimension> = Some(Dimension::LENGTH);
    const INERTIA: Option<Dimension> = Some(Dimension::INERTIA);
    [
        ("name", None),
        ("parent", None),
        ("quantity", None),
        ("mass", MASS),
        ("x", LENGTH),
        ("y", LENGTH),
        ("z", LENGTH),
        ("ixx", INERTIA),
        ("iyy", INERTIA),
        ("izz", INERTIA),
        ("ixy", INERTIA),
        ("ixz", INERTIA),
        ("iyz", INERTIA),
        ("at x", LENGTH),
        ("at y", LENGTH),
        ("at z", LENGTH),
    ]
};

/// A column.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub(super) key: usize,
    /// Its heading, as it is written.
    pub(super) heading: String,
    pub(super) unit: Option<Unit>,
}

/// The columns by the headings in the first row.
pub(super) fn columns(sheet: &Sheet<'_>, headings: &[Cell<'_>]) -> Result<Vec<Option<Column>>, FormatError> {
    let mut columns: Vec<Option<Column>> = Vec::new();
    for cell in headings {
        let column = column(sheet, cell)?;
        columns.resize(cell.column, None);
        columns.push(Some(column));
    }
    Ok(columns)
}

fn column(sheet: &Sheet<'_>, cell: &Cell<'_>) -> Result<Column, FormatError> {
    let (name, unit) = split(&cell.text);
    let name = name.to_lowercase().replace('_', " ");
    let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some(key) = NAMES.iter().position(|(known, _)| *known == name) else {
        let known = NAMES.iter().map(|(name, _)| *name).collect();
        let suggestion = nearest(&name, NAMES.iter().map(|(name, _)| *name));
        let key = cell.text.to_string();
        let table = "the parts list".to_owned();
        return Err(sheet.error(cell, FormatErrorKind::UnknownKey { key, table, suggestion, known }));
    };
    let unit = match (unit, NAMES[key].1) {
        (Some(unit), Some(dimension)) => Some(
            Unit::new(unit, dimension).map_err(|error| sheet.error(cell, FormatErrorKind::Unit(error)))?,
        ),
        _ => None,
    };
    Ok(Column { key, heading: cell.text.to_string(), unit })
}

/// `mass [kg]`, `mass (kg)`: name and unit.
fn split(heading: &str) -> (&str, Option<&str>) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, rest)) = heading.split_once(open)
            && let Some(unit) = rest.trim_end().strip_suffix(close)
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    (heading.trim(), None)
}
