//! A `[[torque]]` of model `gravity_gradient`.

use polhode::TorqueModel;

use super::allow;
use crate::error::FormatError;
use crate::scenario::reader::Table;

/// Not readable yet.
pub(super) fn gravity_gradient(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &[])?;
    Err(table.missing("model", "another model"))
}
