//! Lines of a text file, and their fields with positions.

use std::borrow::Cow;
use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind};

/// Remaining lines of a file. They end in `\n`, `\r\n` or `\r`.
#[derive(Clone, Debug)]
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Lines<'a> {
    /// Returns all lines, after a byte order mark.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 } }
    }

    /// Returns an error at the end of the file.
    pub(crate) fn ended(&self, what: impl Into<String>) -> ContentError {
        let kind = ContentErrorKind::expected(what.into(), "");
        let end = self.bytes.len();
        kind.at(end..end).hint("the file is truncated")
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Field<'a>;

    fn next(&mut self) -> Option<Field<'a>> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|b| b"\r\n".contains(b)).unwrap_or(rest.len());
        let line = Field { start: self.at, bytes: &rest[..length] };
        let ending = match &rest[length..] {
            [b'\r', b'\n', ..] => 2,
            [] => 0,
            _ => 1,
        };
        self.at += length + ending;
        Some(line)
    }
}

/// Part of a file: a line, or a field of one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Field<'a> {
    /// Offset in the file, bytes.
    pub start: usize,
    pub bytes: &'a [u8],
}

impl<'a> Field<'a> {
    pub(crate) fn span(&self) -> Range<usize> {
        self.start..self.start + self.bytes.len()
    }

    pub(crate) fn text(&self) -> Cow<'a, str> {
        String::from_utf8_lossy(self.bytes)
    }

    pub(crate) fn is_blank(&self) -> bool {
        self.bytes.trim_ascii().is_empty()
    }

    /// Returns the field without surrounding white space.
    pub(crate) fn trimmed(&self) -> Self {
        let left = self.bytes.len() - self.bytes.trim_ascii_start().len();
        Self { start: self.start + left, bytes: self.bytes.trim_ascii() }
    }

    /// Returns these columns, counted from 0, as far as the line extends, without surrounding
    /// blanks.
    pub(crate) fn columns(&self, columns: Range<usize>) -> Self {
        let end = columns.end.min(self.bytes.len());
        let start = columns.start.min(end);
        Self { start: self.start + start, bytes: &self.bytes[start..end] }.trimmed()
    }

    /// Returns the words of the field.
    pub(crate) fn words(self) -> impl Iterator<Item = Field<'a>> + Clone {
        let mut at = 0;
        std::iter::from_fn(move || {
            let rest = self.bytes.get(at..)?;
            at += rest.len() - rest.trim_ascii_start().len();
            let rest = rest.trim_ascii_start();
            let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
            let word = Field { start: self.start + at, bytes: &rest[..length] };
            at += length;
            (length > 0).then_some(word)
        })
    }

    /// Parses an integer.
    pub(crate) fn integer<T: std::str::FromStr>(&self, what: &str) -> Result<T, ContentError> {
        let text = self.text();
        text.trim().parse().map_err(|_| self.expected(what))
    }

    /// Parses a finite number, including Fortran notation: `1.5D-3`.
    pub(crate) fn number(&self, what: &str) -> Result<f64, ContentError> {
        let text = self.text();
        let text = text.trim();
        let starts_like_one = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let value = text.parse().or_else(|error| {
            if starts_like_one { text.replace(['D', 'd'], "e").parse::<f64>() } else { Err(error) }
        });
        match value {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err(ContentErrorKind::not_finite(what, text).at(self.span())),
            Err(_) => Err(self.expected(what)),
        }
    }

    /// Returns the error for unexpected content.
    pub(crate) fn expected(&self, what: &str) -> ContentError {
        let found = self.text().into_owned();
        let hint = if found.contains(',') {
            Some("use a decimal point")
        } else if found.contains("**") {
            Some("the number did not fit into its columns")
        } else {
            None
        };
        let kind = ContentErrorKind::expected(what, if found.is_empty() { " ".to_owned() } else { found });
        let error = kind.at(self.span());
        match hint {
            Some(hint) => error.hint(hint),
            None => error,
        }
    }

    /// Returns the error for a value that violates a rule.
    pub(crate) fn wrong(&self, what: &str, rule: impl Into<String>) -> ContentError {
        let value = self.text().into_owned();
        ContentErrorKind::value(what, value, rule.into()).at(self.span())
    }
}

/// Returns the number of decimals as written, minus the exponent: 4 for `-0.1234`.
pub(crate) fn decimals(number: &[u8]) -> i32 {
    let (mantissa, exponent) = match number.iter().position(|b| b"eEdD".contains(b)) {
        Some(at) => (&number[..at], str::from_utf8(&number[at + 1..]).ok().and_then(|e| e.parse().ok())),
        None => (number, Some(0)),
    };
    let fraction = mantissa.iter().position(|b| *b == b'.').map_or(0, |at| mantissa.len() - at - 1);
    i32::try_from(fraction).unwrap_or(i32::MAX).saturating_sub(exponent.unwrap_or(0))
}
