//! Lines and their fields: one pass over the bytes.

use std::ops::Range;

use polhode_source::unit;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// What stands between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Separator {
    Byte(u8),
    Spaces,
}

impl Separator {
    /// The separator of the first line; quoted names and comments may contain any.
    pub(crate) fn of(line: &[u8]) -> Self {
        let mut quoted = false;
        let mut open = Vec::new();
        for byte in line {
            quoted ^= *byte == b'"';
            match byte {
                b'#' if !quoted => break,
                _ if !quoted => open.push(*byte),
                _ => {}
            }
        }
        let stands = |separator: &u8| open.contains(separator);
        [b';', b'\t', b','].into_iter().find(stands).map_or(Self::Spaces, Self::Byte)
    }

    /// Whether a comma can be the decimal mark.
    pub(crate) const fn leaves_the_comma(self) -> bool {
        matches!(self, Self::Byte(b';' | b'\t'))
    }

    fn separates(self, byte: u8) -> bool {
        match self {
            Self::Byte(separator) => byte == separator,
            Self::Spaces => byte == b' ' || byte == b'\t',
        }
    }
}

/// The lines of a file from some byte on.
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    separator: Separator,
    /// Where the next line starts.
    pub at: usize,
    /// Bytes that are more than a part of a field.
    marks: [bool; 256],
}

impl<'a> Lines<'a> {
    pub(crate) fn new(bytes: &'a [u8], at: usize, separator: Separator) -> Self {
        let mark = |byte: usize| {
            u8::try_from(byte).is_ok_and(|b| matches!(b, b'\n' | b'"' | b'#') || separator.separates(b))
        };
        Self { bytes, separator, at, marks: std::array::from_fn(mark) }
    }

    /// Calls `visit` with each field of the next line, trimmed, and goes on to the line after it. What is quoted is
    /// one field; a line that is blank but for a comment has none. The answer is the line; `None` at the end.
    pub(crate) fn each_field(
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
                    if self.separator != Separator::Spaces || !field.is_empty() {
                        visit(field)?;
                    }
                    start = at + 1;
                }
            }
            at += 1;
        };
        let line = trimmed(bytes, first..end);
        if quoted {
            let found = text_of(bytes, &line);
            let kind = ContentErrorKind::Expected { what: "a closing quote".to_owned(), found };
            return Err(ContentError::new(kind, ContentPlace::Text(line)));
        }
        let last = trimmed(bytes, start..end);
        let nothing = self.separator == Separator::Spaces || start == first;
        if !(nothing && last.is_empty()) {
            visit(last)?;
        }
        let rest = bytes.get(end..).unwrap_or_default();
        self.at = end + rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len()) + 1;
        Ok(Some(line))
    }
}

/// All fields of the line that starts at byte `at`.
pub(crate) fn fields(
    bytes: &[u8],
    at: usize,
    separator: Separator,
) -> Result<Vec<Range<usize>>, ContentError> {
    let mut all: Vec<Range<usize>> = Vec::new();
    Lines::new(bytes, at, separator).each_field(|field| {
        // Between spaces, a unit in brackets belongs to the name before it.
        match all.last_mut() {
            Some(last)
                if separator == Separator::Spaces
                    && (bytes[field.clone()].starts_with(b"[") || is_open(&bytes[last.clone()])) =>
            {
                last.end = field.end;
            }
            _ => all.push(field),
        }
        Ok(())
    })?;
    Ok(all)
}

/// Whether a bracket has not been closed yet.
fn is_open(field: &[u8]) -> bool {
    field.contains(&b'[') && !field.contains(&b']')
}

/// The line at byte `at`, trimmed, and where the next one starts; `None` at the end.
pub(crate) fn line_at(bytes: &[u8], at: usize) -> Option<(Range<usize>, usize)> {
    let rest = bytes.get(at..).filter(|rest| !rest.is_empty())?;
    let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
    Some((trimmed(bytes, at..at + length), at + length + 1))
}

fn trimmed(bytes: &[u8], span: Range<usize>) -> Range<usize> {
    let text = &bytes[span.clone()];
    let start = span.start + (text.len() - text.trim_ascii_start().len());
    start..start + text.trim_ascii().len()
}

/// A number, and its decimal mark where that may be either.
pub(crate) fn number(field: &[u8], separator: Separator) -> Option<(f64, Option<u8>)> {
    let text = std::str::from_utf8(field).ok()?;
    // What is printed in groups of digits is read where nothing but a separator parts two numbers.
    let parsed = |text: &str| text.parse().ok().or_else(|| unit::bare(text));
    if !separator.leaves_the_comma() {
        return parsed(text).map(|value| (value, None));
    }
    if field.contains(&b',') {
        // 1.234,5 keeps its point and is not a number.
        return parsed(&text.replacen(',', ".", 1)).map(|value| (value, Some(b',')));
    }
    let point = field.contains(&b'.').then_some(b'.');
    parsed(text).map(|value| (value, point))
}

pub(crate) fn text_of(bytes: &[u8], span: &Range<usize>) -> String {
    String::from_utf8_lossy(&bytes[span.clone()]).into_owned()
}
