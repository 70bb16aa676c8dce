//! Numbers in cells, and their units.

use polhode_source::text::{cut, visible};
use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{FormatError, FormatErrorKind};

/// Unit of a column.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    pub name: String,
    pub dimension: Dimension,
    /// Factor to SI as p × 10^t, if it has this form with a small p. Numbers then need only one
    /// rounding.
    decimal: Option<(u64, i32)>,
}

/// Error of a text that is not a valid number, with a hint.
#[derive(Debug)]
pub(crate) struct Wrong {
    kind: FormatErrorKind,
    hint: Option<String>,
}

/// Number as it was read, with its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measured {
    /// Value in SI units.
    pub value: f64,
    /// Error after ± in the cell.
    pub error: Option<Amount>,
    /// True if every part that needs a unit has one in the cell.
    pub has_unit: bool,
}

/// Amount of an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Amount {
    /// Amount in SI units.
    Absolute(f64),
    /// Fraction of the number itself.
    Relative(f64),
}

impl Amount {
    pub(crate) fn map(self, change: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Absolute(amount) => Self::Absolute(change(amount)),
            Self::Relative(fraction) => Self::Relative(change(fraction)),
        }
    }

    /// Returns the amount for this value. Returns `None` for a fraction of zero.
    pub(crate) fn of(self, value: f64) -> Option<f64> {
        match self {
            Self::Absolute(amount) => Some(amount),
            Self::Relative(fraction) if value != 0.0 || fraction == 0.0 => Some(fraction * value.abs()),
            Self::Relative(_) => None,
        }
    }
}

impl Unit {
    pub(crate) const SI: Self =
        Self { name: String::new(), dimension: Dimension::NONE, decimal: Some((1, 0)) };

    pub(crate) fn new(name: &str, dimension: Dimension) -> Result<Self, UnitError> {
        let factor = unit::factor(name, dimension)?;
        Ok(Self { name: name.to_owned(), dimension, decimal: decimal(factor) })
    }

    /// Reads a number whose default unit is this one. The result is in SI.
    pub(crate) fn read(&self, text: &str, dimension: Dimension) -> Result<Measured, UnitError> {
        let read = |value, has_unit| Ok(Measured { value, error: None, has_unit });
        if let Some(value) = self.plain(text) {
            return read(value, false);
        }
        if is_parted(text) {
            return Err(UnitError::NotANumber { text: text.to_owned() });
        }
        if !self.name.is_empty() && unit::number_of(text).is_some() && unit::unit_of(text).is_empty() {
            let value = unit::parse(&format!("{text} {}", self.name), self.dimension)?;
            return read(value, false);
        }
        let value = unit::parse(text, dimension)?;
        read(value, !unit::unit_of(text).is_empty())
    }

    /// Reads a number in plain digits: the double nearest to the exact product, if one operation
    /// gives it.
    fn plain(&self, text: &str) -> Option<f64> {
        let (p, mut ten) = self.decimal?;
        let (digits, sign) = match text.strip_prefix('-') {
            Some(digits) => (digits, -1.0),
            None => (text, 1.0),
        };
        let mut integer: u64 = 0;
        let mut point = false;
        let mut count = 0;
        for b in digits.bytes() {
            match b {
                b'0'..=b'9' => {
                    integer = integer.checked_mul(10)?.checked_add(u64::from(b - b'0'))?;
                    count += 1;
                    ten -= i32::from(point);
                }
                b'.' if !point => point = true,
                _ => return None,
            }
        }
        let product = integer.checked_mul(p).filter(|product| count > 0 && *product < 1 << 53)?;
        let product = product as f64;
        let magnitude = match usize::try_from(ten.unsigned_abs()).ok().and_then(|k| POWERS.get(k))? {
            power if ten < 0 => product / power,
            power => product * power,
        };
        Some(sign * magnitude)
    }
}

/// Returns true if a space separates two digits: 1 250 may be one number or two.
pub(crate) fn is_parted(text: &str) -> bool {
    let starts_with_digit = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    text.char_indices().any(|(k, c)| {
        let rest = text[k + c.len_utf8()..].trim_start();
        c.is_ascii_digit() && rest.len() < text.len() - k - c.len_utf8() && starts_with_digit(rest)
    })
}

/// Powers of ten that are exact as doubles.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Returns a factor as p × 10^t with p < 10¹⁰. Only units with such a factor are that near to one.
fn decimal(factor: f64) -> Option<(u64, i32)> {
    POWERS.iter().zip(0..).take(13).find_map(|(power, t)| {
        let p = (factor * power).round();
        ((1.0..1e10).contains(&p) && p / power == factor).then_some((p as u64, -t))
    })
}

impl Wrong {
    /// Makes the error at a place.
    pub(crate) fn at(self, place: impl FnOnce(FormatErrorKind) -> FormatError) -> FormatError {
        place(self.kind).with_hint_of(self.hint)
    }

    /// Makes the error of a text that violates a rule.
    pub(crate) fn rule(heading: &str, text: &str, rule: &str, hint: &str) -> Self {
        let value = cut(text).chars().map(visible).collect();
        let (key, rule) = (heading.to_owned(), rule.to_owned());
        Self { kind: FormatErrorKind::Value { key, value, rule }, hint: Some(hint.to_owned()) }
    }
}

impl From<UnitError> for Wrong {
    fn from(error: UnitError) -> Self {
        Self { kind: FormatErrorKind::Unit(error), hint: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_in_a_column_is_the_double_that_it_is_with_its_unit() {
        let mut seed = 1_u64;
        for unit in ["kg", "g", "lb", "slug", "oz"] {
            let column = Unit::new(unit, Dimension::MASS).unwrap();
            for decimals in 0..9 {
                for _ in 0..200 {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    let number = (seed >> 40) as f64 * 10_f64.powi(-decimals);
                    let text = format!("{number:.*}", decimals as usize);
                    let expected = unit::parse(&format!("{text} {unit}"), Dimension::MASS).unwrap();
                    assert_eq!(column.read(&text, Dimension::MASS).unwrap().value, expected, "{text} {unit}");
                }
            }
        }
        assert_eq!(Unit::new("lb", Dimension::MASS).unwrap().decimal, Some((45_359_237, -8)));
        assert_eq!(Unit::new("deg", Dimension::ANGLE).unwrap().decimal, None);
        assert_eq!(Unit::SI.plain("-0.25"), Some(-0.25));
        for text in ["", "-", ".", "1.2.3", "1e3", "+1", "9007199254740993"] {
            assert_eq!(Unit::SI.plain(text), None, "{text}");
        }
    }
}
