//! Cells of one sheet of a workbook.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use polhode_source::package::xml::{Token, Xml};
use polhode_source::{ContentError, ContentErrorKind};
use quick_xml::events::BytesStart;

use super::format::Format;
use super::plain;
use super::strings::{Strings, is};
use super::value::{Kind, RawText, Written, truth, value};
use crate::read::cell::{Broken, Cell, Content, SheetRow};

/// Largest numbers of rows and of columns in a sheet, by the standard.
const MOST_ROWS: usize = 1 << 20;
const MOST_COLUMNS: usize = 1 << 14;

/// Largest number of cells. No parts list has more.
const MOST_CELLS: usize = 16_000_000;

/// Largest number of bytes of text in one sheet.
const MOST_TEXT: usize = 1 << 31;

/// Sheet as in its entry, without empty cells.
#[derive(Debug, Default)]
pub(crate) struct RawSheet {
    rows: Vec<SheetRow>,
    /// Cells in the order of rows, then of columns.
    cells: Vec<RawCell>,
    /// Concatenated texts of cells that are not shared strings.
    texts: String,
    hidden_columns: Vec<RangeInclusive<usize>>,
}

#[derive(Clone, Copy, Debug)]
struct RawCell {
    /// First byte of its text, or index of its shared string.
    start: u32,
    /// Number of bytes of its text, or [`SHARED`].
    length: u32,
    /// Column, counted from 0.
    column: u16,
    content: Content,
}

/// Length that marks a shared string.
const SHARED: u32 = u32::MAX;

/// Cells of a sheet, with the strings that they share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells<'a> {
    sheet: &'a RawSheet,
    strings: &'a Strings,
}

/// Position of the next cell.
#[derive(Default)]
struct Position {
    row: usize,
    column: usize,
    /// True if the row is hidden in spreadsheet programs.
    is_hidden: bool,
}

impl<'a> Cells<'a> {
    pub(crate) const fn of(sheet: &'a RawSheet, strings: &'a Strings) -> Self {
        Self { sheet, strings }
    }

    /// Returns the cells of a row.
    pub(crate) fn row(&self, row: &SheetRow) -> Vec<Cell<'a>> {
        let cells = self.sheet.cells.get(row.start as usize..row.end as usize).unwrap_or_default();
        let cell = |RawCell { start, length, column, content }: &RawCell| {
            let start = *start as usize;
            let text = match *length {
                SHARED => self.strings.get(start).unwrap_or_default().trim(),
                length => self.sheet.texts.get(start..start + length as usize).unwrap_or_default(),
            };
            let (row, column) = (row.number as usize, usize::from(*column));
            Cell { row, column, span: 0..0, text: Cow::Borrowed(text), content: *content }
        };
        cells.iter().map(cell).collect()
    }
}

impl RawSheet {
    /// Reads the entry of a sheet.
    pub(crate) fn read(
        mut xml: Xml<'_, '_>,
        formats: &[Format],
        strings: &Strings,
    ) -> Result<Self, ContentError> {
        let mut sheet = Self::default();
        let mut at = Position::default();
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(element) if is(&element, "c") => {
                    let Head { column, format, kind } = head(&xml, &element, &at, formats)?;
                    drop(element);
                    let value = value(&mut xml, &mut buffer, kind, format, strings.len(), &mut sheet.texts)?;
                    if let Some((text, content)) = value {
                        sheet.add(&at, column, text, content, strings);
                    }
                    if sheet.texts.len() > MOST_TEXT {
                        let what = format!("more than {MOST_TEXT} bytes of text in a sheet");
                        return Err(xml.error(ContentErrorKind::Unsupported { what }));
                    }
                    if sheet.cells.len() > MOST_CELLS {
                        let what = format!("more than {MOST_CELLS} cells");
                        return Err(xml.error(ContentErrorKind::Unsupported { what }));
                    }
                    at.column = column + 1;
                    sheet.pass(&mut xml, &mut at, formats, strings);
                }
                Token::Start(element) if is(&element, "row") => {
                    let (number, is_hidden) = row(&xml, &element, &at)?;
                    at = Position { row: number, column: 0, is_hidden };
                    sheet.pass(&mut xml, &mut at, formats, strings);
                }
                Token::Start(element) if is(&element, "col") => {
                    if sheet.hidden_columns.len() == MOST_COLUMNS {
                        let what = "more columns than a sheet has".to_owned();
                        return Err(xml.error(ContentErrorKind::Unsupported { what }));
                    }
                    sheet.hidden_columns.extend(hidden(&xml, &element)?);
                }
                Token::Start(element) if is(&element, "mergeCell") => {
                    if let [Some(range)] = xml.values(&element, ["ref"])? {
                        sheet.merge(&range);
                    }
                }
                Token::Eof => return Ok(sheet),
                Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
            }
        }
    }

    /// Reads the plain cells that come next.
    fn pass(&mut self, xml: &mut Xml<'_, '_>, at: &mut Position, formats: &[Format], strings: &Strings) {
        let bytes = xml.ahead();
        let mut rest = bytes;
        while let Some((cell, behind)) = plain::cell(rest).filter(|_| self.has_room()) {
            let place = parsed(cell.name)
                .filter(|(row, column)| *row == at.row && (at.column..MOST_COLUMNS).contains(column));
            let Some((_, column)) = place else { break };
            let start = self.texts.len();
            self.texts.push_str(cell.text);
            let written = Written {
                kind: Kind::named(cell.kind),
                format: cell.style.map_or(Format::GENERAL, |style| format_of(style, formats)),
                formula: cell.formula,
                is_text: cell.is_text,
                start,
            };
            let Ok(value) = written.content(strings.len(), &mut self.texts) else {
                self.texts.truncate(start);
                break;
            };
            if let Some((text, content)) = value {
                self.add(at, column, text, content, strings);
            }
            at.column = column + 1;
            rest = behind;
        }
        let count = bytes.len() - rest.len();
        xml.pass(count);
    }

    const fn has_room(&self) -> bool {
        self.cells.len() < MOST_CELLS && self.texts.len() < MOST_TEXT
    }

    /// Adds a cell unless it is empty.
    fn add(&mut self, at: &Position, column: usize, text: RawText, content: Content, strings: &Strings) {
        let (start, length) = match text {
            RawText::Own(range) => {
                let text = self.texts.get(range.clone()).unwrap_or_default();
                let before = text.len() - text.trim_start().len();
                (range.start + before, text.trim().len())
            }
            RawText::Shared(number) if strings.get(number).is_none_or(|text| text.trim().is_empty()) => {
                (0, 0)
            }
            RawText::Shared(number) => (number, SHARED as usize),
        };
        if length == 0 {
            return;
        }
        // Larger values were refused before.
        let cell = RawCell { start: start as u32, length: length as u32, column: column as u16, content };
        self.cells.push(cell);
        let (number, end) = (at.row as u32, self.cells.len() as u32);
        match self.rows.last_mut() {
            Some(last) if last.number == number => last.end = end,
            _ => self.rows.push(SheetRow { number, start: end - 1, end, is_hidden: at.is_hidden }),
        }
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Returns the rows that are not empty.
    pub(crate) fn rows(&self) -> &[SheetRow] {
        &self.rows
    }

    /// Marks the first cell of a merged range, if it is not empty.
    fn merge(&mut self, range: &str) {
        let Some((first, last)) = range.split_once(':') else { return };
        let Some((number, column)) = parsed(first).filter(|_| first != last) else { return };
        let row = self.rows.binary_search_by_key(&number, |row| row.number as usize);
        let Some(row) = row.ok().and_then(|k| self.rows.get(k)) else { return };
        let cells = self.cells.get_mut(row.start as usize..row.end as usize).unwrap_or_default();
        if let Some(cell) = cells.iter_mut().find(|cell| usize::from(cell.column) == column) {
            cell.content = Content::Broken(Broken::Merged);
        }
    }

    /// Returns a sentence about hidden columns with cells, if there are any.
    pub(crate) fn hidden_columns(&self) -> Option<String> {
        let used: BTreeSet<usize> = self.cells.iter().map(|cell| usize::from(cell.column) + 1).collect();
        let has_cells = |range: &&RangeInclusive<usize>| used.iter().any(|column| range.contains(column));
        let names: Vec<String> = self
            .hidden_columns
            .iter()
            .filter(has_cells)
            .map(|range| {
                let name = |number: usize| crate::read::cell::column_name(number.saturating_sub(1));
                format!("{} to {}", name(*range.start()), name(*range.end()))
            })
            .collect();
        (!names.is_empty()).then(|| format!("hidden columns that were read: {}", names.join(", ")))
    }
}

/// Returns the number of a row, and true if it is hidden.
fn row(xml: &Xml<'_, '_>, element: &BytesStart<'_>, at: &Position) -> Result<(usize, bool), ContentError> {
    let [number, hidden] = xml.values(element, ["r", "hidden"])?;
    let number = match number {
        Some(number) => number.parse().map_err(|_| xml.refused("row", &number, "a number"))?,
        None => at.row + 1,
    };
    if number > at.row && number <= MOST_ROWS {
        return Ok((number, hidden.is_some_and(|hidden| truth(&hidden))));
    }
    let rule = format!("below the row before, and {MOST_ROWS} at most");
    Err(xml.refused("row", &number.to_string(), &rule))
}

/// Returns the range of hidden columns.
fn hidden(
    xml: &Xml<'_, '_>,
    element: &BytesStart<'_>,
) -> Result<Option<RangeInclusive<usize>>, ContentError> {
    let [from, to, hidden] = xml.values(element, ["min", "max", "hidden"])?;
    let [from, to] = [from, to].map(|end| end.and_then(|end| end.parse().ok()).unwrap_or(0));
    Ok(hidden.filter(|hidden| truth(hidden)).map(|_| from..=to))
}

/// Attributes of a cell.
struct Head {
    column: usize,
    format: Format,
    kind: Kind,
}

fn head(
    xml: &Xml<'_, '_>,
    element: &BytesStart<'_>,
    at: &Position,
    formats: &[Format],
) -> Result<Head, ContentError> {
    let [name, style, kind] = xml.values(element, ["r", "s", "t"])?;
    let column = match name.as_deref().map(|name| (name, parsed(name))) {
        None => at.column,
        Some((_, Some((row, column)))) if row == at.row && column >= at.column => column,
        Some((name, _)) => return Err(xml.refused("cell", name, "in its row, behind the cell before")),
    };
    if column >= MOST_COLUMNS {
        return Err(xml.refused("column", &column.to_string(), &format!("one of {MOST_COLUMNS}")));
    }
    let format = style.map_or(Format::GENERAL, |style| format_of(&style, formats));
    Ok(Head { column, format, kind: kind.map_or(Kind::Number, |kind| Kind::named(&kind)) })
}

/// Returns the format with this index in the workbook.
fn format_of(number: &str, formats: &[Format]) -> Format {
    number.parse::<usize>().ok().and_then(|number| formats.get(number)).cloned().unwrap_or(Format::GENERAL)
}

/// Parses the name of a cell: row, from 1, and column, from 0, of `F12`.
fn parsed(name: &str) -> Option<(usize, usize)> {
    let letters = name.bytes().take_while(u8::is_ascii_uppercase).count();
    let (letters, digits) = name.split_at(letters);
    if letters.is_empty() || letters.len() > 3 || digits.len() > 7 || digits.starts_with('+') {
        return None;
    }
    let column = letters.bytes().fold(0, |n, letter| 26 * n + usize::from(letter - b'A') + 1);
    Some((digits.parse().ok()?, column - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_have_names() {
        assert_eq!(parsed("F12"), Some((12, 5)));
        assert_eq!(parsed("XFD1048576"), Some((1_048_576, 16_383)));
        for wrong in ["", "F", "12", "f12", "AAAA1", "A99999999", "A+1", "A1B"] {
            assert_eq!(parsed(wrong), None, "{wrong}");
        }
    }
}
