//! `[cad]`: options of reports of CAD programs.

use polhode_shape::cad::{CadOptions, DecimalMark, ProductConvention};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;

use crate::ProductSign;
use crate::read::heading::no_unit;

/// Reads the table `[cad]`.
pub(crate) fn options(table: &Table<'_>) -> Result<CadOptions, FormatError> {
    table.allow(&["decimal", "products", "mass_unit", "length_unit"])?;
    let unit = |key, dimension| table.get(key).map(|value| factor(&value, dimension)).transpose();
    let mut options = CadOptions {
        mass_unit: unit("mass_unit", Dimension::MASS)?,
        length_unit: unit("length_unit", Dimension::LENGTH)?,
        ..CadOptions::default()
    };
    if let Some(value) = table.get("decimal") {
        let marks = [("point", DecimalMark::Point), ("comma", DecimalMark::Comma)];
        options.decimal = Some(value.named(&marks)?);
    }
    if let Some(value) = table.get("products") {
        options.products = Some(match value.named(&ProductSign::NAMED)? {
            ProductSign::NegativeIntegral => ProductConvention::Negative,
            ProductSign::PositiveIntegral => ProductConvention::Positive,
        });
    }
    Ok(options)
}

fn factor(value: &Value<'_>, dimension: Dimension) -> Result<f64, FormatError> {
    unit::factor(value.string()?, dimension).map_err(|error| no_unit(error, |kind| value.error(kind)))
}
