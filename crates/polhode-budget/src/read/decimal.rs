//! Decimal commas in text: declared, or proved by the numbers themselves.

use polhode_source::text::cut;
use polhode_source::{ContentError, ContentErrorKind, FormatError};

use super::cell::{Cell, Content};
use super::heading::Columns;
use super::key::KEYS;
use super::plan::Plan;
use super::sheet::Sheet;

/// Returns true if a comma is the decimal mark. `separator` is that of the fields.
pub(crate) fn comma(
    sheet: &Sheet<'_>,
    columns: &Columns,
    plan: &Plan,
    separator: u8,
) -> Result<bool, FormatError> {
    if let Some(comma) = plan.decimal_comma {
        return Ok(comma);
    }
    if separator == b',' {
        return Ok(false);
    }
    let (mut point, mut comma, mut open) = (None, None, None);
    for row in sheet.rows.iter().skip(columns.row + 1) {
        for cell in sheet.row(row) {
            let is_number = columns
                .get(cell.column)
                .and_then(|column| KEYS.get(column.key)?.holds.dimension())
                .is_some_and(|_| cell.content == Content::Text && !cell.text.starts_with('['));
            if !is_number {
                continue;
            }
            match mark(&cell.text) {
                Some(Mark::Point) => _ = point.get_or_insert(cell),
                Some(Mark::Comma) => _ = comma.get_or_insert(cell),
                Some(Mark::Open) => _ = open.get_or_insert(cell),
                None => {}
            }
        }
    }
    match (point, comma, open) {
        (Some(point), Some(comma), _) => {
            let (point, comma) =
                if point.span.start < comma.span.start { (point, comma) } else { (comma, point) };
            let question = format!(
                "is a comma or a point the decimal mark? Row {} has {}.",
                point.row,
                cut(&point.text)
            );
            Err(unclear(sheet, &comma, question).with_hint("write all numbers with one decimal mark"))
        }
        (None, Some(_), _) => Ok(true),
        (Some(_), None, _) | (None, None, None) => Ok(false),
        (None, None, Some(open)) => {
            let question = "is this a decimal mark or a thousands separator?".to_owned();
            let hint = "write # decimal = \"comma\" or # decimal = \"point\" above the headings";
            Err(unclear(sheet, &open, question).with_hint(hint))
        }
    }
}

fn unclear(sheet: &Sheet<'_>, cell: &Cell<'_>, question: String) -> FormatError {
    let kind = ContentErrorKind::Unclear { question, found: cut(&cell.text) };
    sheet.error(cell, ContentError::of_file(kind).into())
}

/// Decimal mark that a number proves.
#[derive(Debug, PartialEq)]
enum Mark {
    Point,
    Comma,
    /// Mark before three digits, which may separate thousands.
    Open,
}

/// Returns the decimal mark that the first mark in a text proves.
fn mark(text: &str) -> Option<Mark> {
    let at = text.find([',', '.'])?;
    let (before, after) = (&text[..at], &text[at + 1..]);
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = before.bytes().rev().take_while(u8::is_ascii_digit).count();
    // 0.125 and 1234.567 have no separator of thousands.
    let is_whole = !(1..=3).contains(&whole) || before.as_bytes().get(at - whole) == Some(&b'0');
    let is_open = digits(after) == 3 && !is_whole && !after[3..].starts_with([',', '.']);
    Some(match (text.as_bytes()[at], is_open) {
        (_, true) => Mark::Open,
        (b',', false) => Mark::Comma,
        _ => Mark::Point,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_in_front_of_three_digits_proves_nothing() {
        for (text, expected) in [
            ("12", None),
            ("1,5", Some(Mark::Comma)),
            ("1,50 kg", Some(Mark::Comma)),
            ("0,125", Some(Mark::Comma)),
            ("1234,567", Some(Mark::Comma)),
            ("-12,125", Some(Mark::Open)),
            ("12.125", Some(Mark::Open)),
            (".125", Some(Mark::Point)),
            ("0.125 ± 0.001", Some(Mark::Point)),
            ("12.5", Some(Mark::Point)),
        ] {
            assert_eq!(mark(text), expected, "{text}");
        }
    }
}
