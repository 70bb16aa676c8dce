//! Number at the start of a quantity, plain or typeset.
//!
//! Printed numbers can be read back: digits in groups of three separated by a space, `123 456.8`
//! and `8.273 333e-5`, also by a no-break or thin space; a typographic minus; and `8.273 333×10⁻⁵`.
//! A comma is not a digit separator: it separates numbers, and is a decimal mark in some countries.

use super::inverse;

/// Spaces accepted between groups of digits: the ordinary space and the typographic ones.
const SPACES: [char; 4] = [' ', '\u{a0}', '\u{202f}', '\u{2009}'];

/// Number and the unit after it.
#[derive(Debug)]
pub(crate) struct Split<'a> {
    /// The number in ASCII without digit grouping: `-8.273333e-5`.
    pub number: String,
    /// Text after the number.
    pub unit: &'a str,
    /// True if ordinary spaces group its digits, so that it may be several numbers.
    pub spaced: bool,
}

/// Splits a text into a number and its unit; `None` if other characters follow the number directly.
pub(crate) fn split(text: &str) -> Option<Split<'_>> {
    let mut cursor = Cursor { rest: text, number: String::new(), spaced: false };
    cursor.sign();
    let mut count = cursor.digits();
    if (1..=3).contains(&count) && !cursor.number.trim_start_matches('-').starts_with('0') {
        while cursor.group(3..=3).is_some() {}
    }
    if let Some(rest) = cursor.rest.strip_prefix('.') {
        cursor.rest = rest;
        cursor.number.push('.');
        let decimals = cursor.digits();
        count += decimals;
        // Groups have three digits, except the last.
        let mut length = decimals;
        while length == 3
            && let Some(next) = cursor.group(1..=3)
        {
            length = next;
        }
    }
    if count == 0 || !cursor.exponent() {
        return None;
    }
    let unit = cursor.rest.trim_start();
    let glued = cursor.rest.starts_with(['.', ',', '_', 'x', 'X', 'e', 'E']);
    let second_number = unit.starts_with(char::is_numeric) && inverse(unit).is_none();
    (!glued && !second_number).then_some(Split { number: cursor.number, unit, spaced: cursor.spaced })
}

struct Cursor<'a> {
    rest: &'a str,
    number: String,
    spaced: bool,
}

impl Cursor<'_> {
    fn sign(&mut self) {
        let Some(rest) = self.rest.strip_prefix(['+', '-', '\u{2212}']) else { return };
        if !self.rest.starts_with('+') {
            self.number.push('-');
        }
        self.rest = rest;
    }

    /// Reads digits; returns their number.
    fn digits(&mut self) -> usize {
        let count = leading_digits(self.rest);
        let (digits, rest) = self.rest.split_at(count);
        self.number.push_str(digits);
        self.rest = rest;
        count
    }

    /// Reads a space and a group of digits of an allowed size, unless they are the `1/s` of a unit.
    fn group(&mut self, sizes: std::ops::RangeInclusive<usize>) -> Option<usize> {
        let after = self.rest.strip_prefix(SPACES)?;
        let count = leading_digits(after);
        if !sizes.contains(&count) || inverse(after).is_some() {
            return None;
        }
        self.spaced |= self.rest.starts_with(' ');
        self.rest = after;
        Some(self.digits())
    }

    /// Reads an exponent such as `e-5` or `×10⁻⁵`, if present; returns false if it has no digits.
    fn exponent(&mut self) -> bool {
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        if let Some(power) = self.rest.strip_prefix("×10") {
            let (sign, digits) = power.strip_prefix('⁻').map_or(("", power), |digits| ("-", digits));
            let end = digits.find(|c| !RAISED.contains(&c)).unwrap_or(digits.len());
            let digit =
                |c| RAISED.iter().position(|&raised| raised == c).map_or('0', |k| char::from(b'0' + k as u8));
            self.number.extend(["e", sign]);
            self.number.extend(digits[..end].chars().map(digit));
            self.rest = &digits[end..];
            return end > 0;
        }
        let Some(power) = self.rest.strip_prefix(['e', 'E']) else { return true };
        self.rest = power;
        self.number.push('e');
        self.sign();
        self.digits() > 0
    }
}

fn leading_digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_ends_where_it_ends() {
        let read = |text| split(text).map(|Split { number, unit, .. }| (number, unit.to_owned()));
        for (text, number, unit) in [
            ("12 1/s", "12", "1/s"),
            ("0.412 1/s", "0.412", "1/s"),
            ("0.412 618 1/s", "0.412618", "1/s"),
            ("0.412 618 3 rad/s", "0.4126183", "rad/s"),
            ("−8.273 333×10⁻⁵ kg", "-8.273333e-5", "kg"),
            ("+1 234 567", "1234567", ""),
            ("12 345.67e−3m", "12345.67e-3", "m"),
            ("1 m", "1", "m"),
        ] {
            assert_eq!(read(text), Some((number.to_owned(), unit.to_owned())), "{text}");
        }
        for text in [
            "",
            "1 2",
            "1 23",
            "12 3456",
            "1234 567",
            "0 123",
            "1.23 456",
            "1.234 5 6",
            "1,000",
            "1e",
            "1×10",
            "0.125 250.5",
            "- 1",
        ] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
