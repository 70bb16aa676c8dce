//! `[[torque]]` of model `formula`.

use polhode::math::formula::Formula;
use polhode::motion::torque::{FormulaTorque, TorqueModel};
use polhode_source::FormatError;
use polhode_source::expression::{formula_of_state, formula_of_state_in_si};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::allow;

/// Reads `axes = "body" | "space"`, `torque = [3]` of formulas, `units = "checked" | "SI"`.
pub(crate) fn formula(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["axes", "torque", "units"])?;
    let units = table.get("units").map(|units| units.choice(&["checked", "SI"])).transpose()?;
    let component = if units == Some("SI") { component_in_si } else { component };
    let axes = table.require("axes", "axes = \"body\"")?.choice(&["body", "space"])?;
    let torque =
        table.require("torque", "torque = [\"-0.3[N m s]*wx\", \"0\", \"2[mN m]*sin(1[rad/s]*t)\"]")?;
    let [x, y, z] = torque.fixed("formulas")?;
    let components = [component(&x)?, component(&y)?, component(&z)?];
    Ok(TorqueModel::Formula(Box::new(match axes {
        "body" => FormulaTorque::Body(components),
        _ => FormulaTorque::Space(components),
    })))
}

/// Reads a formula with all numbers in SI.
fn component_in_si(value: &Value<'_>) -> Result<Formula, FormatError> {
    match value.string() {
        Ok(text) => formula_of_state_in_si(text).map_err(|error| value.formula(error)),
        Err(_) => value.quantity(Dimension::TORQUE).map(Formula::constant),
    }
}

/// Reads a formula with the dimension of a torque; a plain number is a torque in SI.
fn component(value: &Value<'_>) -> Result<Formula, FormatError> {
    match value.string() {
        Ok(text) => {
            let formula = formula_of_state(text, Some(Dimension::TORQUE));
            formula.map(|(formula, _)| formula).map_err(|error| value.formula(error))
        }
        Err(_) => value.quantity(Dimension::TORQUE).map(Formula::constant),
    }
}
