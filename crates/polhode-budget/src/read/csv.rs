//! Parts lists as text: fields are separated by commas, semicolons or tabs. A field that contains
//! one is in quotes.

use polhode_source::ContentError;
use polhode_source::FormatError;
use polhode_source::toml::source::Source;

use super::cell::SheetRow;
use super::fields::{Field, Fields};
use super::sheet::{Body, Sheet};

/// Largest number of cells. No parts list has more.
const MOST_CELLS: usize = 16_000_000;

/// Returns the table in a text from a byte on, and the separator of its fields. With that
/// separator, a field is a heading.
pub(crate) fn sheet(
    source: Source<'_>,
    from: usize,
    is_heading: fn(&str) -> bool,
) -> Result<(Sheet<'_>, u8), FormatError> {
    let located = |error| FormatError::of_content(source.path, source.text.as_bytes(), error);
    let unsupported = |what: String| located(ContentError::unsupported(what));
    if source.text.len() > u32::MAX as usize {
        return Err(unsupported(format!("a text of more than {} bytes", u32::MAX)));
    }
    let separator = separator(source.text, from, is_heading).unwrap_or(b',');
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
            // All three are at most the number of bytes of the text.
            let (number, start, end) = (number as u32, start as u32, fields.at as u32);
            rows.push(SheetRow { number, start, end, is_hidden: false });
        }
        number += newlines(source.text.get(start..fields.at).unwrap_or_default());
    }
    let body = Body::Text { source, separator };
    Ok((Sheet { rows: rows.into(), body, decimal_comma: false }, separator))
}

fn newlines(text: &str) -> usize {
    text.bytes().filter(|b| *b == b'\n').count()
}

/// Returns the separator with which a field is a heading, if there is one.
pub(crate) fn separator(text: &str, from: usize, is_heading: fn(&str) -> bool) -> Option<u8> {
    /// Number of lines that are searched for headings.
    const LINES: usize = 100;
    let mut at = from;
    for line in text.get(from..).unwrap_or_default().split_inclusive('\n').take(LINES) {
        let end = at + line.len();
        for separator in *b",;\t" {
            let mut fields = Fields { text: text.get(..end).unwrap_or_default(), at };
            while fields.at < end {
                match fields.next(separator) {
                    Ok((field, _)) if is_heading(&field.text) => return Some(separator),
                    Ok(_) => {}
                    Err(_) => break,
                }
            }
        }
        at = end;
    }
    None
}
