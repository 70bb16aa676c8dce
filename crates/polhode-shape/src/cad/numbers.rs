//! Printed numbers: decimal mark and rounding error.
//!
//! A report writes all numbers in one style, so one number with a single interpretation determines
//! the others. `5,517.5` and `0.008` have a decimal point, `1.234,56` and `0,0012` a decimal comma.
//! `1,234` alone is ambiguous.

use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind};

use super::DecimalMark;

/// Returns the span of the number at byte `at` of a line; `None` if it is part of a word.
pub(crate) fn number_at(line: &str, at: usize) -> Option<Range<usize>> {
    let before = line[..at].chars().next_back();
    if before.is_some_and(|c| c.is_alphanumeric() || "_^.,'*/\u{b7}+-\u{2212}".contains(c)) {
        return None;
    }
    let rest = &line[at..];
    let sign = rest.chars().next().filter(|c| "+-\u{2212}".contains(*c)).map_or(0, char::len_utf8);
    let mantissa: usize = mantissa_length(&rest[sign..]);
    let end = sign + mantissa;
    (mantissa > 0).then(|| at..at + end + exponent_length(&rest[end..]))
}

/// Returns the length of digits with marks between them, bytes.
fn mantissa_length(text: &str) -> usize {
    let (mut end, mut digits) = (0, false);
    for (i, c) in text.char_indices() {
        if c.is_ascii_digit() {
            (end, digits) = (i + 1, true);
        } else if !is_mark(c) || (!digits && i > 0) {
            break;
        }
    }
    end
}

fn is_mark(c: char) -> bool {
    c == '.' || c == ',' || is_separator(c)
}

/// Returns true for characters that only separate thousands: an apostrophe or a no-break space.
fn is_separator(c: char) -> bool {
    matches!(c, '\'' | '\u{2019}' | '\u{a0}' | '\u{202f}')
}

fn exponent_length(text: &str) -> usize {
    let Some(rest) = text.strip_prefix(['e', 'E']) else { return 0 };
    let sign = usize::from(rest.starts_with(['+', '-']));
    match rest[sign..].bytes().take_while(u8::is_ascii_digit).count() {
        0 => 0,
        digits => 1 + sign + digits,
    }
}

/// Evidence of a number about the decimal mark.
enum Evidence {
    Nothing,
    Either,
    Is(DecimalMark),
}

/// Returns the decimal mark of all these numbers.
///
/// # Errors
/// [`ContentErrorKind::Unclear`] if the numbers are ambiguous, or contradict each other.
pub(crate) fn decimal_mark(
    text: &str,
    numbers: &[Range<usize>],
    told: Option<DecimalMark>,
) -> Result<DecimalMark, ContentError> {
    let (mut settled, mut open) = (None, None);
    for span in numbers {
        match evidence(&text[span.clone()]) {
            Some(Evidence::Nothing) => {}
            Some(Evidence::Either) => open = open.or(Some(span)),
            Some(Evidence::Is(mark)) => match settled {
                None => settled = Some((mark, span)),
                Some((other, first)) if other != mark => {
                    let found = format!("{} and {}", &text[first.clone()], &text[span.clone()]);
                    return Err(question(found, span));
                }
                Some(_) => {}
            },
            None => return Err(not_a_number(text, span)),
        }
    }
    match (settled, open, told) {
        (Some((mark, span)), _, Some(told)) if mark != told => {
            let value = text[span.clone()].to_owned();
            let rule = format!("written with a decimal {}, as given by --decimal", told.name());
            let kind = ContentErrorKind::value("the number", value, rule);
            Err(kind.at(span.clone()).hint("delete --decimal"))
        }
        (Some((mark, _)), ..) | (None, _, Some(mark)) => Ok(mark),
        (None, None, None) => Ok(DecimalMark::Point),
        (None, Some(span), None) => Err(question(text[span.clone()].to_owned(), span)),
    }
}

fn question(found: String, span: &Range<usize>) -> ContentError {
    ContentErrorKind::unclear("is the decimal mark a point or a comma?", found)
        .at(span.clone())
        .hint("give --decimal point or --decimal comma, or print more digits")
}

fn not_a_number(text: &str, span: &Range<usize>) -> ContentError {
    ContentErrorKind::expected("a number", text[span.clone()].to_owned()).at(span.clone())
}

fn mantissa(number: &str) -> (&str, Option<&str>) {
    let unsigned = number.trim_start_matches(['+', '-', '\u{2212}']);
    unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(mantissa, power)| (mantissa, Some(power)))
}

/// Returns the evidence of a number about the decimal mark; `None` if it is not a number in either
/// style.
fn evidence(number: &str) -> Option<Evidence> {
    let readings = [DecimalMark::Point, DecimalMark::Comma].map(|mark| plain(number, mark).is_some());
    let has_mark = number.contains(['.', ',']);
    match readings {
        _ if !has_mark => readings[0].then_some(Evidence::Nothing),
        [true, true] => Some(Evidence::Either),
        [true, false] => Some(Evidence::Is(DecimalMark::Point)),
        [false, true] => Some(Evidence::Is(DecimalMark::Comma)),
        [false, false] => None,
    }
}

/// Number in normalized form, with the rounding of its last digit.
pub(crate) struct Plain {
    /// Text with sign, digits, point and exponent.
    pub digits: String,
    /// Number of digits after the decimal mark; `None` in scientific notation.
    pub decimals: Option<usize>,
    /// Half a unit of the last digit.
    pub half: f64,
}

/// Parses a number with a known decimal mark.
pub(crate) fn read(text: &str, span: &Range<usize>, mark: DecimalMark) -> Result<Plain, ContentError> {
    plain(&text[span.clone()], mark).ok_or_else(|| not_a_number(text, span))
}

/// Parses a number for one decimal mark. The mark may occur once, after all thousands separators,
/// which form groups of three.
fn plain(number: &str, mark: DecimalMark) -> Option<Plain> {
    let (mantissa, power) = mantissa(number);
    let decimal = mark.character();
    let (whole, fraction) = mantissa.split_once(decimal).unwrap_or((mantissa, ""));
    if !fraction.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let groups: Vec<&str> = whole.split(is_mark).collect();
    let grouped = groups.len() > 1;
    let threes = groups.iter().skip(1).all(|g| g.len() == 3);
    // A leading group of zero is not used for thousands, so 0,123 has no thousands separator.
    let leads = groups.first().is_some_and(|g| (1..=3).contains(&g.len()) && !g.starts_with('0'));
    let mut separators = whole.chars().filter(|c| is_mark(*c));
    let first = separators.next();
    let alike = separators.all(|c| Some(c) == first);
    if grouped && !(threes && leads && alike && power.is_none()) {
        return None;
    }
    let sign = if number.starts_with(['-', '\u{2212}']) { "-" } else { "" };
    let whole = groups.concat();
    let power_of_ten: i32 = power.map_or(Some(0), |p| p.parse().ok())?;
    let last = power_of_ten.saturating_sub(i32::try_from(fraction.len()).ok()?);
    let half = format!("0.5e{last}").parse().ok()?;
    let zero = if whole.is_empty() { "0" } else { "" };
    let exponent = power.map_or(String::new(), |p| format!("e{p}"));
    let point = if fraction.is_empty() { "" } else { "." };
    let digits = format!("{sign}{zero}{whole}{point}{fraction}{exponent}");
    Some(Plain { digits, decimals: power.is_none().then_some(fraction.len()), half })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(numbers: &[&str], told: Option<DecimalMark>) -> Result<DecimalMark, ContentError> {
        let text = numbers.join(" ");
        let mut at = 0;
        let spans: Vec<_> = numbers
            .iter()
            .map(|n| {
                let span = at..at + n.len();
                at += n.len() + 1;
                span
            })
            .collect();
        decimal_mark(&text, &spans, told)
    }

    #[test]
    fn one_clear_number_settles_the_others() {
        use DecimalMark::{Comma, Point};
        for (numbers, want) in [
            (&["1,234", "0.5"][..], Point),
            (&["1,234", "0,5"], Comma),
            (&["1,234", "1.234.567"], Comma),
            (&["1,234", "1,234,567"], Point),
            (&["1.234,56"], Comma),
            (&["-12,345.6"], Point),
            (&["0,123"], Comma),
            (&["5517.548", "43.721"], Point),
            (&["1.234E+05", "1,234"], Point),
            (&["1'234.56", "2.345"], Point),
            (&["1'234.567", "2.345"], Point),
            (&["12", "7"], Point),
        ] {
            assert_eq!(mark(numbers, None), Ok(want), "{numbers:?}");
        }
    }

    #[test]
    fn what_stays_open_is_asked_and_what_contradicts_is_refused() {
        let unclear = |numbers: &[&str]| {
            matches!(mark(numbers, None), Err(ContentError { kind: ContentErrorKind::Unclear { .. }, .. }))
        };
        assert!(unclear(&["1,234"]) && unclear(&["1.234", "12"]) && unclear(&["1.234", "5,678"]));
        assert!(unclear(&["1.5", "2,5"]));
        assert_eq!(mark(&["1,234"], Some(DecimalMark::Comma)), Ok(DecimalMark::Comma));
        assert!(mark(&["1.5"], Some(DecimalMark::Comma)).is_err());
        assert!(mark(&["1,2,3"], None).is_err() && mark(&["1.2.3,4,5"], None).is_err());
    }

    #[test]
    fn a_number_is_plain_with_half_its_last_digit() {
        let read = |n, mark| plain(n, mark).map(|p: Plain| (p.digits, p.half));
        assert_eq!(read("-1.234,50", DecimalMark::Comma), Some(("-1234.50".to_owned(), 0.005)));
        assert_eq!(read("2.440E+06", DecimalMark::Point), Some(("2.440e+06".to_owned(), 500.0)));
        assert_eq!(read("\u{2212}.5", DecimalMark::Point), Some(("-0.5".to_owned(), 0.05)));
        assert_eq!(read("12\u{202f}345", DecimalMark::Comma), Some(("12345".to_owned(), 0.5)));
    }

    #[test]
    fn a_number_is_neither_inside_a_word_nor_a_unit() {
        let all = |line: &str| -> Vec<String> {
            let starts = line.char_indices().filter_map(|(i, _)| number_at(line, i));
            starts.map(|span| line[span].to_owned()).collect()
        };
        assert_eq!(all("-47.344 mm, 63.319 mm, 69.742 mm"), ["-47.344", "63.319", "69.742"]);
        assert_eq!(all("Ix = (0.00, -0.00,  1.00)  Px = 3,5"), ["0.00", "-0.00", "1.00", "3,5"]);
        assert_eq!(all("PRT0001 (g mm^2) m\u{b2} 1.5e-3kg"), ["1.5e-3"]);
    }
}
