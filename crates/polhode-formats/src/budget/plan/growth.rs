//! `[growth]`: allowances by maturity code.

use polhode_budget::GrowthTable;

use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::reader::Value;

/// What is said of a number above 1 without %, which may be either.
pub(in crate::budget) const BARE_GROWTH: &str = "in percent, as it is above 1";
pub(in crate::budget) const BARE_GROWTH_HINT: &str = "15 % is 0.15, and 15 is 1500 %";

/// `E = "25 %"`, `C = 0.15`: the table, and its codes.
pub(super) fn table(value: &Value<'_>) -> Result<(GrowthTable, Vec<String>), FormatError> {
    let mut codes = Vec::new();
    for (code, allowance) in value.table()?.each("growth") {
        let fraction = super::fraction(&allowance)?;
        if !(fraction >= 0.0) {
            let error = allowance.invalid("zero or positive");
            return Err(error.with_hint("it is by how much parts of this code become heavier until they fly"));
        }
        if fraction > 1.0 && !allowance.string().is_ok_and(|text| text.contains('%')) {
            return Err(allowance.invalid(BARE_GROWTH).with_hint(BARE_GROWTH_HINT));
        }
        codes.push((code.to_owned(), fraction));
    }
    let names = codes.iter().map(|(code, _)| code.clone()).collect();
    let table = GrowthTable::new(codes)
        .map_err(|error| value.error(FormatErrorKind::subject(&error, error.hint())))?;
    Ok((table, names))
}
