//! The cells of one sheet of a workbook.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use quick_xml::events::BytesStart;

use super::format::Format;
use super::plain;
use super::strings::is;
use super::value::{Kind, RawText, Written, truth, value};
use crate::budget::sheet::{Cell, Content, SheetRow};
use crate::content::{ContentError, ContentErrorKind};
use crate::package::xml::{Token, Xml};

/// What a sheet may have at most, by the standard that its programs follow.
const MOST_ROWS: usize = 1 << 20;
const MOST_COLUMNS: usize = 1 << 14;

/// More cells than any parts list has.
const MOST_CELLS: usize = 16_000_000;

const MERGED: &str = "in a cell of its own: it is merged with others";

/// A sheet, as its entry has it.
#[derive(Debug, Default)]
pub(super) struct RawSheet {
    /// In the order of rows, and in them of columns.
    cells: Vec<RawCell>,
    /// The texts of cells that are no strings of the workbook, one behind the other.
    texts: String,
    hidden_rows: Vec<usize>,
    hidden_columns: Vec<RangeInclusive<usize>>,
}

#[derive(Debug)]
struct RawCell {
    /// From 1.
    row: usize,
    /// From 0.
    column: usize,
    text: RawText,
    content: Content,
}

/// Where the next cell is, and where the last was.
#[derive(Default)]
struct Position {
    row: usize,
    column: usize,
}

impl RawSheet {
    /// Reads the entry of a sheet.
    pub(super) fn read(
        mut xml: Xml<'_, '_>,
        formats: &[Format],
        strings: usize,
    ) -> Result<Self, ContentError> {
        let mut sheet = Self::default();
        let mut at = Position::default();
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(element) if is(&element, "c") => {
                    let Head { column, format, kind } = head(&xml, &element, &at, formats)?;
                    drop(element);
                    let value = value(&mut xml, &mut buffer, kind, format, strings, &mut sheet.texts)?;
                    if let Some((text, content)) = value {
                        sheet.cells.push(RawCell { row: at.row, column, text, content });
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
                    at = Position { row: number, column: 0 };
                    sheet.hidden_rows.extend(is_hidden.then_some(number));
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
                    for attribute in xml.attributes(&element) {
                        let attribute = attribute?;
                        if attribute.key.0 == "ref" {
                            sheet.merge(&xml.value(&attribute)?);
                        }
                    }
                }
                Token::Eof => return Ok(sheet),
                Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
            }
        }
    }

    /// Reads the plain cells that come next.
    fn pass(&mut self, xml: &mut Xml<'_, '_>, at: &mut Position, formats: &[Format], strings: usize) {
        let bytes = xml.ahead();
        let mut rest = bytes;
        while let Some((cell, behind)) = plain::cell(rest).filter(|_| self.cells.len() < MOST_CELLS) {
            let place = parsed(cell.name)
                .filter(|(row, column)| *row == at.row && (at.column..MOST_COLUMNS).contains(column));
            let Some((row, column)) = place else { break };
            let start = self.texts.len();
            self.texts.push_str(cell.text);
            let written = Written {
                kind: Kind::named(cell.kind),
                format: cell.style.map_or(Format::GENERAL, |style| format_of(style, formats)),
                formula: cell.formula,
                is_text: cell.is_text,
                start,
            };
            let Ok(value) = written.content(strings, &mut self.texts) else {
                self.texts.truncate(start);
                break;
            };
            self.cells.extend(value.map(|(text, content)| RawCell { row, column, text, content }));
            at.column = column + 1;
            rest = behind;
        }
        let count = bytes.len() - rest.len();
        xml.pass(count);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Marks the cell that is shown over several, if anything stands in it.
    fn merge(&mut self, range: &str) {
        let Some((first, last)) = range.split_once(':') else { return };
        let Some(first) = parsed(first).filter(|_| first != last) else { return };
        let found = self.cells.binary_search_by_key(&first, |cell| (cell.row, cell.column));
        if let Some(cell) = found.ok().and_then(|k| self.cells.get_mut(k)) {
            cell.content = Content::Broken(MERGED);
        }
    }

    /// Rows and cells as tables have them.
    pub(super) fn rows<'a>(&'a self, strings: &'a [String]) -> (Vec<SheetRow>, Vec<Cell<'a>>) {
        let mut rows: Vec<SheetRow> = Vec::new();
        let mut cells = Vec::with_capacity(self.cells.len());
        for RawCell { row, column, text, content } in &self.cells {
            let text = match text {
                RawText::Own(range) => self.texts.get(range.clone()).unwrap_or_default(),
                RawText::Shared(number) => strings.get(*number).map_or("", String::as_str),
            };
            let text = text.trim();
            if text.is_empty() {
                continue;
            }
            let at = cells.len();
            match rows.last_mut() {
                Some(last) if last.number == *row => last.cells.end = at + 1,
                _ => {
                    let is_hidden = self.hidden_rows.binary_search(row).is_ok();
                    rows.push(SheetRow { number: *row, cells: at..at + 1, is_hidden });
                }
            }
            let (row, column, content) = (*row, *column, *content);
            cells.push(Cell { row, column, span: 0..0, text: Cow::Borrowed(text), content });
        }
        (rows, cells)
    }

    /// Which columns are hidden, as a sentence.
    pub(super) fn hidden_columns(&self) -> Option<String> {
        let used: BTreeSet<usize> = self.cells.iter().map(|cell| cell.column + 1).collect();
        let has_cells = |range: &&RangeInclusive<usize>| used.iter().any(|column| range.contains(column));
        let names: Vec<String> = self
            .hidden_columns
            .iter()
            .filter(has_cells)
            .map(|range| {
                let name = |number: usize| crate::budget::sheet::column_name(number.saturating_sub(1));
                format!("{} to {}", name(*range.start()), name(*range.end()))
            })
            .collect();
        (!names.is_empty()).then(|| format!("read although hidden: columns {}", names.join(", ")))
    }
}

/// The number of a row, and whether it is hidden.
fn row(xml: &Xml<'_, '_>, element: &BytesStart<'_>, at: &Position) -> Result<(usize, bool), ContentError> {
    let (mut number, mut is_hidden) = (at.row + 1, false);
    for attribute in xml.attributes(element) {
        let attribute = attribute?;
        let value = xml.value(&attribute)?;
        match attribute.key.0 {
            "r" => number = value.parse().map_err(|_| xml.refused("row", &value, "a number"))?,
            "hidden" => is_hidden = truth(&value),
            _ => {}
        }
    }
    if number > at.row && number <= MOST_ROWS {
        return Ok((number, is_hidden));
    }
    let rule = format!("below the row before, and {MOST_ROWS} at most");
    Err(xml.refused("row", &number.to_string(), &rule))
}

/// Columns that are hidden.
fn hidden(
    xml: &Xml<'_, '_>,
    element: &BytesStart<'_>,
) -> Result<Option<RangeInclusive<usize>>, ContentError> {
    let (mut from, mut to, mut is_hidden) = (0, 0, false);
    for attribute in xml.attributes(element) {
        let attribute = attribute?;
        let value = xml.value(&attribute)?;
        match attribute.key.0 {
            "min" => from = value.parse().unwrap_or(0),
            "max" => to = value.parse().unwrap_or(0),
            "hidden" => is_hidden = truth(&value),
            _ => {}
        }
    }
    Ok(is_hidden.then_some(from..=to))
}

/// What a cell says besides its value.
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
    let mut head = Head { column: at.column, format: Format::GENERAL, kind: Kind::Number };
    for attribute in xml.attributes(element) {
        let attribute = attribute?;
        let value = xml.value(&attribute)?;
        match attribute.key.0 {
            "r" => match parsed(&value) {
                Some((row, column)) if row == at.row && column >= at.column => head.column = column,
                _ => return Err(xml.refused("cell", &value, "in its row, behind the cell before")),
            },
            "s" => head.format = format_of(&value, formats),
            "t" => head.kind = Kind::named(&value),
            _ => {}
        }
    }
    if head.column < MOST_COLUMNS {
        return Ok(head);
    }
    Err(xml.refused("column", &head.column.to_string(), &format!("one of {MOST_COLUMNS}")))
}

/// The format of a number among those of the workbook.
fn format_of(number: &str, formats: &[Format]) -> Format {
    number.parse::<usize>().ok().and_then(|number| formats.get(number)).cloned().unwrap_or(Format::GENERAL)
}

/// Row, from 1, and column, from 0, of `F12`.
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
