//! `[growth]`: allowances by maturity code.

use polhode_budget::GrowthTable;

use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::reader::Value;

/// `E = "25 %"`, `C = 0.15`: the table, and its codes.
pub(super) fn table(value: &Value<'_>) -> Result<(GrowthTable, Vec<String>), FormatError> {
    let mut codes = Vec::new();
    for (code, allowance) in value.table()?.each("growth") {
        let fraction = super::fraction(&allowance)?;
        if !(fraction >= 0.0) {
            let error = allowance.invalid("zero or positive");
            return Err(error.with_hint("it is by how much parts of this code become heavier until they fly"));
        }
        codes.push((code.to_owned(), fraction));
    }
    let names = codes.iter().map(|(code, _)| code.clone()).collect();
    let table = GrowthTable::new(codes).map_err(|error| value.error(FormatErrorKind::Budget(error)))?;
    Ok((table, names))
}
