//! Shares in the options for meshes.

use std::str::FromStr;

/// Share above 0 and at most one half, written as `5%` or `0.05`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Share(f64);

impl Share {
    /// Largest share: half of the volume.
    pub const MOST: f64 = 0.5;

    /// Returns the share as a number.
    pub const fn value(self) -> f64 {
        self.0
    }
}

impl FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value = parsed(text)?;
        if value > 0.0 && value <= Self::MOST {
            return Ok(Self(value));
        }
        Err(format!("{text} is not above 0 and at most 50% (hint: write 5%, or 0.05)"))
    }
}

/// Fraction from 0 to 1, written as `15%` or `0.15`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Fraction(f64);

impl Fraction {
    /// Returns the fraction as a number.
    pub const fn value(self) -> f64 {
        self.0
    }
}

impl FromStr for Fraction {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value = parsed(text)?;
        if (0.0..=1.0).contains(&value) {
            return Ok(Self(value));
        }
        Err(format!("{text} is not from 0 to 100% (hint: write 15%, or 0.15)"))
    }
}

/// Parses a percentage or a plain number.
fn parsed(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.trim().strip_suffix('%') {
        Some(number) => (number.trim_end(), 100.0),
        None => (text.trim(), 1.0),
    };
    let value = number.parse::<f64>().map_err(|_| {
        format!("{text:?} is not a share (hint: write a percentage such as 5%, or a number such as 0.05)")
    });
    Ok(value? / unit)
}

/// Returns the smallest percentage of at most two digits, and at least 0.01%, that is not below a
/// share.
pub(crate) fn percent_above(share: f64) -> String {
    let percent = (100.0 * share).max(0.01);
    let step = 10_f64.powi(percent.log10().floor() as i32 - 1);
    let decimals = usize::from(step < 1.0) * (-step.log10()).round().max(0.0) as usize;
    let written = |steps: f64| {
        let text = format!("{:.decimals$}", steps * step);
        let trimmed = if decimals > 0 { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        format!("{trimmed}%")
    };
    let below = (percent / step).floor();
    let is_enough = |text: &String| parsed(text).is_ok_and(|value| value >= share);
    [below, below + 1.0].map(written).into_iter().find(is_enough).unwrap_or_else(|| written(below + 2.0))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn shares_are_percentages_or_numbers_up_to_a_half() {
        for (text, value) in [("5%", 0.05), (" 0.05 ", 0.05), ("12.5 %", 0.125), ("50%", 0.5)] {
            assert_eq!(text.parse::<Share>().unwrap().value(), value);
        }
        for (text, value) in [("0", 0.0), ("15%", 0.15), ("100 %", 1.0)] {
            assert_eq!(text.parse::<Fraction>().unwrap().value(), value);
        }
        for text in ["15", "101%", "-1%", "NaN", ""] {
            assert!(text.parse::<Fraction>().is_err(), "{text}");
        }
        for text in ["5", "0", "-1%", "NaN", "51%", "%", "5 mm", "inf", ""] {
            assert!(text.parse::<Share>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_suggested_percentage_is_enough_and_has_two_digits() {
        let cases = [
            (0.0, "0.01%"),
            (0.0123, "1.3%"),
            (0.2, "20%"),
            (0.201, "21%"),
            (0.000_456, "0.046%"),
            (0.0999, "10%"),
        ];
        for (share, text) in cases {
            assert_eq!(percent_above(share), text);
            assert!(percent_above(share).parse::<Share>().unwrap().value() >= share);
        }
    }
}
