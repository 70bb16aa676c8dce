//! Tables of cells that know where they stand.

use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::source::Source;

/// A table: a row of headings, then rows. Cells that are empty are left out, and so are rows of such.
#[derive(Debug)]
pub(super) struct Sheet<'a> {
    pub(super) origin: Origin<'a>,
    pub(super) rows: Vec<SheetRow>,
    pub(super) cells: Vec<Cell<'a>>,
}

/// Where a table is from.
#[derive(Clone, Copy, Debug)]
pub(super) enum Origin<'a> {
    /// A text file.
    Text(Source<'a>),
}

/// A row, by its cells.
#[derive(Clone, Debug)]
pub(super) struct SheetRow {
    pub(super) cells: Range<usize>,
}

/// What stands in a cell, without the spaces around it: not empty.
#[derive(Clone, Debug)]
pub(super) struct Cell<'a> {
    pub(super) column: usize,
    /// In a text file: its bytes.
    pub(super) span: Range<usize>,
    pub(super) text: Cow<'a, str>,
}

impl<'a> Sheet<'a> {
    pub(super) fn path(&self) -> &Path {
        match self.origin {
            Origin::Text(source) => source.path,
        }
    }

    pub(super) fn row(&self, row: &SheetRow) -> &[Cell<'a>] {
        self.cells.get(row.cells.clone()).unwrap_or_default()
    }

    /// An error at a cell.
    pub(super) fn error(&self, cell: &Cell<'_>, kind: FormatErrorKind) -> FormatError {
        match self.origin {
            Origin::Text(source) => source.error(cell.span.clone(), kind),
        }
    }

    /// An error at a row as a whole, or about the whole table.
    pub(super) fn row_error(&self, row: Option<usize>, kind: FormatErrorKind) -> FormatError {
        let first = row.and_then(|row| self.rows.get(row)).and_then(|row| self.row(row).first());
        match first {
            Some(cell) => self.error(cell, kind),
            None => FormatError::new(self.path(), None, kind),
        }
    }
}
