//! The cells of a row by what their columns hold.

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

/// The cells of a row, at least one of which is read.
pub(crate) struct Cells<'c, 'a> {
    cells: &'c [Cell<'a>],
    columns: &'c Columns,
    /// The first that is read.
    pub first: &'c Cell<'a>,
}

/// A number of a row.
#[derive(Clone, Copy)]
pub(crate) struct Given<'s, 'a> {
    pub value: f64,
    /// What stands after ± in the cell, as standard deviation.
    error: Option<Amount>,
    pub cell: &'s Cell<'a>,
}

/// How well a number of a row is known.
#[derive(Clone, Copy)]
pub(crate) struct Deviation<'s, 'a> {
    pub amount: Amount,
    pub cell: &'s Cell<'a>,
}

/// Reads numbers of rows, and looks after their units.
pub(crate) struct Reader<'s, 'a> {
    pub sheet: &'s Sheet<'a>,
    pub columns: &'s Columns,
    coverage_factor: f64,
    /// By keys.
    units: [Used<'a>; COUNT],
    /// Whether anything was read after ±.
    pub plus_minus: bool,
}

/// Cells without and with units, of columns whose headings have none.
#[derive(Clone, Default)]
struct Used<'a> {
    bare: Option<Cell<'a>>,
    united: Option<Cell<'a>>,
}

impl<'c, 'a> Cells<'c, 'a> {
    /// Of a row; what stands beside all columns is refused.
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
                    let error = sheet.invalid(cell, "a cell beside the columns", "under a heading");
                    return Err(error.with_hint("a cell that holds a separator is in quotes"));
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

    /// The first cell of one of these keys, or of its errors.
    pub(crate) fn any(&self, keys: impl IntoIterator<Item = usize>) -> Option<&'c Cell<'a>> {
        keys.into_iter().find_map(|key| self.cell(key).or(self.spread(key)))
    }
}

impl<'s, 'a> Reader<'s, 'a> {
    pub(crate) fn new(sheet: &'s Sheet<'a>, columns: &'s Columns, coverage_factor: f64) -> Self {
        let units = core::array::from_fn(|_| Used::default());
        Self { sheet, columns, coverage_factor, units, plus_minus: false }
    }

    /// The heading over a cell.
    pub(crate) fn heading(&self, cell: &Cell<'_>) -> &'s str {
        self.columns.get(cell.column).map_or("", |column| column.heading.as_str())
    }

    /// An error about a cell that breaks a rule.
    pub(crate) fn invalid(&self, cell: &Cell<'_>, rule: impl Into<String>) -> FormatError {
        self.sheet.invalid(cell, self.heading(cell), rule)
    }

    fn wrong(&self, cell: &Cell<'_>, wrong: Wrong) -> FormatError {
        wrong.at(|kind| self.sheet.error(cell, kind))
    }

    /// The text of a cell, unless there is nothing in it that could be read.
    pub(crate) fn whole<'c>(&self, cell: &'c Cell<'a>) -> Result<&'c str, FormatError> {
        match cell.content {
            Content::Broken(broken) => Err(self.invalid(cell, broken.rule())),
            _ => Ok(cell.text.as_ref()),
        }
    }

    /// What stands under a key.
    pub(crate) fn text<'c>(&self, cells: &Cells<'c, 'a>, key: usize) -> Result<Option<&'c str>, FormatError> {
        cells.cell(key).map(|cell| self.whole(cell)).transpose()
    }

    /// A name: with one space between its words, and without what cannot be seen.
    pub(crate) fn label(&self, cells: &Cells<'_, 'a>, key: usize) -> Result<Option<String>, FormatError> {
        cells.cell(key).map(|cell| self.label_of(cell)).transpose()
    }

    /// The name in a cell.
    pub(crate) fn label_of(&self, cell: &Cell<'a>) -> Result<String, FormatError> {
        let text = self.whole(cell)?;
        if text.chars().any(|c| is_unseen(c) && !c.is_whitespace()) {
            return Err(self.invalid(cell, "a name of characters that can be seen"));
        }
        Ok(text.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    /// A number with a decimal point.
    pub(crate) fn pointed<'c>(&self, cell: &'c Cell<'a>) -> Result<Cow<'c, str>, FormatError> {
        self.whole(cell)?;
        if !self.sheet.decimal_comma || cell.content != Content::Text || !cell.text.contains([',', '.']) {
            return Ok(Cow::Borrowed(&cell.text));
        }
        if cell.text.contains('.') {
            let rule = "a number with a decimal comma, and nothing between its thousands";
            return Err(self.invalid(cell, rule));
        }
        Ok(Cow::Owned(cell.text.replace(',', ".")))
    }

    /// A number.
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
            // Of a heading with the unit of a thin part's density that is what cells have.
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

    /// The standard deviation, of what stands after ±.
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

    /// How well a number is known, as its cell says it or one beside it.
    pub(crate) fn deviation<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        key: usize,
        given: Option<Given<'c, 'a>>,
    ) -> Result<Option<Deviation<'c, 'a>>, FormatError> {
        let own = given.and_then(|given| Some(Deviation { amount: given.error?, cell: given.cell }));
        let Some(cell) = cells.spread(key) else { return Ok(own) };
        if own.is_some() {
            return Err(self.invalid(cell, "left out where the number has its error in its own cell"));
        }
        let Some(column) = self.columns.get(cell.column) else { return Ok(None) };
        let dimension = KEYS.get(key).and_then(|key| key.holds.dimension()).unwrap_or(Dimension::NONE);
        let text = self.pointed(cell)?;
        let read = column.number(&text, dimension).map_err(|wrong| self.wrong(cell, wrong))?;
        let Measured { value: number, has_unit, .. } = read;
        let is_relative = column.is_percent() || text.ends_with('%');
        if !has_unit && number != 0.0 && self.columns.of_key(key).is_some_and(Column::has_unit) {
            let error = self.invalid(cell, "given with its unit, as the number that it is the error of is");
            return Err(error.with_hint(format!("write the unit into the heading, or {text} %")));
        }
        self.used(key, cell, has_unit || number == 0.0)?;
        let amount = if is_relative { Amount::Relative(number) } else { Amount::Absolute(number) };
        let amount = match column.spread {
            Some(Spread::PlusMinus) => self.covered(cell, amount)?,
            _ => self.not_negative(cell, amount)?,
        };
        Ok(Some(Deviation { amount, cell }))
    }

    /// What stands after ± of a number that is stated, or in a column of its own: as it is, whatever the coverage factor.
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

    /// Whether a number is in percent, by its cell or by its heading.
    pub(crate) fn is_percent(&self, cell: &Cell<'_>) -> bool {
        let column = self.columns.get(cell.column);
        cell.text.contains('%') || column.is_some_and(Column::is_percent)
    }

    /// Refuses numbers without units beside such with units, under headings without.
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
        Err(self.invalid(&bare, rule).with_hint("write the unit into the heading, for all"))
    }

    /// Headings under which numbers had no unit.
    pub(crate) fn bare(&self) -> Vec<&'s str> {
        self.units.iter().filter_map(|used| used.bare.as_ref()).map(|cell| self.heading(cell)).collect()
    }
}

/// Of any number, SI; and of a mass, relative to it.
pub(crate) const MOST_DEVIATION: f64 = 1e100;

impl Deviation<'_, '_> {
    /// Of this number.
    pub(crate) fn of(&self, value: f64, reader: &Reader<'_, '_>) -> Result<f64, FormatError> {
        let sd = self.amount.of(value).ok_or_else(|| {
            let error = reader.invalid(self.cell, "an amount, as a fraction of zero is none");
            error.with_hint("write it with a unit")
        })?;
        self.within(sd, MOST_DEVIATION, reader)?;
        Ok(sd)
    }

    /// Refuses a standard deviation of which squares are no numbers.
    pub(crate) fn within(&self, sd: f64, most: f64, reader: &Reader<'_, '_>) -> Result<(), FormatError> {
        if sd <= most {
            return Ok(());
        }
        let rule = format!("with a standard deviation of {most:e} at most, in SI: it is {sd:e}");
        let error = reader.invalid(self.cell, rule);
        Err(too_uncertain(error, reader.coverage_factor))
    }
}

/// An error about a standard deviation that is too large.
pub(crate) fn too_uncertain(error: FormatError, coverage_factor: f64) -> FormatError {
    match coverage_factor {
        1.0 => error.with_hint("check its exponent"),
        k => error.with_hint(format!("what stands after ± is divided by the coverage_factor, {k:e}")),
    }
}
