//! A constant `[[torque]]`.

use polhode::math::Torque;
use polhode::motion::torque::{ConstantTorque, TorqueModel};

use super::allow;
use crate::error::FormatError;
use crate::scenario::reader::Table;
use crate::unit::Dimension;

/// `axes = "body" | "space"`, `torque = [3]`
pub(super) fn constant(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["axes", "torque"])?;
    let axes = table.require("axes", "axes = \"body\"")?.choice(&["body", "space"])?;
    let torque = table.require("torque", "torque = [\"0 N m\", \"0 N m\", \"0.1 N m\"]")?;
    let torque = torque.quantities(Dimension::TORQUE)?;
    Ok(TorqueModel::Constant(match axes {
        "body" => ConstantTorque::Body(Torque::from_array(torque)),
        _ => ConstantTorque::Space(Torque::from_array(torque)),
    }))
}
