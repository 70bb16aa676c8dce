//! When a `[[torque]]` acts: keys of every model.

use polhode::TorqueModel;

use crate::error::FormatError;
use crate::scenario::reader::Table;

/// The keys that every torque may have.
pub(super) const KEYS: [&'static str; 0] = [];

/// The torque at its times.
pub(super) fn scheduled(_table: &Table<'_>, torque: TorqueModel) -> Result<TorqueModel, FormatError> {
    Ok(torque)
}
