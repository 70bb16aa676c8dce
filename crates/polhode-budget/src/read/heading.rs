//! Headings of a parts list: the keys and the units of its columns.

use std::collections::BTreeMap;

use polhode_source::nearest;
use polhode_source::text::{cut, visible};
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{ContentError, FormatError, FormatErrorKind};

use super::cell::{Cell, Content};
use super::key::{COUNT, DENSITY, Holds, KEYS, NAME, PATH};
use super::measured::{hundredths, percent};
use super::number::{Measured, Unit, Wrong};
use super::sheet::Sheet;

/// Column that is read.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    /// Index of its key in [`KEYS`].
    pub key: usize,
    /// Kind of errors in the column; `None` if it has the numbers themselves.
    pub spread: Option<Spread>,
    /// Heading, as messages print it.
    pub heading: String,
    pub unit: ColumnUnit,
}

/// Content of a column of errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spread {
    /// Standard deviations of the numbers.
    Deviation,
    /// Errors as after ±, to which the coverage factor applies.
    PlusMinus,
}

/// Unit of a column.
#[derive(Clone, Debug)]
pub(crate) enum ColumnUnit {
    /// No unit in the heading.
    None,
    Unit(Unit),
    Percent,
}

/// Unit of numbers under a heading without one.
static SI: Unit = Unit::SI;

/// Columns of a table.
#[derive(Debug)]
pub(crate) struct Columns {
    /// Columns by position; `None` for those that are not read.
    pub all: Vec<Option<Column>>,
    /// Index of the row of headings in the table.
    pub row: usize,
    /// Columns that are not read, with their headings.
    pub ignored: BTreeMap<usize, String>,
    /// Positions of the columns of numbers, by key.
    pub places: [Option<usize>; COUNT],
    /// Positions of the columns of errors, by key.
    pub spreads: [Option<usize>; COUNT],
}

/// Returns true if a heading is that of names. Such a heading identifies the row of headings.
pub(crate) fn is_of_names(heading: &str) -> bool {
    let name = plain(heading);
    name == KEYS[NAME].name || name == KEYS[PATH].name
}

/// Dimensions that the density of a thin surface or a rod may have.
const THIN_DENSITIES: [Dimension; 2] = [Dimension::AREA_DENSITY, Dimension::LINE_DENSITY];

/// Returns a name in the form in which columns are compared: lower case, with one space between
/// words.
pub(crate) fn plain(name: &str) -> String {
    let name = name.to_lowercase().replace('_', " ");
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl Columns {
    /// Finds the columns by their headings: the first row with a heading of names.
    pub(crate) fn of(sheet: &Sheet<'_>, ignore: &[String]) -> Result<Self, FormatError> {
        let row = sheet.rows.iter().position(|row| sheet.row(row).iter().any(|cell| is_of_names(&cell.text)));
        let row = row.ok_or_else(|| nameless(sheet))?;
        let mut columns = Self {
            all: Vec::new(),
            row,
            ignored: BTreeMap::new(),
            places: [None; COUNT],
            spreads: [None; COUNT],
        };
        for cell in &sheet.rows.get(row).map(|row| sheet.row(row)).unwrap_or_default() {
            columns.all.resize(cell.column, None);
            let column = columns.column(sheet, cell, ignore)?;
            if column.is_none() {
                columns.ignored.insert(cell.column, shown(cell));
            }
            columns.all.push(column);
        }
        Ok(columns)
    }

    fn column(
        &mut self,
        sheet: &Sheet<'_>,
        cell: &Cell<'_>,
        ignore: &[String],
    ) -> Result<Option<Column>, FormatError> {
        let heading = cell.text.to_string();
        if let Content::Broken(broken) = cell.content {
            return Err(sheet.invalid(cell, "the heading", broken.rule()));
        }
        if ignore.iter().any(|name| plain(name) == plain(&heading)) {
            return Ok(None);
        }
        let (name, unit) = split(&heading);
        let (name, spread) = spread(plain(name));
        let Some(key) = KEYS.iter().position(|key| key.name == name) else {
            return Err(unknown(sheet, cell, &name));
        };
        let holds = KEYS[key].holds;
        if holds == Holds::Remark {
            return Ok(None);
        }
        if spread.is_some() && !holds.may_err() || spread.is_none() && matches!(holds, Holds::Errors(_)) {
            return Err(unknown(sheet, cell, &plain(split(&heading).0)));
        }
        let unit = match (unit, holds.dimension()) {
            (None, _) => ColumnUnit::None,
            (Some("%"), Some(dimension)) if spread.is_some() || dimension == Dimension::NONE => {
                ColumnUnit::Percent
            }
            (Some(unit), Some(dimension)) if dimension != Dimension::NONE => {
                let others: &[Dimension] = if key == DENSITY { &THIN_DENSITIES } else { &[] };
                let unit = Unit::new(unit, dimension).or_else(|error| {
                    others.iter().find_map(|other| Unit::new(unit, *other).ok()).ok_or(error)
                });
                ColumnUnit::Unit(unit.map_err(|error| no_unit(error, |kind| sheet.error(cell, kind)))?)
            }
            _ => {
                return Err(sheet.invalid(
                    cell,
                    "the heading",
                    "without a unit: its values are not quantities",
                ));
            }
        };
        let is_alike = |other: &&Column| {
            let names = [NAME, PATH];
            other.spread.is_some() == spread.is_some()
                && (other.key == key || names.contains(&other.key) && names.contains(&key))
        };
        if let Some(other) = self.all.iter().flatten().find(is_alike) {
            let rule = format!("a column that is not given twice: it equals \"{}\"", other.heading);
            return Err(sheet.invalid(cell, "the heading", rule));
        }
        let places = if spread.is_none() { &mut self.places } else { &mut self.spreads };
        places[key] = Some(cell.column);
        Ok(Some(Column { key, spread, heading: shown(cell), unit }))
    }

    /// Returns true if a column has a heading but is not read.
    pub(crate) fn is_ignored(&self, column: usize) -> bool {
        self.ignored.contains_key(&column)
    }

    pub(crate) fn get(&self, column: usize) -> Option<&Column> {
        self.all.get(column)?.as_ref()
    }

    /// Returns the column of the numbers of a key.
    pub(crate) fn of_key(&self, key: usize) -> Option<&Column> {
        self.get((*self.places.get(key)?)?)
    }
}

impl Column {
    /// Reads a number without an error, in the unit of the column. The result is in SI, or a
    /// fraction.
    pub(crate) fn number(&self, text: &str, dimension: Dimension) -> Result<Measured, Wrong> {
        let may_be_fraction = dimension == Dimension::NONE || self.spread.is_some();
        let fraction = percent(text).filter(|_| may_be_fraction);
        let fraction = fraction.or_else(|| self.is_percent().then(|| hundredths(text)));
        match fraction {
            Some(fraction) => Ok(Measured { value: fraction?, error: None, has_unit: true }),
            None => Ok(self.of_cell(self.unit().read(text, dimension)?)),
        }
    }

    /// Returns a number of a cell. It needs no unit of its own if the heading has one.
    pub(crate) fn of_cell(&self, read: Measured) -> Measured {
        Measured { has_unit: read.has_unit || self.has_unit(), ..read }
    }

    /// Returns the unit of numbers without one.
    pub(crate) fn unit(&self) -> &Unit {
        match &self.unit {
            ColumnUnit::Unit(unit) => unit,
            ColumnUnit::None | ColumnUnit::Percent => &SI,
        }
    }

    pub(crate) const fn has_unit(&self) -> bool {
        matches!(self.unit, ColumnUnit::Unit(_))
    }

    pub(crate) const fn is_percent(&self) -> bool {
        matches!(self.unit, ColumnUnit::Percent)
    }
}

/// Returns the error of an invalid unit.
pub(crate) fn no_unit(error: UnitError, at: impl Fn(FormatErrorKind) -> FormatError) -> FormatError {
    let hint = error.hint_for_name();
    at(FormatErrorKind::Unit(error)).with_hint_of(hint)
}

/// Returns a heading as messages print it.
fn shown(cell: &Cell<'_>) -> String {
    cut(&cell.text).chars().map(visible).collect()
}

/// Splits a heading such as `mass [kg]` or `mass (kg)` into name and unit.
pub(crate) fn split(heading: &str) -> (&str, Option<&str>) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, rest)) = heading.split_once(open)
            && let Some(unit) = rest.trim_end().strip_suffix(close)
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    (heading.trim(), None)
}

/// Splits a name such as `mass sd` or `mass ±` into the key and the kind of errors.
fn spread(name: String) -> (String, Option<Spread>) {
    for (end, spread) in [
        ("sd", Spread::Deviation),
        ("±", Spread::PlusMinus),
        ("+/-", Spread::PlusMinus),
        ("+-", Spread::PlusMinus),
    ] {
        if let Some(of) = name.strip_suffix(end).and_then(|of| of.strip_suffix(' ')) {
            return (of.to_owned(), Some(spread));
        }
    }
    (name, None)
}

/// Columns that most parts lists have.
const COMMON: &str =
    "name, mass, x, y, z, ixx, iyy, izz, ixy, ixz, iyz, shape, mesh, material, quantity and others";

fn unknown(sheet: &Sheet<'_>, cell: &Cell<'_>, name: &str) -> FormatError {
    let known: Vec<&'static str> = KEYS.iter().map(|key| key.name).collect();
    let suggestion = nearest(name, known.iter().copied());
    let (key, table) = (cell.text.to_string(), "the headings".to_owned());
    let error = sheet.error(cell, FormatErrorKind::UnknownKey { key, table, suggestion, known });
    let ignore = format!("ignore = [\"{}\"]", shown(cell).replace('"', "'"));
    let hint = format!("or add {}, if it is a remark", sheet.as_key(&ignore));
    // Keys that share a word with the heading: all radii for an unknown radius.
    let has_word = |key: &&str| key.split(' ').any(|word| name.split(' ').any(|own| own == word));
    let alike: Vec<&str> = KEYS.iter().map(|key| key.name).filter(has_word).collect();
    match suggestion {
        Some(near) => error.with_hint(format!("did you mean {near}? {hint}")),
        None if alike.is_empty() => {
            error.with_hint(format!("columns are {COMMON}; the book lists all of them; {hint}"))
        }
        None => error.with_hint(format!("similar keys are {}; {hint}", alike.join(", "))),
    }
}

/// Returns the error of a table without a row of headings.
fn nameless(sheet: &Sheet<'_>) -> FormatError {
    let first = sheet.rows.first().map(|row| sheet.row(row)).unwrap_or_default();
    let slip =
        first.iter().find(|cell| nearest(&plain(&cell.text), [KEYS[NAME].name, KEYS[PATH].name]).is_some());
    if let Some(cell) = slip {
        return unknown(sheet, cell, &plain(&cell.text));
    }
    let what = "column with the heading \"name\", or \"path\", which marks the row of headings";
    sheet
        .row_error(sheet.rows.first().map(|_| 0), ContentError::missing(what).into())
        .with_hint("write name,mass [kg] above the first part")
}
