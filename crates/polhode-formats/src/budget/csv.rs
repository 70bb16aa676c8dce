//! Parts lists in text: fields between commas, semicolons or tabs, in quotes if they hold any.

use std::borrow::Cow;
use std::ops::Range;

use super::sheet::{Body, Cell, Content, Origin, Sheet, SheetRow};
use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::error::FormatError;
use crate::scenario::source::Source;

/// More cells than any parts list has.
const MOST_CELLS: usize = 16_000_000;

/// The table in a text from this byte on, and what parts its fields: by whichever a heading is one.
pub(super) fn sheet(
    source: Source<'_>,
    from: usize,
    is_heading: fn(&str) -> bool,
) -> Result<(Sheet<'_>, u8), FormatError> {
    let located = |error| FormatError::of_content(source.path, source.text.as_bytes(), error);
    let unsupported = |what: String| {
        located(ContentError::new(ContentErrorKind::Unsupported { what }, ContentPlace::Whole))
    };
    if source.text.len() > u32::MAX as usize {
        return Err(unsupported(format!("a text of more than {} bytes", u32::MAX)));
    }
    let separator = separator(source.text, from, is_heading);
    let (mut rows, mut count) = (Vec::new(), 0);
    let mut fields = Fields { text: source.text, at: from };
    let mut number = 1 + newlines(source.text.get(..from).unwrap_or_default());
    while fields.at < source.text.len() {
        let (start, before) = (fields.at, count);
        loop {
            let (Field { text, .. }, is_last) = fields.next(separator).map_err(located)?;
            count += usize::from(!text.is_empty());
            if is_last {
                break;
            }
        }
        if count > MOST_CELLS {
            return Err(unsupported(format!("more than {MOST_CELLS} cells")));
        }
        if count > before {
            // Neither is more than the bytes of the text.
            let (number, start, end) = (number as u32, start as u32, fields.at as u32);
            rows.push(SheetRow { number, start, end, is_hidden: false });
        }
        number += newlines(source.text.get(start..fields.at).unwrap_or_default());
    }
    let body = Body::Text { text: source.text, separator };
    let sheet = Sheet { origin: Origin::Text(source), rows: rows.into(), body, decimal_comma: false };
    Ok((sheet, separator))
}

/// The cells of a row, of which [`sheet`] has read all fields.
pub(super) fn cells<'a>(text: &'a str, separator: u8, row: &SheetRow) -> Vec<Cell<'a>> {
    let mut fields = Fields { text, at: row.start as usize };
    let mut cells = Vec::new();
    let mut column = 0;
    while let Ok((Field { span, text }, is_last)) = fields.next(separator) {
        if !text.is_empty() {
            cells.push(Cell { column, row: row.number as usize, span, text, content: Content::Text });
        }
        column += 1;
        if is_last {
            break;
        }
    }
    cells
}

fn newlines(text: &str) -> usize {
    text.bytes().filter(|b| *b == b'\n').count()
}

/// What parts the fields: that by which a heading is one.
fn separator(text: &str, from: usize, is_heading: fn(&str) -> bool) -> u8 {
    /// The headings are not far below.
    const LINES: usize = 100;
    let mut at = from;
    for line in text.get(from..).unwrap_or_default().split_inclusive('\n').take(LINES) {
        let end = at + line.len();
        for separator in *b",;\t" {
            let mut fields = Fields { text: text.get(..end).unwrap_or_default(), at };
            while fields.at < end {
                match fields.next(separator) {
                    Ok((field, _)) if is_heading(&field.text) => return separator,
                    Ok(_) => {}
                    Err(_) => break,
                }
            }
        }
        at = end;
    }
    b','
}

struct Fields<'a> {
    text: &'a str,
    at: usize,
}

struct Field<'a> {
    span: Range<usize>,
    text: Cow<'a, str>,
}

impl<'a> Fields<'a> {
    /// The next field, and whether it is the last of its line.
    fn next(&mut self, separator: u8) -> Result<(Field<'a>, bool), ContentError> {
        let bytes = self.text.as_bytes();
        while matches!(bytes.get(self.at), Some(b' ' | b'\t')) {
            self.at += 1;
        }
        if bytes.get(self.at) == Some(&b'"') {
            return self.quoted(separator);
        }
        let start = self.at;
        let rest = &bytes[start..];
        let length = rest.iter().position(|b| *b == separator || *b == b'\n').unwrap_or(rest.len());
        let text = self.text.get(start..start + length).unwrap_or_default().trim_end();
        let is_last = rest.get(length) != Some(&separator);
        self.at = start + length + 1;
        Ok((Field { span: start..start + text.len(), text: Cow::Borrowed(text) }, is_last))
    }

    fn quoted(&mut self, separator: u8) -> Result<(Field<'a>, bool), ContentError> {
        let start = self.at;
        let bytes = self.text.as_bytes();
        let (mut at, mut doubled) = (start + 1, false);
        loop {
            match (bytes.get(at), bytes.get(at + 1)) {
                (Some(b'"'), Some(b'"')) => {
                    doubled = true;
                    at += 2;
                }
                (Some(b'"'), _) => break,
                (Some(_), _) => at += 1,
                (None, _) => {
                    let (what, found) = ("a quote that ends the cell".to_owned(), String::new());
                    let place = ContentPlace::Text(start..start + 1);
                    return Err(ContentError::new(ContentErrorKind::Expected { what, found }, place));
                }
            }
        }
        let inside = self.text.get(start + 1..at).unwrap_or_default().trim();
        let text = if doubled { Cow::Owned(inside.replace("\"\"", "\"")) } else { Cow::Borrowed(inside) };
        let span = start..at + 1;
        at += 1;
        while matches!(bytes.get(at), Some(b' ' | b'\t' | b'\r')) {
            at += 1;
        }
        let is_last = match bytes.get(at) {
            Some(b) if *b == separator => false,
            Some(b'\n') | None => true,
            Some(_) => {
                let found = self.text[at..].chars().next().map_or_else(String::new, String::from);
                let what = "a comma or the end of the line after the quote".to_owned();
                let place = ContentPlace::Text(at..at + 1);
                let error = ContentError::new(ContentErrorKind::Expected { what, found }, place);
                return Err(error.hint("a quote inside a cell that is in quotes is written twice"));
            }
        };
        self.at = at + 1;
        Ok((Field { span, text }, is_last))
    }
}
