//! A `[[torque]]` of model `thruster`.

use polhode::TorqueModel;

use super::allow;
use crate::error::FormatError;
use crate::scenario::reader::Table;

/// Not readable yet.
pub(super) fn thruster(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &[])?;
    Err(table.missing("model", "another model"))
}
