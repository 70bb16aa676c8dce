//! Lines of a table and their fields, found in one pass over the bytes.

use std::ops::Range;

use crate::{ContentError, ContentErrorKind, ContentPlace};

/// Separator between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// One byte.
    Byte(u8),
    /// Any number of spaces and tabs.
    Blanks,
}

impl Separator {
    /// Returns the first semicolon, tab or comma outside quotes and before a comment; else blanks.
    pub fn of(line: &[u8], comment: Option<u8>) -> Self {
        let (mut quoted, mut open) = (false, Vec::new());
        for byte in line {
            quoted ^= *byte == b'"';
            if !quoted {
                if Some(*byte) == comment {
                    break;
                }
                open.push(*byte);
            }
        }
        [b';', b'\t', b','].into_iter().find(|byte| open.contains(byte)).map_or(Self::Blanks, Self::Byte)
    }

    fn separates(self, byte: u8) -> bool {
        match self {
            Self::Byte(separator) => byte == separator,
            Self::Blanks => byte == b' ' || byte == b'\t',
        }
    }
}

/// Iterator over the lines of a text; text after `#` is a comment.
#[derive(Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    separator: Separator,
    /// Offset of the next line, bytes.
    pub(super) at: usize,
    /// Table of the bytes that need handling: line ends, quotes, `#` and separators.
    marks: [bool; 256],
}

impl<'a> Lines<'a> {
    /// Creates a reader that treats quoted text as one field.
    pub fn new(bytes: &'a [u8], at: usize, separator: Separator) -> Self {
        let mark = |byte: usize| {
            u8::try_from(byte).is_ok_and(|b| matches!(b, b'\n' | b'"' | b'#') || separator.separates(b))
        };
        Self { bytes, separator, at, marks: std::array::from_fn(mark) }
    }

    /// Returns the reader with quotes treated as ordinary characters.
    #[must_use]
    pub fn without_quotes(mut self) -> Self {
        self.marks[usize::from(b'"')] = false;
        self
    }

    /// Calls `visit` with each field of the next line, trimmed, and advances to the line after it.
    /// Quoted text is one field. A line with only blanks or a comment has no fields. Returns the
    /// line, or `None` at the end.
    ///
    /// # Errors
    /// Any [`ContentError`] of `visit`, and an error for a quote that its line does not close.
    pub fn each_field(
        &mut self,
        mut visit: impl FnMut(Range<usize>) -> Result<(), ContentError>,
    ) -> Result<Option<Range<usize>>, ContentError> {
        let (bytes, first) = (self.bytes, self.at);
        if first >= bytes.len() {
            return Ok(None);
        }
        let (mut at, mut start, mut quoted) = (first, first, false);
        let end = loop {
            let rest = bytes.get(at..).unwrap_or_default();
            at += rest.iter().position(|b| self.marks[usize::from(*b)]).unwrap_or(rest.len());
            match bytes.get(at) {
                None | Some(b'\n') => break at,
                Some(b'"') => quoted = !quoted,
                Some(_) if quoted => {}
                Some(b'#') => break at,
                Some(_) => {
                    let field = trimmed(bytes, start..at);
                    if self.separator != Separator::Blanks || !field.is_empty() {
                        visit(field)?;
                    }
                    start = at + 1;
                }
            }
            at += 1;
        };
        let line = trimmed(bytes, first..end);
        if quoted {
            let found = String::from_utf8_lossy(&bytes[line.clone()]).into_owned();
            let kind = ContentErrorKind::Expected { what: "a closing quote".to_owned(), found };
            return Err(ContentError::new(kind, ContentPlace::Text(line)));
        }
        let last = trimmed(bytes, start..end);
        let nothing = self.separator == Separator::Blanks || start == first;
        if !(nothing && last.is_empty()) {
            visit(last)?;
        }
        let rest = bytes.get(end..).unwrap_or_default();
        self.at = end + rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len()) + 1;
        Ok(Some(line))
    }
}

/// Returns the trimmed line at byte `at` and the offset of the next line; `None` at the end.
pub fn line_at(bytes: &[u8], at: usize) -> Option<(Range<usize>, usize)> {
    let rest = bytes.get(at..).filter(|rest| !rest.is_empty())?;
    let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
    Some((trimmed(bytes, at..at + length), at + length + 1))
}

/// Returns a range of a text without the white space at its ends.
pub fn trimmed(bytes: &[u8], span: Range<usize>) -> Range<usize> {
    let text = &bytes[span.clone()];
    let start = span.start + (text.len() - text.trim_ascii_start().len());
    start..start + text.trim_ascii().len()
}
