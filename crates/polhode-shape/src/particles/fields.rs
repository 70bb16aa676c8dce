//! Fields of a line, as text and as numbers.

use std::ops::Range;

use polhode_source::ContentError;
use polhode_source::csv::{Lines, Separator};
use polhode_source::unit;

/// Returns all fields of the line that starts at byte `at`.
pub(crate) fn fields(
    bytes: &[u8],
    at: usize,
    separator: Separator,
) -> Result<Vec<Range<usize>>, ContentError> {
    let mut all: Vec<Range<usize>> = Vec::new();
    Lines::new(bytes, at, separator).each_field(|field| {
        // If spaces separate fields, a unit in brackets belongs to the preceding name.
        match all.last_mut() {
            Some(last)
                if separator == Separator::Blanks
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

/// Returns true if a bracket is not closed yet.
fn is_open(field: &[u8]) -> bool {
    field.contains(&b'[') && !field.contains(&b']')
}

/// Parses a number; also returns its decimal mark if that may be a point or a comma.
pub(crate) fn number(field: &[u8], separator: Separator) -> Option<(f64, Option<u8>)> {
    let text = std::str::from_utf8(field).ok()?;
    // Numbers with digit groups are accepted if the separator cannot occur in them.
    let parsed = |text: &str| text.parse().ok().or_else(|| unit::bare(text));
    if !matches!(separator, Separator::Byte(b';' | b'\t')) {
        return parsed(text).map(|value| (value, None));
    }
    if field.contains(&b',') {
        // 1.234,5 keeps its point and is therefore not a number.
        return parsed(&text.replacen(',', ".", 1)).map(|value| (value, Some(b',')));
    }
    let point = field.contains(&b'.').then_some(b'.');
    parsed(text).map(|value| (value, point))
}

pub(crate) fn text_of(bytes: &[u8], span: &Range<usize>) -> String {
    String::from_utf8_lossy(&bytes[span.clone()]).into_owned()
}
