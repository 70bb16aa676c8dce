//! Tables of cells that have their positions.

use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

use polhode_source::text::{cut, visible};
use polhode_source::toml::source::Source;
use polhode_source::{FormatError, FormatErrorKind, Place, Spot};

use super::cell::{Cell, SheetRow, cell_name};
use super::fields;
use super::xlsx::{Cells, Workbook};

/// Table of cells. Empty cells and empty rows are left out.
///
/// A million rows are common. Cells are therefore kept as text or packed, and made row by row.
#[derive(Debug)]
pub(crate) struct Sheet<'a> {
    pub rows: Cow<'a, [SheetRow]>,
    pub body: Body<'a>,
    /// True if numbers in text have a decimal comma.
    pub decimal_comma: bool,
}

/// Source and cells of a table.
#[derive(Clone, Debug)]
pub(crate) enum Body<'a> {
    /// Fields of a text file, between separators.
    Text { source: Source<'a>, separator: u8 },
    /// A sheet of a workbook.
    Workbook { path: &'a Path, sheet: String, cells: Cells<'a> },
}

impl<'a> Sheet<'a> {
    /// Returns a sheet of a workbook as a table, with statements for the report.
    pub(crate) fn of_workbook(
        workbook: &'a Workbook,
        path: &'a Path,
        name: &str,
    ) -> Option<(Self, Vec<String>)> {
        let (rows, cells, lines) = workbook.sheet(name)?;
        let body = Body::Workbook { path, sheet: name.to_owned(), cells };
        Some((Self { rows: rows.into(), body, decimal_comma: false }, lines))
    }

    pub(crate) fn path(&self) -> &Path {
        match &self.body {
            Body::Text { source, .. } => source.path,
            Body::Workbook { path, .. } => path,
        }
    }

    /// Returns a key with the place where this file has keys, for advice.
    pub(crate) fn as_key(&self, key: &str) -> String {
        match &self.body {
            Body::Text { .. } => format!("# {key} above the headings"),
            Body::Workbook { .. } => format!("{key} in the sheet \"plan\""),
        }
    }

    /// Returns the cells of a row.
    pub(crate) fn row(&self, row: &SheetRow) -> Vec<Cell<'a>> {
        match &self.body {
            Body::Text { source, separator } => fields::cells(source.text, *separator, row),
            Body::Workbook { cells, .. } => cells.row(row),
        }
    }

    /// Returns the position of a cell.
    pub(crate) fn spot(&self, cell: &Cell<'_>) -> Spot {
        match &self.body {
            Body::Text { source, .. } => Spot::Text(source.place(cell.span.clone())),
            Body::Workbook { sheet, .. } => Spot::Cell(cell_name(sheet, cell.column, cell.row)),
        }
    }

    /// Returns an error at a cell.
    pub(crate) fn error(&self, cell: &Cell<'_>, kind: FormatErrorKind) -> FormatError {
        FormatError::at(self.path(), Some(self.spot(cell)), kind)
    }

    /// Returns an error about a value that violates a rule.
    pub(crate) fn invalid(&self, cell: &Cell<'_>, heading: &str, rule: impl Into<String>) -> FormatError {
        let value = cut(&cell.text).chars().map(visible).collect();
        let key = cut(heading).chars().map(visible).collect();
        self.error(cell, FormatErrorKind::Value { key, value, rule: rule.into() })
    }

    /// Returns true if a line of a text begins with a # that is not in quotes.
    pub(crate) fn is_remark(&self, first: &Cell<'_>) -> bool {
        match &self.body {
            Body::Text { source, .. } => {
                first.column == 0 && source.text.as_bytes().get(first.span.start) == Some(&b'#')
            }
            Body::Workbook { .. } => false,
        }
    }

    /// Returns an error at a row, or about the whole table.
    pub(crate) fn row_error(&self, row: Option<usize>, kind: FormatErrorKind) -> FormatError {
        let first = row.and_then(|row| self.rows.get(row)).and_then(|row| self.row(row).into_iter().next());
        match first {
            Some(cell) => self.error(&cell, kind),
            None => FormatError::new(self.path(), None, kind),
        }
    }

    /// Moves an error in a text that was made of cells to the source cell of that part, or to
    /// `otherwise`.
    pub(crate) fn moved(
        &self,
        error: FormatError,
        cells: &[(Range<usize>, &Cell<'_>)],
        otherwise: &Cell<'_>,
    ) -> FormatError {
        let of = |place: &Place| cells.iter().find(|(range, _)| range.contains(&place.span.start));
        error.moved(self.path(), |place| Some(self.spot(of(place).map_or(otherwise, |(_, cell)| cell))))
    }
}
