//! `[[torque]]` of model `gravity_gradient`.

use polhode::body::BodyPart;
use polhode::motion::Orbit;
use polhode::motion::torque::{Attracted, GravityGradient, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;

use super::allow;
use crate::read::body::Pivot;
use crate::read::orbit;

/// Reads `mass = "tensor" | "points"`, the latter for a body of particles only; requires an
/// `[orbit]`.
pub(crate) fn gravity_gradient(
    table: &Table<'_>,
    parts: &[BodyPart],
    orbit: Option<&Orbit>,
) -> Result<TorqueModel, FormatError> {
    allow(table, &["mass"])?;
    let orbit = orbit::require(table, orbit)?.clone();
    let attracted = match table.get("mass") {
        Some(mass) if mass.choice(&["tensor", "points"])? == "points" => {
            if parts.iter().any(|part| part.particles.is_empty()) {
                let rule = "\"tensor\", since not every part of the body is particles";
                return Err(mass.invalid(rule).with_hint("the sum over points needs shape = \"particles\""));
            }
            Attracted::Points(parts.iter().flat_map(|part| part.particles.iter().copied()).collect())
        }
        _ => Attracted::Tensor,
    };
    Ok(TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted })))
}

/// Refuses this model together with a pivot, because it applies to a free body in orbit.
pub(crate) fn refuse_pivot(table: &Table<'_>, pivot: &Pivot<'_>) -> Result<(), FormatError> {
    match table.get("model") {
        Some(model) if model.string()? == "gravity_gradient" => {
            let line = pivot.value.place().line;
            let rule = format!("left out, since line {line} holds the body at a pivot");
            Err(model.invalid(rule).with_hint("a body on an orbit is free: leave out the pivot"))
        }
        _ => Ok(()),
    }
}
