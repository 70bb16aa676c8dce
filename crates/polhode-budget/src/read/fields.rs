//! Fields of a text: separated by commas, semicolons or tabs. A field that contains one is in
//! quotes.

use std::borrow::Cow;
use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::cell::{Cell, Content, SheetRow};

/// Reader of the fields of a text, from a byte on.
pub(crate) struct Fields<'a> {
    pub text: &'a str,
    pub at: usize,
}

pub(crate) struct Field<'a> {
    pub span: Range<usize>,
    pub text: Cow<'a, str>,
}

impl<'a> Fields<'a> {
    /// Returns the next field, and true if it is the last of its line.
    pub(crate) fn next(&mut self, separator: u8) -> Result<(Field<'a>, bool), ContentError> {
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
                    let (what, found) = ("a closing quote".to_owned(), String::new());
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
                return Err(error.hint("inside a quoted cell, write a quote twice"));
            }
        };
        self.at = at + 1;
        Ok((Field { span, text }, is_last))
    }
}

/// Returns the cells of a row. All its fields were read without error before.
pub(crate) fn cells<'a>(text: &'a str, separator: u8, row: &SheetRow) -> Vec<Cell<'a>> {
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
