//! The `[[torque]]`s: one file per model.

mod constant;
mod drag;
mod energy_sink;
mod formula;
mod gravity;
mod gravity_gradient;
mod magnetic;
mod orbit;
mod schedule;
mod thruster;
mod torsion;

use polhode::{BodyPart, TorqueModel};

use super::body::Pivot;
use super::reader::Table;
use crate::error::FormatError;

/// The models, as a file names them.
const MODELS: [&str; 9] = [
    "constant",
    "gravity",
    "gravity_gradient",
    "drag",
    "torsion",
    "magnetic",
    "thruster",
    "energy_sink",
    "formula",
];

/// Reads all torques on a body of these parts; gravity may bring the pivot with it, or repeat it.
pub(crate) fn torques<'a>(
    root: &Table<'a>,
    parts: &[BodyPart],
    pivot: &mut Option<Pivot<'a>>,
) -> Result<Vec<TorqueModel>, FormatError> {
    let Some(list) = root.get("torque") else { return Ok(Vec::new()) };
    let mut models = Vec::new();
    for table in list.tables("torque")? {
        let name = table.require("model", "model = \"gravity\"")?.choice(&MODELS)?;
        let table = table.called(format!("[[torque]] of model \"{name}\""));
        let model = match name {
            "constant" => constant::constant(&table)?,
            "gravity_gradient" => gravity_gradient::gravity_gradient(&table, parts)?,
            "drag" => drag::drag(&table)?,
            "torsion" => torsion::torsion(&table)?,
            "magnetic" => magnetic::magnetic(&table)?,
            "thruster" => thruster::thruster(&table)?,
            "energy_sink" => energy_sink::energy_sink(&table)?,
            "formula" => formula::formula(&table)?,
            _ if models.iter().any(|model| matches!(model, TorqueModel::Gravity(_))) => {
                let rule = "given once for gravity";
                return Err(table.require("model", "")?.invalid(rule).with_hint("add the accelerations"));
            }
            _ => gravity::gravity(&table, pivot)?,
        };
        models.push(schedule::scheduled(&table, model)?);
    }
    if let Some(pivot) = pivot {
        list.tables("torque")?.iter().try_for_each(|table| gravity_gradient::refuse_pivot(table, pivot))?;
    }
    Ok(models)
}

/// Refuses keys that are neither a model's own nor every torque's.
fn allow(table: &Table<'_>, own: &[&'static str]) -> Result<(), FormatError> {
    let keys: Vec<&'static str> = ["model"].iter().chain(own).chain(&schedule::KEYS).copied().collect();
    table.allow(&keys)
}
