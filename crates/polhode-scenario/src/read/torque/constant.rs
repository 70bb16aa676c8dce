//! `[[torque]]` of model `constant`.

use polhode::math::Torque;
use polhode::motion::torque::{ConstantTorque, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::unit::Dimension;

use super::allow;

/// Reads `axes = "body" | "space"`, `torque = [3]`.
pub(crate) fn constant(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["axes", "torque"])?;
    let axes = table.require("axes", "axes = \"body\"")?.choice(&["body", "space"])?;
    let torque = table.require("torque", "torque = [\"0 N m\", \"0 N m\", \"0.1 N m\"]")?;
    let torque = torque.quantities(Dimension::TORQUE)?;
    Ok(TorqueModel::Constant(match axes {
        "body" => ConstantTorque::Body(Torque::from_array(torque)),
        _ => ConstantTorque::Space(Torque::from_array(torque)),
    }))
}
