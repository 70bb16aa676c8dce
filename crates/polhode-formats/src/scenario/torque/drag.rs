//! A `[[torque]]` of model `drag`.

use polhode::TorqueModel;

use super::allow;
use crate::error::FormatError;
use crate::scenario::reader::Table;

/// Not readable yet.
pub(super) fn drag(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &[])?;
    Err(table.missing("model", "another model"))
}
