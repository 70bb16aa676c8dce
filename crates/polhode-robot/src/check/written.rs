//! Number as text: the meaning of its digits, and changed values in the same style.

/// Parts of the text of a decimal number.
struct Parts<'t> {
    sign: &'t str,
    whole: &'t str,
    fraction: Option<&'t str>,
    /// Exponent with its letter and sign: `"E-6"`.
    power: &'t str,
}

/// Splits a decimal number into its parts; `None` for other texts.
fn parts(text: &str) -> Option<Parts<'_>> {
    let rest = text.strip_prefix(['+', '-']).unwrap_or(text);
    let sign = &text[..text.len() - rest.len()];
    let (mantissa, power) = rest.split_at(rest.find(['e', 'E']).unwrap_or(rest.len()));
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((whole, fraction)) => (whole, Some(fraction)),
        None => (mantissa, None),
    };
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let any = !whole.is_empty() || fraction.is_some_and(|f| !f.is_empty());
    (any && digits(whole) && fraction.is_none_or(digits)).then_some(Parts { sign, whole, fraction, power })
}

fn exponent(power: &str) -> i32 {
    power.get(1..).and_then(|p| p.parse().ok()).unwrap_or(0)
}

/// Returns the power of ten of the last written digit: −6 for `"0.001234"` and for `"1676359E-6"`.
pub(super) fn last_place(text: &str) -> Option<i32> {
    let parts = parts(text)?;
    let decimals = i32::try_from(parts.fraction.map_or(0, str::len)).ok()?;
    exponent(parts.power).checked_sub(decimals)
}

/// Returns the number of significant digits, from the first nonzero digit.
pub(super) fn significant(text: &str) -> usize {
    parts(text).map_or(0, |p| {
        let digits = format!("{}{}", p.whole, p.fraction.unwrap_or(""));
        digits.trim_start_matches('0').len()
    })
}

/// Returns the number of decimals, if the number is written without an exponent.
pub(super) fn decimals(text: &str) -> Option<usize> {
    parts(text).filter(|p| p.power.is_empty()).map(|p| p.fraction.map_or(0, str::len))
}

/// Returns the number with the opposite sign.
pub(super) fn negated(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{}", text.strip_prefix('+').unwrap_or(text)),
    }
}

/// Returns the number times 10^`powers` with the same digits: `"1676359E-6"`, −3 → `"1676.359E-6"`;
/// `"310"`, −9 → `"310e-9"`.
pub(super) fn shifted(text: &str, powers: i32) -> Option<String> {
    let Parts { sign, whole, fraction, power } = parts(text)?;
    let digits = format!("{whole}{}", fraction.unwrap_or(""));
    let point = i32::try_from(whole.len()).ok()?.checked_add(powers)?;
    let length = i32::try_from(digits.len()).ok()?;
    // The point stays among the digits, or near them in a number without exponent. Otherwise the
    // exponent changes.
    let near = if power.is_empty() { -4..=length.max(1) + 3 } else { 1..=length };
    if near.contains(&point) {
        let moved = if point <= 0 {
            format!("0.{}{digits}", "0".repeat(usize::try_from(-point).ok()?))
        } else if point >= length {
            format!("{digits}{}", "0".repeat(usize::try_from(point - length).ok()?))
        } else {
            let (left, right) = digits.split_at(usize::try_from(point).ok()?);
            format!("{left}.{right}")
        };
        let lead = moved.trim_start_matches('0');
        let moved =
            if lead.is_empty() || lead.starts_with('.') { format!("0{lead}") } else { lead.to_owned() };
        return Some(format!("{sign}{moved}{power}"));
    }
    let letter = power.get(..1).unwrap_or("e");
    let mantissa = &text[..text.len() - power.len()];
    Some(format!("{mantissa}{letter}{}", exponent(power).checked_add(powers)?))
}

/// Returns another value in the style of a text: at least six digits, with an exponent if the text
/// has one.
pub(super) fn restyled(value: f64, text: &str) -> String {
    let digits = significant(text).clamp(6, 17);
    let letter = if text.contains('E') { 'E' } else { 'e' };
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent = scientific.split_once('e').and_then(|(_, p)| p.parse::<i32>().ok()).unwrap_or(0);
    if text.contains(['e', 'E']) || !(-6..=6).contains(&exponent) {
        return scientific.replace('e', &letter.to_string());
    }
    let places = usize::try_from((i32::try_from(digits).unwrap_or(17) - 1 - exponent).max(0)).unwrap_or(0);
    format!("{value:.places$}")
}

/// Returns the reason why a text is not a number, and the intended number if it is certain.
pub(super) fn complaint(text: &str) -> (String, Option<String>) {
    if text.is_empty() {
        return ("is empty".to_owned(), None);
    }
    if text.contains("${") || text.contains("$(") {
        return ("is a xacro expression: expand the file first".to_owned(), None);
    }
    let pointed = text.replace(',', ".");
    if text.matches(',').count() == 1
        && !text.contains('.')
        && parts(&pointed).is_some_and(|_| is_number(&pointed))
    {
        // "1,234" may mean one thousand two hundred thirty-four. Only a comma that cannot separate
        // thousands is certainly a decimal comma.
        let (whole, rest) = text.split_once(',').unwrap_or((text, ""));
        let whole = whole.trim_start_matches(['+', '-']);
        let thousands = rest.len() == 3 && !whole.is_empty() && !whole.starts_with('0') && whole.len() <= 3;
        let sure = (!thousands).then_some(pointed);
        return ("has a decimal comma; use a decimal point".to_owned(), sure);
    }
    let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let unit = if unit.starts_with(['e', 'E'])
        && unit[1..].starts_with(|c: char| c.is_ascii_digit() || "+-".contains(c))
    {
        unit[1..].trim_start_matches(|c: char| c.is_ascii_digit() || "+-".contains(c))
    } else {
        unit
    };
    let unit = unit.trim_start();
    let head = text[..text.len() - unit.len()].trim_end();
    if !unit.is_empty()
        && unit.starts_with(|c: char| c.is_alphabetic() || "µ°".contains(c))
        && is_number(head)
    {
        let si = unit == "kg";
        return (
            format!("has the unit {unit:?}; write numbers without units, in kg, m and kg·m²"),
            si.then(|| head.to_owned()),
        );
    }
    let count = text.split_whitespace().count();
    if count > 1 && text.split_whitespace().all(is_number) {
        return (format!("has the wrong count of numbers: {count}"), None);
    }
    ("is not a number".to_owned(), None)
}

fn is_number(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(f64::is_finite)
}

/// Formats a number with this many significant digits, without trailing zeros.
pub(super) fn short(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return format!("{x}");
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    let (mantissa, power) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = power.parse().unwrap_or(0);
    if (-3..=5).contains(&exponent) {
        let places = usize::try_from(i32::try_from(digits).unwrap_or(6) - 1 - exponent).unwrap_or(0);
        return trimmed(&format!("{x:.places$}")).to_owned();
    }
    format!("{}e{power}", trimmed(mantissa))
}

fn trimmed(s: &str) -> &str {
    if s.contains('.') { s.trim_end_matches('0').trim_end_matches('.') } else { s }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_place_is_read_off_the_text() {
        assert_eq!(last_place("1676359E-6"), Some(-6));
        assert_eq!(last_place("-0.001234"), Some(-6));
        assert_eq!(last_place("1.50e3"), Some(1));
        assert_eq!(last_place("0,5"), None);
        assert_eq!(last_place("nan"), None);
        assert_eq!(significant("0.001230"), 4);
        assert_eq!(decimals("0.0010"), Some(4));
        assert_eq!(decimals("1e-3"), None);
    }

    #[test]
    fn shifted_numbers_keep_their_style_and_have_their_value() {
        for (text, powers, expected) in [
            ("1676359E-6", -3, "1676.359E-6"),
            ("0.0123", 3, "12.3"),
            ("-2.5", -3, "-0.0025"),
            ("310", -9, "310e-9"),
            ("3.1e2", -9, "3.1e-7"),
            ("0.5", 1, "5"),
            (".5", -2, "0.005"),
            ("12", 2, "1200"),
            ("1.25E+03", -6, "1.25E-3"),
        ] {
            let moved = shifted(text, powers).unwrap();
            assert_eq!(moved, expected);
            let value = text.parse::<f64>().unwrap() * 10f64.powi(powers);
            assert!((moved.parse::<f64>().unwrap() / value - 1.0).abs() < 1e-14, "{moved}");
        }
        assert_eq!(shifted("0,5", 1), None);
    }

    #[test]
    fn restyled_numbers_keep_digits_and_letter() {
        assert_eq!(restyled(0.0123456789, "1.23456E-2"), "1.23457E-2");
        assert_eq!(restyled(0.0123456789, "0.0199"), "0.0123457");
        assert_eq!(negated("-1.5"), "1.5");
        assert_eq!(negated("+1.5"), "-1.5");
        assert_eq!(negated("1.5"), "-1.5");
    }

    #[test]
    fn complaints_name_the_reason() {
        assert_eq!(complaint("0,5").1.as_deref(), Some("0.5"));
        assert!(complaint("0,5").0.contains("decimal comma"));
        assert_eq!(complaint("1,234").1, None);
        assert!(complaint("1kg").0.contains("unit \"kg\""));
        assert_eq!(complaint("1kg").1.as_deref(), Some("1"));
        assert_eq!(complaint("1.5e-3 g").1, None);
        assert!(complaint("1.5e-3 g").0.contains("unit \"g\""));
        assert!(complaint("${m}").0.contains("xacro"));
        assert_eq!(complaint("1.2.3"), ("is not a number".to_owned(), None));
        assert_eq!(complaint("0 1.5708 0 0").0, "has the wrong count of numbers: 4");
        assert_eq!(complaint("é").1, None);
        assert_eq!(complaint("eé").1, None);
    }

    #[test]
    fn numbers_for_people() {
        assert_eq!(short(1.676359, 6), "1.67636");
        assert_eq!(short(0.00496441, 3), "0.00496");
        assert_eq!(short(3.1e-7, 3), "3.1e-7");
        assert_eq!(short(310.0, 3), "310");
        assert_eq!(short(-17852.2, 5), "-17852");
        assert_eq!(short(1234567.0, 3), "1.23e6");
    }
}
