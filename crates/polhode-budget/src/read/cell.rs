//! Cells of a table, and its rows.

use std::borrow::Cow;
use std::ops::Range;

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SheetRow {
    /// Number of the row in the file, from 1.
    pub number: u32,
    /// Range of its bytes in a text, or of its cells in a workbook.
    pub start: u32,
    pub end: u32,
    /// True if the row is hidden in the spreadsheet.
    pub is_hidden: bool,
}

/// Non-empty cell, without the spaces around its text.
#[derive(Clone, Debug)]
pub(crate) struct Cell<'a> {
    /// Column, counted from 0.
    pub column: usize,
    /// Number of its row in the file, from 1.
    pub row: usize,
    /// Range of its bytes, in a text file.
    pub span: Range<usize>,
    pub text: Cow<'a, str>,
    pub content: Content,
}

/// Kind of content of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    Text,
    /// Number in a workbook, with the decimals that its format shows.
    Number {
        decimals: Option<u8>,
    },
    /// Content that cannot be read.
    Broken(Broken),
}

/// Reason why a cell of a workbook cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Broken {
    NoResult,
    Error,
    Thousands,
    Date,
    Merged,
}

impl Broken {
    /// Returns the rule that the cell violates.
    pub(crate) const fn rule(self) -> &'static str {
        match self {
            Self::NoResult => {
                "a value: the formula has no stored result; open the workbook in a spreadsheet program and save it"
            }
            Self::Error => "a value, but the cell has an error",
            Self::Thousands => "a number whose format does not scale it by thousands",
            Self::Date => "a number or a text, not a date",
            Self::Merged => "in a separate cell: it is merged with others",
        }
    }
}

/// Returns the name of a cell, such as `parts!F12` or `'my parts'!F12`.
pub(crate) fn cell_name(sheet: &str, column: usize, row: usize) -> String {
    let is_plain = sheet.chars().all(|c| c.is_alphanumeric() || c == '_');
    let sheet = if is_plain { sheet.to_owned() } else { format!("'{}'", sheet.replace('\'', "''")) };
    format!("{sheet}!{}{row}", column_name(column))
}

/// Returns the name of a column in spreadsheets: A for 0, AB for 27.
pub(crate) fn column_name(column: usize) -> String {
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
