//! `[growth]`: growth allowances by maturity code.

use polhode_source::toml::reader::Value;
use polhode_source::{FormatError, FormatErrorKind};

use crate::GrowthTable;

/// Rule for a number above 1 without %, which may be a fraction or a percentage.
pub(crate) const BARE_GROWTH: &str = "in percent, because it is above 1";
pub(crate) const BARE_GROWTH_HINT: &str = "15 % is 0.15; 15 would be 1500 %";

/// Reads a table such as `E = "25 %"`, `C = 0.15`.
pub(crate) fn table(value: &Value<'_>) -> Result<GrowthTable, FormatError> {
    let mut codes = Vec::new();
    for (code, allowance) in value.table()?.each("growth") {
        let fraction = super::fraction(&allowance)?;
        if !(fraction >= 0.0) {
            let error = allowance.invalid("zero or positive");
            return Err(
                error.with_hint("it is the expected mass growth of parts with this code until flight")
            );
        }
        if fraction > 1.0 && !allowance.string().is_ok_and(|text| text.contains('%')) {
            return Err(allowance.invalid(BARE_GROWTH).with_hint(BARE_GROWTH_HINT));
        }
        codes.push((code.to_owned(), fraction));
    }
    GrowthTable::new(codes).map_err(|error| value.error(FormatErrorKind::subject(&error, error.hint())))
}
