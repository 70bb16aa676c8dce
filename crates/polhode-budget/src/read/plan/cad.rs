//! `[cad]`: what reports of CAD programs leave open.

use polhode_shape::cad::{CadOptions, DecimalMark, ProductConvention};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;

use crate::read::heading::no_unit;

/// Reads `[cad]`.
pub(crate) fn options(table: &Table<'_>) -> Result<CadOptions, FormatError> {
    table.allow(&["decimal", "products", "mass_unit", "length_unit"])?;
    let unit = |key, dimension| table.get(key).map(|value| factor(&value, dimension)).transpose();
    let mut options = CadOptions {
        mass_unit: unit("mass_unit", Dimension::MASS)?,
        length_unit: unit("length_unit", Dimension::LENGTH)?,
        ..CadOptions::default()
    };
    if let Some(value) = table.get("decimal") {
        let comma = value.choice(&["point", "comma"])? == "comma";
        options.decimal = Some(if comma { DecimalMark::Comma } else { DecimalMark::Point });
    }
    if let Some(value) = table.get("products") {
        let positive = value.choice(&super::PRODUCTS.map(|(name, _)| name))? == "positive integrals";
        options.products =
            Some(if positive { ProductConvention::Positive } else { ProductConvention::Negative });
    }
    Ok(options)
}

fn factor(value: &Value<'_>, dimension: Dimension) -> Result<f64, FormatError> {
    unit::factor(value.string()?, dimension).map_err(|error| no_unit(error, |kind| value.error(kind)))
}
