//! Cells of a row, by the keys of their columns.

use std::borrow::Cow;

use polhode_source::FormatError;
use polhode_source::text::{cut, is_unseen};
use polhode_source::unit::{Dimension, unit_of};

use super::cell::{Cell, Content};
use super::heading::{Column, ColumnUnit, Columns, Spread};
use super::key::{COUNT, Holds, KEYS};
use super::measured::measured;
use super::number::{Amount, Measured, Wrong};
use super::sheet::Sheet;

/// Cells of a row, at least one of which is in a column that is read.
pub(crate) struct Cells<'c, 'a> {
    cells: &'c [Cell<'a>],
    columns: &'c Columns,
    /// First cell in a column that is read.
    pub first: &'c Cell<'a>,
}

/// Number in a row.
#[derive(Clone, Copy)]
pub(crate) struct Given<'s, 'a> {
    pub value: f64,
    /// Error after ± in the cell, as a standard deviation.
    error: Option<Amount>,
    pub cell: &'s Cell<'a>,
}

/// Standard deviation of a number in a row.
#[derive(Clone, Copy)]
pub(crate) struct Deviation<'s, 'a> {
    pub amount: Amount,
    pub cell: &'s Cell<'a>,
}

/// Reader of the numbers of rows. It also checks their units.
pub(crate) struct Reader<'s, 'a> {
    pub sheet: &'s Sheet<'a>,
    pub columns: &'s Columns,
    coverage_factor: f64,
    /// Cells without and with units, by key.
    units: [Used<'a>; COUNT],
    /// True if an error after ± was read.
    pub plus_minus: bool,
}

/// First cells without and with a unit, under headings without one.
#[derive(Clone, Default)]
struct Used<'a> {
    bare: Option<Cell<'a>>,
    united: Option<Cell<'a>>,
}

impl<'c, 'a> Cells<'c, 'a> {
    /// Collects the cells of a row. A cell outside all columns is an error.
    pub(crate) fn of(
        sheet: &Sheet<'a>,
        columns: &'c Columns,
        cells: &'c [Cell<'a>],
    ) -> Result<Option<Self>, FormatError> {
        let mut first = None;
        for cell in cells {
            match columns.all.get(cell.column) {
                Some(Some(_)) => first = first.or(Some(cell)),
                Some(None) if columns.is_ignored(cell.column) => {}
                _ => {
                    let error = sheet.invalid(cell, "a cell outside the columns", "under a heading");
                    return Err(error.with_hint("put a cell that contains a separator in quotes"));
                }
            }
        }
        Ok(first.map(|first| Self { cells, columns, first }))
    }

    pub(crate) fn cell(&self, key: usize) -> Option<&'c Cell<'a>> {
        self.under(self.columns.places.get(key).copied().flatten()?)
    }

    pub(crate) fn spread(&self, key: usize) -> Option<&'c Cell<'a>> {
        self.under(self.columns.spreads.get(key).copied().flatten()?)
    }

    fn under(&self, column: usize) -> Option<&'c Cell<'a>> {
        self.cells.iter().find(|cell| cell.column == column)
    }

    /// Returns the first cell with one of these keys, or in its column of errors.
    pub(crate) fn any(&self, keys: impl IntoIterator<Item = usize>) -> Option<&'c Cell<'a>> {
        keys.into_iter().find_map(|key| self.cell(key).or(self.spread(key)))
    }
}

impl<'s, 'a> Reader<'s, 'a> {
    pub(crate) fn new(sheet: &'s Sheet<'a>, columns: &'s Columns, coverage_factor: f64) -> Self {
        let units = core::array::from_fn(|_| Used::default());
        Self { sheet, columns, coverage_factor, units, plus_minus: false }
    }

    /// Returns the heading above a cell.
    pub(crate) fn heading(&self, cell: &Cell<'_>) -> &'s str {
        self.columns.get(cell.column).map_or("", |column| column.heading.as_str())
    }

    /// Returns an error about a cell that violates a rule.
    pub(crate) fn invalid(&self, cell: &Cell<'_>, rule: impl Into<String>) -> FormatError {
        self.sheet.invalid(cell, self.heading(cell), rule)
    }

    fn wrong(&self, cell: &Cell<'_>, wrong: Wrong) -> FormatError {
        wrong.at(|kind| self.sheet.error(cell, kind))
    }

    /// Returns the text of a cell, or an error if the cell cannot be read.
    pub(crate) fn whole<'c>(&self, cell: &'c Cell<'a>) -> Result<&'c str, FormatError> {
        match cell.content {
            Content::Broken(broken) => Err(self.invalid(cell, broken.rule())),
            _ => Ok(cell.text.as_ref()),
        }
    }

    /// Returns the text under a key.
    pub(crate) fn text<'c>(&self, cells: &Cells<'c, 'a>, key: usize) -> Result<Option<&'c str>, FormatError> {
        cells.cell(key).map(|cell| self.whole(cell)).transpose()
    }

    /// Returns the name under a key, with one space between its words. Invisible characters are an
    /// error.
    pub(crate) fn label(&self, cells: &Cells<'_, 'a>, key: usize) -> Result<Option<String>, FormatError> {
        cells.cell(key).map(|cell| self.label_of(cell)).transpose()
    }

    /// Returns the name in a cell.
    pub(crate) fn label_of(&self, cell: &Cell<'a>) -> Result<String, FormatError> {
        let text = self.whole(cell)?;
        if text.chars().any(|c| is_unseen(c) && !c.is_whitespace()) {
            return Err(self.invalid(cell, "a name of visible characters"));
        }
        Ok(text.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    /// Returns the text of a number with a decimal point.
    pub(crate) fn pointed<'c>(&self, cell: &'c Cell<'a>) -> Result<Cow<'c, str>, FormatError> {
        self.whole(cell)?;
        if !self.sheet.decimal_comma || cell.content != Content::Text || !cell.text.contains([',', '.']) {
            return Ok(Cow::Borrowed(&cell.text));
        }
        if cell.text.contains('.') {
            let rule = "a number with a decimal comma and no thousands separator";
            return Err(self.invalid(cell, rule));
        }
        Ok(Cow::Owned(cell.text.replace(',', ".")))
    }

    /// Reads the number under a key.
    pub(crate) fn number<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        key: usize,
    ) -> Result<Option<Given<'c, 'a>>, FormatError> {
        let Some(cell) = cells.cell(key) else { return Ok(None) };
        let Some(column) = self.columns.get(cell.column) else { return Ok(None) };
        let text = self.pointed(cell)?;
        let holds = KEYS.get(key).map(|key| key.holds);
        let dimension = holds.and_then(Holds::dimension).unwrap_or(Dimension::NONE);
        let read = if matches!(holds, Some(Holds::Measured(_))) && !column.is_percent() {
            // If the heading has the unit of a surface or line density, the cells have that
            // dimension too.
            let dimension = if column.has_unit() { column.unit().dimension } else { dimension };
            measured(&text, column.unit(), dimension, self.heading(cell)).map(|read| column.of_cell(read))
        } else {
            column.number(&text, dimension)
        };
        let Measured { value, error, has_unit } = read.map_err(|wrong| self.wrong(cell, wrong))?;
        let error = error.map(|amount| self.covered(cell, amount)).transpose()?;
        self.used(key, cell, has_unit || dimension == Dimension::NONE || value == 0.0)?;
        Ok(Some(Given { value, error, cell }))
    }

    /// Converts an error after ± to a standard deviation.
    fn covered(&mut self, cell: &Cell<'_>, amount: Amount) -> Result<Amount, FormatError> {
        self.plus_minus = true;
        let k = self.coverage_factor;
        self.not_negative(cell, amount.map(|amount| amount / k))
    }

    fn not_negative(&self, cell: &Cell<'_>, amount: Amount) -> Result<Amount, FormatError> {
        let (Amount::Absolute(number) | Amount::Relative(number)) = amount;
        if number >= 0.0 {
            return Ok(amount);
        }
        Err(self.invalid(cell, "with an error that is zero or positive").with_hint("an error has no sign"))
    }

    /// Returns the standard deviation of a number, from its own cell or from its column of errors.
    pub(crate) fn deviation<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        key: usize,
        given: Option<Given<'c, 'a>>,
    ) -> Result<Option<Deviation<'c, 'a>>, FormatError> {
        let own = given.and_then(|given| Some(Deviation { amount: given.error?, cell: given.cell }));
        let Some(cell) = cells.spread(key) else { return Ok(own) };
        if own.is_some() {
            return Err(self.invalid(cell, "left out, because the number already has an error"));
        }
        let Some(column) = self.columns.get(cell.column) else { return Ok(None) };
        let dimension = KEYS.get(key).and_then(|key| key.holds.dimension()).unwrap_or(Dimension::NONE);
        let text = self.pointed(cell)?;
        let read = column.number(&text, dimension).map_err(|wrong| self.wrong(cell, wrong))?;
        let Measured { value: number, has_unit, .. } = read;
        let is_relative = column.is_percent() || text.ends_with('%');
        if !has_unit && number != 0.0 && self.columns.of_key(key).is_some_and(Column::has_unit) {
            let error = self.invalid(cell, "given with a unit, like its number");
            return Err(error.with_hint(format!("write the unit in the heading, or {text} %")));
        }
        self.used(key, cell, has_unit || number == 0.0)?;
        let amount = if is_relative { Amount::Relative(number) } else { Amount::Absolute(number) };
        let amount = match column.spread {
            Some(Spread::PlusMinus) => self.covered(cell, amount)?,
            _ => self.not_negative(cell, amount)?,
        };
        Ok(Some(Deviation { amount, cell }))
    }

    /// Returns the error of a stated number, from its own cell or from its column of errors. It is
    /// a tolerance, so the coverage factor does not apply.
    pub(crate) fn tolerance<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        given: Given<'c, 'a>,
    ) -> Result<Option<Amount>, FormatError> {
        let key = super::key::SUBTOTAL;
        let column = cells.spread(key).and_then(|cell| self.columns.get(cell.column));
        let is_deviation = column.is_some_and(|column| column.spread == Some(Spread::Deviation));
        let k = if is_deviation { 1.0 } else { self.coverage_factor };
        let used = self.plus_minus;
        let deviation = self.deviation(cells, key, Some(given))?;
        self.plus_minus = used;
        Ok(deviation.map(|deviation| deviation.amount.map(|amount| k * amount)))
    }

    /// Returns true if a number is in percent, by its cell or by its heading.
    pub(crate) fn is_percent(&self, cell: &Cell<'_>) -> bool {
        let column = self.columns.get(cell.column);
        cell.text.contains('%') || column.is_some_and(Column::is_percent)
    }

    /// Refuses a number without a unit if others in its column have one and the heading has none.
    fn used(&mut self, key: usize, cell: &Cell<'a>, has_unit: bool) -> Result<(), FormatError> {
        let heading = self.columns.get(cell.column).map(|column| &column.unit);
        let Some(used) = self.units.get_mut(key).filter(|_| matches!(heading, Some(ColumnUnit::None))) else {
            return Ok(());
        };
        let slot = match (has_unit, unit_of(&cell.text).is_empty()) {
            (false, _) => &mut used.bare,
            (true, false) => &mut used.united,
            (true, true) => return Ok(()),
        };
        slot.get_or_insert_with(|| cell.clone());
        let (Some(bare), Some(united)) = (&used.bare, &used.united) else { return Ok(()) };
        let rule = format!("given with its unit, as \"{}\" in row {} is", cut(&united.text), united.row);
        let bare = bare.clone();
        Err(self.invalid(&bare, rule).with_hint("write the unit in the heading, for all rows"))
    }

    /// Returns the headings under which numbers have no unit.
    pub(crate) fn bare(&self) -> Vec<&'s str> {
        self.units.iter().filter_map(|used| used.bare.as_ref()).map(|cell| self.heading(cell)).collect()
    }
}

/// Largest standard deviation: of any number in SI, and of a mass relative to it.
pub(crate) const MOST_DEVIATION: f64 = 1e100;

impl Deviation<'_, '_> {
    /// Returns the standard deviation for this value of the number.
    pub(crate) fn of(&self, value: f64, reader: &Reader<'_, '_>) -> Result<f64, FormatError> {
        let sd = self.amount.of(value).ok_or_else(|| {
            let error = reader.invalid(self.cell, "an absolute value: a percentage of zero is zero");
            error.with_hint("write it with a unit")
        })?;
        self.within(sd, MOST_DEVIATION, reader)?;
        Ok(sd)
    }

    /// Refuses a standard deviation whose square overflows.
    pub(crate) fn within(&self, sd: f64, most: f64, reader: &Reader<'_, '_>) -> Result<(), FormatError> {
        if sd <= most {
            return Ok(());
        }
        let rule = format!("with a standard deviation of {most:e} at most, in SI: it is {sd:e}");
        let error = reader.invalid(self.cell, rule);
        Err(too_uncertain(error, reader.coverage_factor))
    }
}

/// Adds a hint to an error about a standard deviation that is too large.
pub(crate) fn too_uncertain(error: FormatError, coverage_factor: f64) -> FormatError {
    match coverage_factor {
        1.0 => error.with_hint("check its exponent"),
        k => error.with_hint(format!("the value after ± is divided by coverage_factor, {k:e}")),
    }
}
