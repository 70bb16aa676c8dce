//! Tables of numbers in text: a header, then rows with fields separated by commas. Blank lines and
//! text after `#` are ignored.

mod lines;

use std::ops::Range;
use std::path::Path;

use crate::toml::reader::Value;
use crate::{ContentError, ContentErrorKind, ContentPlace};
use crate::{FormatError, FormatErrorKind};
use crate::{file, unit};

pub use lines::{Lines, Separator, line_at, trimmed};

/// Largest accepted table, bytes.
const LARGEST_FILE: u64 = 256 << 20;

/// Reads the file named by a value; the path is relative to the scenario.
pub fn bytes(table: &Value<'_>, path: &Path) -> Result<Vec<u8>, FormatError> {
    file::bytes(table.files(), path, table.string()?, LARGEST_FILE).map_err(|kind| {
        let missing = matches!(kind, FormatErrorKind::Io { .. });
        let error = table.error(kind);
        let hint = format!("paths are relative to the scenario: this one is {path:?}");
        if missing { error.with_hint(hint) } else { error }
    })
}

/// Returns the bytes as text; the text must be UTF-8.
pub fn text(bytes: &[u8]) -> Result<&str, ContentError> {
    str::from_utf8(bytes).map_err(|error| {
        let place = ContentPlace::Text(error.valid_up_to()..error.valid_up_to() + 1);
        let kind = ContentErrorKind::Unsupported { what: "text that is not UTF-8".to_owned() };
        ContentError::new(kind, place).hint("save the table as UTF-8")
    })
}

/// Reads the numbers in the given columns of a row. The row must have `width` fields, like the
/// header.
pub fn numbers<const N: usize>(
    text: &str,
    line: &Range<usize>,
    fields: &[Range<usize>],
    width: usize,
    places: &[usize],
) -> Result<[f64; N], ContentError> {
    if fields.len() != width {
        let rule = format!("{width} fields long, like the header; it has {}", fields.len());
        return Err(value("the line", &text[line.clone()], &rule, line.clone()));
    }
    let mut row = [0.0; N];
    for (slot, place) in row.iter_mut().zip(places) {
        *slot = number(text, fields.get(*place).cloned().unwrap_or_default())?;
    }
    Ok(row)
}

/// Checks that the time of a row is later than the time of the row before.
pub fn ascending(times: &[f64], time: f64, line: Range<usize>) -> Result<(), ContentError> {
    match times.last().is_some_and(|last| time <= *last) {
        true => Err(value("time_s", &time.to_string(), "after the time of the previous row", line)),
        false => Ok(()),
    }
}

/// Creates an error for a value that breaks a rule.
pub fn value(what: &str, value: &str, rule: &str, place: Range<usize>) -> ContentError {
    let (what, value, rule) = (what.to_owned(), value.to_owned(), rule.to_owned());
    ContentError::new(ContentErrorKind::Value { what, value, rule }, ContentPlace::Text(place))
}

/// Returns the lines that are not blank, each with its fields, as ranges of bytes.
pub fn fields(text: &str) -> impl Iterator<Item = (Range<usize>, Vec<Range<usize>>)> {
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let mut lines = Lines::new(text.as_bytes(), start, Separator::Byte(b',')).without_quotes();
    // `trim` removes all Unicode white space, not only ASCII.
    let plain = move |span: Range<usize>| {
        let written = &text[span.clone()];
        let start = span.start + (written.len() - written.trim_start().len());
        start..start + written.trim().len()
    };
    std::iter::from_fn(move || {
        loop {
            let (start, mut all) = (lines.at, Vec::new());
            let visit = |field| {
                all.push(plain(field));
                Ok(())
            };
            let line = lines.each_field(visit).ok().flatten()?;
            if !text[line.clone()].trim().is_empty() {
                return Some((start..line.end, all));
            }
        }
    })
}

fn number(text: &str, field: Range<usize>) -> Result<f64, ContentError> {
    let written = &text[field.clone()];
    let fail = |kind| Err(ContentError::new(kind, ContentPlace::Text(field.clone())));
    match written.parse::<f64>().ok().or_else(|| unit::bare(written)) {
        Some(number) if number.is_finite() => Ok(number),
        Some(_) => {
            let (what, found) = ("the number".to_owned(), written.to_owned());
            fail(ContentErrorKind::NotFinite { what, found })
        }
        None => {
            let found = if written.is_empty() { "nothing".to_owned() } else { written.to_owned() };
            fail(ContentErrorKind::Expected { what: "a number".to_owned(), found })
        }
    }
}

/// Creates an error for a missing part of a table, such as a column; the error has no line.
pub fn missing(what: &str) -> ContentError {
    ContentError::new(ContentErrorKind::Missing { what: what.to_owned() }, ContentPlace::Whole)
}
