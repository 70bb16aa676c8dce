//! Lines of a table and their fields: one pass over the bytes.

use std::ops::Range;

use crate::{ContentError, ContentErrorKind, ContentPlace};

/// What stands between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// One byte.
    Byte(u8),
    /// Spaces and tabs, as many as there are.
    Blanks,
}

impl Separator {
    /// Returns the first of semicolon, tab and comma that stands in a line outside quotes and before a comment, else blanks.
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

/// The lines of a text from some byte on; what follows a `#` is for people.
#[derive(Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    separator: Separator,
    /// Where the next line starts.
    pub(super) at: usize,
    /// Bytes that are more than a part of a field.
    marks: [bool; 256],
}

impl<'a> Lines<'a> {
    /// Creates a reader in which what is between quotes is one field.
    pub fn new(bytes: &'a [u8], at: usize, separator: Separator) -> Self {
        let mark = |byte: usize| {
            u8::try_from(byte).is_ok_and(|b| matches!(b, b'\n' | b'"' | b'#') || separator.separates(b))
        };
        Self { bytes, separator, at, marks: std::array::from_fn(mark) }
    }

    /// Returns the reader in which quotes are parts of fields.
    #[must_use]
    pub fn without_quotes(mut self) -> Self {
        self.marks[usize::from(b'"')] = false;
        self
    }

    /// Calls `visit` with each field of the next line, trimmed, and goes on to the line after it. What is quoted is
    /// one field; a line that is blank but for a comment has none. The answer is the line; `None` at the end.
    ///
    /// # Errors
    /// [`ContentError`] of `visit`, and for a quote that is not closed in its line.
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

/// Returns the line at byte `at`, trimmed, and where the next one starts; `None` at the end.
pub fn line_at(bytes: &[u8], at: usize) -> Option<(Range<usize>, usize)> {
    let rest = bytes.get(at..).filter(|rest| !rest.is_empty())?;
    let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
    Some((trimmed(bytes, at..at + length), at + length + 1))
}

/// Returns a part of a text without the blanks around it.
pub fn trimmed(bytes: &[u8], span: Range<usize>) -> Range<usize> {
    let text = &bytes[span.clone()];
    let start = span.start + (text.len() - text.trim_ascii_start().len());
    start..start + text.trim_ascii().len()
}
