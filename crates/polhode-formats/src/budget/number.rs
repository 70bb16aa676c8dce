//! Numbers in cells.

use crate::unit::{self, Dimension, UnitError};

/// The unit of a column.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    name: String,
    dimension: Dimension,
}

impl Unit {
    pub(super) fn new(name: &str, dimension: Dimension) -> Result<Self, UnitError> {
        unit::factor(name, dimension)?;
        Ok(Self { name: name.to_owned(), dimension })
    }
}

/// A number with a unit, or in that of its column, or else in SI.
pub(super) fn number(text: &str, unit: Option<&Unit>, dimension: Dimension) -> Result<f64, UnitError> {
    match unit {
        Some(unit) if unit::unit_of(text).is_empty() => {
            unit::parse(&format!("{text} {}", unit.name), unit.dimension)
        }
        _ => unit::parse(text, dimension),
    }
}
