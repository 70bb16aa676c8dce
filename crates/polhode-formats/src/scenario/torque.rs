//! The `[[torque]]`s.

use polhode::{Acceleration, ConstantTorque, Torque, TorqueModel, UniformGravity};

use super::body::Pivot;
use super::reader::{Table, Value};
use crate::error::FormatError;
use crate::unit::Dimension;

/// Reads all torques; gravity may bring the pivot with it, or repeat it.
pub(crate) fn torques<'a>(
    root: &Table<'a>,
    pivot: &mut Option<Pivot<'a>>,
) -> Result<Vec<TorqueModel>, FormatError> {
    let Some(list) = root.get("torque") else { return Ok(Vec::new()) };
    let mut models = Vec::new();
    for table in list.tables("torque")? {
        let name = table.require("model", "model = \"gravity\"")?.choice(&["constant", "gravity"])?;
        let table = table.called(format!("[[torque]] of model \"{name}\""));
        models.push(match name {
            "constant" => constant(&table)?,
            _ if models.iter().any(|model| matches!(model, TorqueModel::Gravity(_))) => {
                let rule = "given once for gravity";
                return Err(table.require("model", "")?.invalid(rule).with_hint("add the accelerations"));
            }
            _ => gravity(&table, pivot)?,
        });
    }
    Ok(models)
}

/// `axes = "body" | "space"`, `torque = [3]`
fn constant(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    table.allow(&["model", "axes", "torque"])?;
    let axes = table.require("axes", "axes = \"body\"")?.choice(&["body", "space"])?;
    let torque = table.require("torque", "torque = [\"0 N m\", \"0 N m\", \"0.1 N m\"]")?;
    let torque = torque.quantities(Dimension::TORQUE)?;
    Ok(TorqueModel::Constant(match axes {
        "body" => ConstantTorque::Body(Torque::from_array(torque)),
        _ => ConstantTorque::Space(Torque::from_array(torque)),
    }))
}

/// `pivot = [3]` in the body; `acceleration = [3]` in space, standard gravity along −z by default.
fn gravity<'a>(table: &Table<'a>, pivot: &mut Option<Pivot<'a>>) -> Result<TorqueModel, FormatError> {
    table.allow(&["model", "pivot", "acceleration"])?;
    match (table.get("pivot"), pivot.as_ref()) {
        (None, Some(_)) => {}
        (None, None) => return Err(no_pivot(table)),
        (Some(value), None) => *pivot = Some(Pivot::read(value)?),
        (Some(value), Some(held)) => agree(&value, held)?,
    }
    let gravity = match table.get("acceleration") {
        None => UniformGravity::STANDARD,
        Some(g) => {
            UniformGravity { acceleration: Acceleration::from_array(g.quantities(Dimension::ACCELERATION)?) }
        }
    };
    Ok(TorqueModel::Gravity(gravity))
}

fn no_pivot(table: &Table<'_>) -> FormatError {
    let hint = "uniform gravity does not turn a free body: write pivot = [\"0 mm\", \"0 mm\", \"0 mm\"], a point of the body";
    table.missing("pivot", "").with_hint(hint)
}

fn agree(value: &Value<'_>, held: &Pivot<'_>) -> Result<(), FormatError> {
    if Pivot::read(*value)?.point == held.point {
        return Ok(());
    }
    let place = held.value.place();
    let rule = format!("the pivot of line {}: a body is held at one point", place.line);
    Err(value.invalid(rule).with_hint("leave one of them out"))
}
