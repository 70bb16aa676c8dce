//! Scenario in symbols, from the formulas of its file.

mod part;
mod shape;
mod value;

use polhode::motion::{Mechanism, Scenario};
use polhode_algebra::{RationalFunction, Vector};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::source::Source;
use polhode_source::toml::symbols::Symbols;
use polhode_source::toml::tree::Entries;
use polhode_source::unit::Dimension;

use crate::symbolic::{Gap, Symbolic, SymbolicBody, SymbolicPendulum, unit};
use value::{Letters, unreadable};

/// Returns a valid scenario in symbols.
///
/// # Errors
/// [`Gap`] if its body is not an exact formula of the symbols.
pub(super) fn symbolic(
    source: Source<'_>,
    entries: &Entries,
    table: &Symbols,
    scenario: &Scenario,
) -> Result<Symbolic, Gap> {
    let root = Table::root(Source { symbols: Some(table), ..source }, entries);
    let written = written(&root);
    let letters = Letters::new(table, &written.iter().map(String::as_str).collect::<Vec<_>>())?;
    if !matches!(scenario.mechanism(), Mechanism::Rotor) || !scenario.wheels().is_empty() {
        let why = "in gimbals, on the ground or with wheels is not derived in symbols";
        return Err(Gap::Kind { what: "a body".to_owned(), why });
    }
    let body = body(&letters, &root)?;
    if body.pivot.is_none() && body.central_terms() > MOST_TERMS {
        let what = "the tensor about the centre of mass".to_owned();
        return Err(Gap::Kind { what, why: "has too many terms; give the body a pivot, or fewer symbols" });
    }
    let massless = || Gap::Differs { what: "the mass".to_owned() };
    let (mass, center) = body.center().ok_or_else(massless)?;
    let tensor = body.tensor_about(body.pivot.as_ref().unwrap_or(&center));
    let mut symbolic = Symbolic {
        symbols: letters.symbols.clone(),
        known: letters.known.clone(),
        pi: letters.pi,
        body,
        mass,
        center,
        tensor,
        omega: None,
        acceleration: None,
        gravity: None,
        pendulum: None,
    };
    check_body(&symbolic, scenario)?;
    let start = root.get("start").and_then(|start| start.table().ok());
    let spin = start.and_then(|start| start.get("spin")).and_then(|spin| spin.table().ok());
    let prescribed = root.get("prescribed").and_then(|value| value.table().ok());
    let omega = match (&prescribed, spin) {
        (Some(table), _) => Some(about_axis(&letters, table, "rate", Dimension::ANGULAR_VELOCITY)),
        (None, Some(spin)) => Some(omega(&letters, &spin)),
        (None, None) => None,
    };
    let computed = scenario.start().omega.to_array();
    symbolic.omega = omega.map(|omega| agreed(&symbolic, omega?, computed, "ω"));
    symbolic.acceleration =
        prescribed.filter(|table| table.get("axis").is_some()).map(|table| match table.get("acceleration") {
            Some(_) => about_axis(&letters, &table, "acceleration", Dimension::ANGULAR_ACCELERATION),
            None => Ok(Vector::zero()),
        });
    symbolic.gravity = gravity(&letters, &root);
    symbolic.pendulum =
        root.get("pendulum").map(|value| pendulum(&letters, &value, symbolic.gravity.clone(), scenario));
    Ok(symbolic)
}

/// Returns the quantities of `[symbols]` as they are written.
fn written(root: &Table<'_>) -> Vec<String> {
    let table = root.get("symbols").and_then(|table| table.table().ok());
    let text = |value: &Value<'_>| {
        value.source().text.get(value.span()).unwrap_or_default().trim_matches(['"', '\'']).to_owned()
    };
    table.map(|table| table.each("symbols").map(|(_, value)| text(&value)).collect()).unwrap_or_default()
}

fn body(letters: &Letters<'_>, root: &Table<'_>) -> Result<SymbolicBody, Gap> {
    let table = root.get("body").and_then(|body| body.table().ok());
    let list = table.as_ref().and_then(|body| body.get("part"));
    let parts = list.map(|list| list.tables("body.part")).and_then(Result::ok).unwrap_or_default();
    let parts = parts.iter().enumerate().map(|(k, table)| part::part(letters, table, k + 1));
    let parts = parts.collect::<Result<Vec<_>, Gap>>()?;
    let of_torque = || {
        let torques = root.get("torque").and_then(|list| list.tables("torque").ok()).unwrap_or_default();
        torques.into_iter().find_map(|torque| torque.get("pivot"))
    };
    let pivot = table.and_then(|body| body.get("pivot")).or_else(of_torque);
    let pivot = pivot.map(|pivot| letters.vector(&pivot, Dimension::LENGTH, || "the pivot".to_owned()));
    Ok(SymbolicBody { parts, pivot: pivot.transpose()? })
}

/// Largest number of terms in a numerator of the tensor about the centre of mass.
const MOST_TERMS: usize = 24;

/// Largest relative difference between a formula and the computed value.
const ROUNDING: f64 = 1e-9;

/// Compares mass, centre and tensor with the computed ones.
fn check_body(symbolic: &Symbolic, scenario: &Scenario) -> Result<(), Gap> {
    let differs = |what: &str| Gap::Differs { what: what.to_owned() };
    let agrees = |formula: &RationalFunction, value: f64, scale: f64| {
        symbolic.evaluate(formula).is_some_and(|x| (x - value).abs() <= ROUNDING * scale)
    };
    let body = scenario.body();
    if !agrees(&symbolic.mass, body.mass(), body.mass()) {
        return Err(differs("the mass"));
    }
    let computed = scenario.rotor().inertia().matrix();
    let size = computed[0][0].max(computed[1][1]).max(computed[2][2]);
    // A length of the size of the body and its distance from the origin.
    let origin = polhode::math::Position::ZERO;
    let length = (body.inertia_about(origin).matrix().iter().enumerate().map(|(k, row)| row[k]).sum::<f64>()
        / body.mass())
    .sqrt();
    let c = body.center_of_mass().to_array();
    if (0..3).any(|k| !agrees(&symbolic.center.0[k], c[k], length)) {
        return Err(differs("the centre of mass"));
    }
    let elements = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    if elements.into_iter().any(|(i, j)| !agrees(&symbolic.tensor.0[i][j], computed[i][j], size)) {
        return Err(differs("the tensor"));
    }
    Ok(())
}

/// Returns a vector if its value is the computed one.
fn agreed(symbolic: &Symbolic, vector: Vector, computed: [f64; 3], what: &str) -> Result<Vector, Gap> {
    let size = computed.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
    let is_same = symbolic
        .evaluate_vector(&vector)
        .is_some_and(|found| (0..3).all(|k| (found[k] - computed[k]).abs() <= ROUNDING * size));
    if is_same { Ok(vector) } else { Err(Gap::Differs { what: what.to_owned() }) }
}

/// Returns ω of `spin = { body = [3] }`.
fn omega(letters: &Letters<'_>, spin: &Table<'_>) -> Result<Vector, Gap> {
    let what = || "ω at the start".to_owned();
    match spin.get("body") {
        Some(given) => letters.vector(&given, Dimension::ANGULAR_VELOCITY, what),
        None => Err(Gap::Kind { what: what(), why: "is not given along body axes" }),
    }
}

/// Returns a rate about the `axis` of a prescribed motion, as a vector.
fn about_axis(
    letters: &Letters<'_>,
    table: &Table<'_>,
    key: &'static str,
    dimension: Dimension,
) -> Result<Vector, Gap> {
    let what = || format!("the {key} of the prescribed motion");
    let (Some(axis), Some(rate)) = (table.get("axis"), table.get(key)) else {
        return Err(Gap::Kind { what: what(), why: "is not one about a fixed axis" });
    };
    let axis = letters.vector(&axis, Dimension::NONE, || "the prescribed axis".to_owned())?;
    let axis = unit(&axis, &letters.symbols)
        .ok_or_else(|| Gap::Kind { what: "the prescribed axis".to_owned(), why: "has no exact length" })?;
    Ok(axis.scaled(&letters.quantity(&rate, dimension, what)?))
}

/// Returns axis and gravity of a pendulum, if the axis is the same in the body and in space.
fn pendulum(
    letters: &Letters<'_>,
    value: &Value<'_>,
    gravity: Option<Result<Vector, Gap>>,
    scenario: &Scenario,
) -> Result<SymbolicPendulum, Gap> {
    let what = || "the axis of the pendulum".to_owned();
    let table = value.table().map_err(|_| unreadable(what()))?;
    let axis = table.get("axis").ok_or_else(|| unreadable(what()))?;
    let axis = letters.vector(&axis, Dimension::NONE, what)?;
    let axis = unit(&axis, &letters.symbols)
        .ok_or_else(|| Gap::Kind { what: what(), why: "has no exact length" })?;
    let in_body = scenario.suspension().and_then(|hanging| hanging.axis.direction());
    let is_fixed = in_body.is_some_and(|n| {
        let turned = (scenario.start().attitude * n).to_array();
        (0..3).all(|k| (turned[k] - n.to_array()[k]).abs() <= ROUNDING)
    });
    if !is_fixed {
        return Err(Gap::Kind { what: what(), why: "is not along the same axes in the body and in space" });
    }
    let gravity = gravity.ok_or_else(|| Gap::Kind {
        what: "the acceleration of gravity".to_owned(),
        why: "is the standard one, and not a formula such as [0, 0, \"-g\"]",
    })??;
    let across = &gravity - &axis.scaled(&axis.dot(&gravity));
    Ok(SymbolicPendulum { gravity: across.dot(&across).square_root(&letters.symbols), axis })
}

/// Returns the acceleration of gravity, if a torque gives it.
fn gravity(letters: &Letters<'_>, root: &Table<'_>) -> Option<Result<Vector, Gap>> {
    let torques = root.get("torque").and_then(|list| list.tables("torque").ok()).unwrap_or_default();
    let given = torques.iter().find_map(|torque| torque.get("acceleration"))?;
    Some(letters.vector(&given, Dimension::ACCELERATION, || "the acceleration of gravity".to_owned()))
}
