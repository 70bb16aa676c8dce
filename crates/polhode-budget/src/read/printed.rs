//! Precision of a printed number.

use polhode_source::FormatError;
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::cell::{Cell, Content};
use super::cells::Reader;
use super::key::KEYS;

impl<'s, 'a> Reader<'s, 'a> {
    /// Returns half a unit of the last printed digit of a number, in SI.
    pub(crate) fn half_digit(&self, cell: &Cell<'a>) -> Result<f64, FormatError> {
        let Some(column) = self.columns.get(cell.column) else { return Ok(0.0) };
        let text = self.pointed(cell)?;
        let decimals = match cell.content {
            Content::Number { decimals: Some(decimals) } => i32::from(decimals),
            _ => decimals(&text),
        };
        let unit = match unit::unit_of(&text) {
            "" => String::new(),
            own => format!(" {own}"),
        };
        let half = format!("5e{}{unit}", -decimals - 1);
        let dimension = KEYS.get(column.key).and_then(|key| key.holds.dimension()).unwrap_or(Dimension::NONE);
        // A value that is too small for a double counts as 0.
        Ok(column.unit().read(&half, dimension).map_or(0.0, |read| read.value))
    }
}

/// Returns the number of decimals: 2 for 12.50, −2 for 1.5e3.
fn decimals(text: &str) -> i32 {
    let number = unit::number_of(text).unwrap_or_default();
    let (digits, power) = number.split_once('e').unwrap_or((&number, "0"));
    let behind = digits.split_once('.').map_or(0, |(_, behind)| behind.len());
    let power = power.parse::<i32>().unwrap_or(0).clamp(-1000, 1000);
    i32::try_from(behind).unwrap_or(0).min(1000) - power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_those_that_are_printed() {
        for (text, expected) in
            [("12", 0), ("12.50", 2), ("1.5e3 g", -2), ("-0.125e-2", 5), ("1 234.5 kg", 1), ("x", 0)]
        {
            assert_eq!(decimals(text), expected, "{text}");
        }
    }
}
