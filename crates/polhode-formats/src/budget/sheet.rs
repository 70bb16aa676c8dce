//! Tables of cells that know where they stand.

use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

use super::{csv, xlsx};
use crate::error::{FormatError, FormatErrorKind, Place, Spot};
use crate::scenario::source::Source;
use crate::text::{cut, visible};

/// A table. Cells that are empty are left out, and so are rows of such.
///
/// A million rows are common: cells are kept as text or packed, and made row by row.
#[derive(Debug)]
pub(super) struct Sheet<'a> {
    pub(super) origin: Origin<'a>,
    pub(super) rows: Cow<'a, [SheetRow]>,
    pub(super) body: Body<'a>,
    /// Whether numbers in text have a comma where others have a point.
    pub(super) decimal_comma: bool,
}

/// Storage of the cells of a table.
#[derive(Clone, Copy, Debug)]
pub(super) enum Body<'a> {
    /// Fields of a text, between separators.
    Text {
        text: &'a str,
        separator: u8,
    },
    Workbook(xlsx::Cells<'a>),
}

/// Where a table is from.
#[derive(Clone, Debug)]
pub(super) enum Origin<'a> {
    /// A text file.
    Text(Source<'a>),
    /// A sheet of a workbook.
    Workbook { path: &'a Path, sheet: String },
}

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct SheetRow {
    /// Number of the row in the file, from 1.
    pub(super) number: u32,
    /// Range of its bytes in a text, or of its cells in a workbook.
    pub(super) start: u32,
    pub(super) end: u32,
    /// Whether programs do not show it.
    pub(super) is_hidden: bool,
}

/// What stands in a cell, without the spaces around it: not empty.
#[derive(Clone, Debug)]
pub(super) struct Cell<'a> {
    /// From 0.
    pub(super) column: usize,
    /// The row, as the file counts.
    pub(super) row: usize,
    /// In a text file: its bytes.
    pub(super) span: Range<usize>,
    pub(super) text: Cow<'a, str>,
    pub(super) content: Content,
}

/// What kind of content a cell has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    Text,
    /// A number of a workbook, and how many decimals are shown of it.
    Number {
        decimals: Option<u8>,
    },
    /// Nothing that can be read.
    Broken(Broken),
}

/// Reason for which a cell of a workbook cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Broken {
    NoResult,
    Error,
    Thousands,
    Date,
    Merged,
}

impl Broken {
    /// Rule that the cell breaks.
    pub(super) const fn rule(self) -> &'static str {
        match self {
            Self::NoResult => {
                "a value: it is a formula without its result; open the workbook in a spreadsheet program and save it"
            }
            Self::Error => "a value, where the spreadsheet has an error",
            Self::Thousands => "a number that is shown as it is: its format shows it in thousands",
            Self::Date => "a number or a text: it is shown as a date",
            Self::Merged => "in a cell of its own: it is merged with others",
        }
    }
}

impl<'a> Sheet<'a> {
    pub(super) fn path(&self) -> &Path {
        match &self.origin {
            Origin::Text(source) => source.path,
            Origin::Workbook { path, .. } => path,
        }
    }

    /// The cells of a row.
    pub(super) fn row(&self, row: &SheetRow) -> Vec<Cell<'a>> {
        match &self.body {
            Body::Text { text, separator } => csv::cells(text, *separator, row),
            Body::Workbook(cells) => cells.row(row),
        }
    }

    /// Where a cell is.
    pub(super) fn spot(&self, cell: &Cell<'_>) -> Spot {
        match &self.origin {
            Origin::Text(source) => Spot::Text(source.place(cell.span.clone())),
            Origin::Workbook { sheet, .. } => Spot::Cell(cell_name(sheet, cell.column, cell.row)),
        }
    }

    /// An error at a cell.
    pub(super) fn error(&self, cell: &Cell<'_>, kind: FormatErrorKind) -> FormatError {
        FormatError::at(self.path(), Some(self.spot(cell)), kind)
    }

    /// An error about a value that breaks a rule.
    pub(super) fn invalid(&self, cell: &Cell<'_>, heading: &str, rule: impl Into<String>) -> FormatError {
        let value = cut(&cell.text).chars().map(visible).collect();
        let key = cut(heading).chars().map(visible).collect();
        self.error(cell, FormatErrorKind::Value { key, value, rule: rule.into() })
    }

    /// Whether a line of a text begins with #, and not in quotes.
    pub(super) fn is_remark(&self, first: &Cell<'_>) -> bool {
        match &self.origin {
            Origin::Text(source) => {
                first.column == 0 && source.text.as_bytes().get(first.span.start) == Some(&b'#')
            }
            Origin::Workbook { .. } => false,
        }
    }

    /// An error at a row as a whole, or about the whole table.
    pub(super) fn row_error(&self, row: Option<usize>, kind: FormatErrorKind) -> FormatError {
        let first = row.and_then(|row| self.rows.get(row)).and_then(|row| self.row(row).into_iter().next());
        match first {
            Some(cell) => self.error(&cell, kind),
            None => FormatError::new(self.path(), None, kind),
        }
    }

    /// An error of a text that was made of cells: at the cell of which that part of the text is, or else at this one.
    pub(super) fn moved(
        &self,
        error: FormatError,
        cells: &[(Range<usize>, &Cell<'_>)],
        otherwise: &Cell<'_>,
    ) -> FormatError {
        let of = |place: &Place| cells.iter().find(|(range, _)| range.contains(&place.span.start));
        error.moved(self.path(), |place| Some(self.spot(of(place).map_or(otherwise, |(_, cell)| cell))))
    }
}

/// `parts!F12`, or `'my parts'!F12`
pub(super) fn cell_name(sheet: &str, column: usize, row: usize) -> String {
    let is_plain = sheet.chars().all(|c| c.is_alphanumeric() || c == '_');
    let sheet = if is_plain { sheet.to_owned() } else { format!("'{}'", sheet.replace('\'', "''")) };
    format!("{sheet}!{}{row}", column_name(column))
}

/// Of the column 0: A; of 27: AB.
pub(super) fn column_name(column: usize) -> String {
    let mut letters = Vec::new();
    let mut rest = column + 1;
    while rest > 0 {
        letters.push(char::from(b'A' + ((rest - 1) % 26) as u8));
        rest = (rest - 1) / 26;
    }
    letters.iter().rev().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_have_the_names_that_spreadsheets_give_them() {
        for (column, name) in
            [(0, "A"), (25, "Z"), (26, "AA"), (27, "AB"), (701, "ZZ"), (702, "AAA"), (16383, "XFD")]
        {
            assert_eq!(column_name(column), name);
        }
        assert_eq!(cell_name("parts", 5, 12), "parts!F12");
        assert_eq!(cell_name("Bob's parts", 5, 12), "'Bob''s parts'!F12");
    }
}
