//! Sizes of tanks, and densities of liquids.

use polhode_source::FormatError;
use polhode_source::toml::reader::Value;
use polhode_source::unit::Dimension;

pub(crate) fn not_negative(value: &Value<'_>) -> Result<f64, FormatError> {
    let length = value.quantity(Dimension::LENGTH)?;
    match length {
        0.0 => Ok(length),
        length if length > 0.0 => in_range(value, length, SIZES),
        _ => Err(value.invalid("zero or positive")),
    }
}

/// Ranges of sizes of tanks, m, and of densities of liquids, kg/m³. Beyond them, levels are only
/// rounding error.
pub(crate) const SIZES: [f64; 2] = [1e-6, 1e6];
pub(crate) const DENSITIES: [f64; 2] = [1e-6, 1e6];

pub(crate) fn in_range(value: &Value<'_>, number: f64, [least, most]: [f64; 2]) -> Result<f64, FormatError> {
    if number >= least && number <= most {
        return Ok(number);
    }
    Err(value.invalid(format!("from {least:e} to {most:e}, in SI")))
}
