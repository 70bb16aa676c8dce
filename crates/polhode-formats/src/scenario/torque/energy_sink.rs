//! A `[[torque]]` of model `energy_sink`.

use polhode::TorqueModel;

use super::allow;
use crate::error::FormatError;
use crate::scenario::reader::Table;

/// Not readable yet.
pub(super) fn energy_sink(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &[])?;
    Err(table.missing("model", "another model"))
}
