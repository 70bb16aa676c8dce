//! `[[torque]]` of model `thruster`.

use polhode::math::{Force, Position};
use polhode::motion::torque::{Thruster, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::unit::Dimension;

use super::allow;

/// Reads `position = [3]` and `force = [3]`, both along body axes.
pub(crate) fn thruster(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["position", "force"])?;
    let position = table.require("position", "position = [\"0.5 m\", \"0 m\", \"-0.3 m\"]")?;
    let force = table.require("force", "force = [\"0 N\", \"1 N\", \"0 N\"]")?;
    Ok(TorqueModel::Thruster(Thruster {
        position: Position::from_array(position.quantities(Dimension::LENGTH)?),
        force: Force::from_array(force.quantities(Dimension::FORCE)?),
    }))
}
