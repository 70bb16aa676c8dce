//! Parts lists in text: fields between commas, semicolons or tabs, in quotes if they hold any.

use polhode_source::ContentError;
use polhode_source::FormatError;
use polhode_source::toml::source::Source;

use super::cell::SheetRow;
use super::fields::{Field, Fields};
use super::sheet::{Body, Sheet};

/// More cells than any parts list has.
const MOST_CELLS: usize = 16_000_000;

/// The table in a text from this byte on, and what parts its fields: by whichever a heading is one.
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
    let body = Body::Text { source, separator };
    Ok((Sheet { rows: rows.into(), body, decimal_comma: false }, separator))
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
