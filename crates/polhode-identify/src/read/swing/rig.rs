//! Suspension of a body in a test: rig, placement and fixture.

use polhode::math::{Body, Direction, Position, Rotation, Space};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::number::{Numbers, unit_vector};
use crate::swing::{Air, Axis, Fixture, Linear, Measured, Placement, Rig, SwingTest, Wire, Wires};

const RIGS: [&str; 6] = ["bifilar", "trifilar", "torsion", "wires", "compound", "spindle"];
const COMMON: [&str; 8] = ["name", "comment", "rig", "body", "fixture", "air", "counted", "logged"];
/// Keys for the placement of the body in a rig with wires.
const PLACE: [&str; 3] = ["up", "across", "point"];

/// Reads the rig, and the placement of the body; `None` with `body = false`.
pub(crate) fn rig<'a>(
    test: &Table<'a>,
    name: &str,
    numbers: &mut Numbers<'a>,
) -> Result<(Rig, Option<Placement>), FormatError> {
    let kind = test.require("rig", "rig = \"bifilar\"")?.choice(&RIGS)?;
    let own: &[&'static str] = match kind {
        "bifilar" | "trifilar" => &["radius", "above", "below", "length", "stiffness"],
        "torsion" => &["at", "length", "stiffness"],
        "wires" => &["wires", "stiffness"],
        "compound" => &["axis", "pivot", "edge", "stiffness"],
        _ => &["axis", "pivot", "stiffness"],
    };
    let is_hung = !matches!(kind, "compound" | "spindle");
    let place: &[&'static str] = if is_hung { &PLACE } else { &[] };
    test.allow(&[&COMMON, own, place].concat())?;
    let rig = match kind {
        "bifilar" | "trifilar" => {
            let (above, below) = radii(test, name, numbers)?;
            let length = length(test, name, numbers)?;
            let make = if kind == "bifilar" { Wires::bifilar } else { Wires::trifilar };
            let mut wires: Wires = make(above, below, length);
            wires.stiffness = numbers.or_zero(test, "stiffness", Dimension::STIFFNESS, name)?;
            Rig::Wires(wires)
        }
        "torsion" => {
            let at = test.get("at").map(|at| numbers.point(&at, &format!("{name}: at"))).transpose()?;
            let length = length(test, name, numbers)?;
            Rig::Wires(Wires::torsion(at.unwrap_or_default(), length, stiffness(test, name, numbers)?))
        }
        "wires" => {
            let mut wires = Wires::new(wires(test, name, numbers)?);
            wires.stiffness = numbers.or_zero(test, "stiffness", Dimension::STIFFNESS, name)?;
            Rig::Wires(wires)
        }
        _ => Rig::Axis(axis(test, kind, name, numbers)?),
    };
    let hangs = test.get("body").map_or(Ok(true), |body| body.boolean())?;
    let placement = match (hangs, is_hung) {
        (true, true) => Some(placement(test, kind)?),
        (true, false) => Some(Placement::AS_IT_IS),
        (false, _) => {
            if let Some(value) = PLACE.iter().find_map(|key| test.get(key)) {
                return Err(value.invalid("used in a test with the body; this one has body = false"));
            }
            None
        }
    };
    Ok((rig, placement))
}

fn radii<'a>(
    test: &Table<'a>,
    name: &str,
    numbers: &mut Numbers<'a>,
) -> Result<(Linear, Linear), FormatError> {
    let rule = "wires have either one distance from the middle (radius), or two (above and below)";
    test.at_most_one(&["radius", "above"], rule)?;
    test.at_most_one(&["radius", "below"], rule)?;
    let mut at =
        |value: &Value<'a>| numbers.linear(value, Dimension::LENGTH, &format!("{name}: {}", value.key()));
    if let Some(radius) = test.get("radius") {
        // Above and below share one measured number.
        let radius = at(&radius)?;
        return Ok((radius.clone(), radius));
    }
    match (test.get("above"), test.get("below")) {
        (None, None) => {
            Err(test.missing("radius", "radius = \"r\", with r under [swing.numbers], or \"0.2 m\""))
        }
        (None, Some(_)) => Err(test.missing("above", "above = \"0.2 m\"")),
        (Some(_), None) => Err(test.missing("below", "below = \"0.2 m\"")),
        (Some(above), Some(below)) => Ok((at(&above)?, at(&below)?)),
    }
}

fn length<'a>(table: &Table<'a>, name: &str, numbers: &mut Numbers<'a>) -> Result<Linear, FormatError> {
    let length = table.require("length", "length = \"l\", with l under [swing.numbers], or \"1.5 m\"")?;
    numbers.linear(&length, Dimension::LENGTH, &format!("{name}: length"))
}

fn stiffness<'a>(test: &Table<'a>, name: &str, numbers: &mut Numbers<'a>) -> Result<Linear, FormatError> {
    let stiffness = test.require("stiffness", "stiffness = \"0.012 N m/rad\"")?;
    numbers.linear(&stiffness, Dimension::STIFFNESS, &format!("{name}: stiffness"))
}

/// Reads `wires = [{ top = […], bottom = […], length = … }]`.
fn wires<'a>(test: &Table<'a>, name: &str, numbers: &mut Numbers<'a>) -> Result<Vec<Wire>, FormatError> {
    let all =
        test.require("wires", "wires = [{ top = [0, 0, 1.5], bottom = [0, 0, 0], length = \"1.5 m\" }]")?;
    let each = all.elements("tables: [{ top = [...], bottom = [...], length = ... }]")?;
    if !(1..=3).contains(&each.len()) {
        return Err(all.invalid("1, 2 or 3 wires"));
    }
    let mut wires = Vec::new();
    for (k, wire) in each.iter().enumerate() {
        let table = wire.table()?;
        table.allow(&["top", "bottom", "length"])?;
        let called = format!("{name}: wire {}", k + 1);
        let top =
            numbers.point(&table.require("top", "top = [\"r\", 0, \"1.5 m\"]")?, &format!("{called} top"))?;
        let bottom = table.require("bottom", "bottom = [\"r\", 0, 0]")?;
        let bottom = numbers.point(&bottom, &format!("{called} bottom"))?;
        wires.push(Wire { top, bottom, length: length(&table, &called, numbers)? });
    }
    Ok(wires)
}

/// Reads the axis of a rig whose axes are those of the body.
fn axis<'a>(
    test: &Table<'a>,
    kind: &str,
    name: &str,
    numbers: &mut Numbers<'a>,
) -> Result<Axis, FormatError> {
    let direction: Direction<Space> =
        Direction::from_array(unit_vector(&test.require("axis", "axis = [1, 0, 0], in the body")?)?);
    let pivot = test.require("pivot", "pivot = [0, 0, \"0.25 m\"], a point of the axis in the body")?;
    let pivot = numbers.point(&pivot, &format!("{name}: pivot"))?;
    if kind == "spindle" {
        return Ok(Axis::upright(pivot, direction, stiffness(test, name, numbers)?));
    }
    let edge = numbers.or_zero(test, "edge", Dimension::LENGTH, name)?;
    let stiffness = numbers.or_zero(test, "stiffness", Dimension::STIFFNESS, name)?;
    Ok(Axis::level(pivot, direction).with_edge(edge).with_stiffness(stiffness))
}

/// Reads the placement: `up` and `across` are body directions along the rig's z and x; `point` is
/// the body point at the rig's origin.
fn placement(test: &Table<'_>, kind: &str) -> Result<Placement, FormatError> {
    let up = unit_vector(&test.require("up", "up = [0, 0, 1], the direction in the body that is vertical")?)?;
    let across = match test.get("across") {
        Some(across) => across,
        // About a single wire all horizontal directions are equivalent.
        None if kind == "torsion" && test.get("at").is_none() && test.get("fixture").is_none() => {
            return placed(up, any_across(up), test);
        }
        None => {
            return Err(test.missing(
                "across",
                "across = [1, 0, 0], the direction in the body from the middle to the first wire",
            ));
        }
    };
    let given = unit_vector(&across)?;
    let along: f64 = given.iter().zip(&up).map(|(a, b)| a * b).sum();
    if along.abs() > 1e-6 {
        return Err(across.invalid("perpendicular to up"));
    }
    let x: [f64; 3] = core::array::from_fn(|k| given[k] - along * up[k]);
    placed(up, x, test)
}

/// Returns a vector at right angles to another.
fn any_across([x, y, z]: [f64; 3]) -> [f64; 3] {
    if x.abs() < 0.6 { [0.0, z, -y] } else { [-z, 0.0, x] }
}

fn placed(up: [f64; 3], across: [f64; 3], test: &Table<'_>) -> Result<Placement, FormatError> {
    let n = across.iter().map(|x| x * x).sum::<f64>().sqrt();
    let x = across.map(|c| c / n);
    let y = [up[1] * x[2] - up[2] * x[1], up[2] * x[0] - up[0] * x[2], up[0] * x[1] - up[1] * x[0]];
    let rows = [x, y, up];
    let place = test.get("point");
    let point = place.map_or(Ok([0.0; 3]), |point| point.quantities(Dimension::LENGTH))?;
    let origin = rows.map(|row| -row.iter().zip(&point).map(|(a, b)| a * b).sum::<f64>());
    let rotation: Rotation<Space, Body> = Rotation::from_matrix(rows)
        .map_err(|error| test.error(polhode_source::FormatErrorKind::Rotation(error)))?;
    Ok(Placement { rotation, origin: Position::from_array(origin) })
}

/// Checks that the centre of a body alone on two wires is not significantly above the line of their
/// lower ends; otherwise it turns over.
pub(crate) fn hangs(test: &Table<'_>, made: &SwingTest, center: [Measured; 3]) -> Result<(), FormatError> {
    /// Significance threshold, standard deviations.
    const NO_CHANCE: f64 = 5.0;
    let (Some(placement), None) = (made.body, &made.fixture) else { return Ok(()) };
    let rig = test.require("rig", "rig = \"bifilar\"")?;
    let up = placement.rotation.matrix()[2];
    let height: f64 =
        placement.origin.to_array()[2] + up.iter().zip(&center).map(|(u, c)| u * c.value).sum::<f64>();
    let sd = center.iter().fold(0.0, |most: f64, c| most.max(c.sd));
    if rig.string()? != "bifilar" || height <= 1e-9 + NO_CHANCE * sd {
        return Ok(());
    }
    let place = test.get("point").unwrap_or(rig);
    let rule = format!(
        "such that the body hangs from the two wires: its centre of mass is {:.3} mm above their lower ends",
        1e3 * height
    );
    let hint = "point is the point of the body midway between the lower wire ends, in body axes; up points from the centre of mass towards it";
    Err(place.invalid(rule).with_hint(hint))
}

/// Reads `fixture = { mass, center, moments, products }`, along the axes of the rig.
pub(crate) fn fixture<'a>(
    test: &Table<'a>,
    name: &str,
    numbers: &mut Numbers<'a>,
) -> Result<Option<Fixture>, FormatError> {
    let Some(value) = test.get("fixture") else { return Ok(None) };
    let table = value.table()?;
    table.allow(&["mass", "center", "moments", "products"])?;
    let mass = table.require("mass", "mass = \"0.4 kg\"")?;
    let mass = numbers.linear(&mass, Dimension::MASS, &format!("{name}: fixture mass"))?;
    let center = table.require("center", "center = [0, 0, 0], in the rig")?;
    let center = numbers.point(&center, &format!("{name}: fixture center"))?;
    let mut inertia: [Linear; 6] = Default::default();
    let moments = table.require("moments", "moments = [\"0.002 kg m^2\", \"0.002 kg m^2\", \"platform\"]")?;
    let products = table.get("products");
    let products = products.map_or(Ok(Vec::new()), |p| p.fixed::<3>("moments of inertia").map(Vec::from))?;
    let all = moments.fixed::<3>("moments of inertia")?.into_iter().chain(products);
    for ((slot, element), of) in inertia.iter_mut().zip(all).zip(["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"]) {
        *slot = numbers.linear(&element, Dimension::INERTIA, &format!("{name}: fixture {of}"))?;
    }
    Ok(Some(Fixture { mass, center, inertia }))
}

/// Reads `air = { moment, displaced }`.
pub(crate) fn air<'a>(test: &Table<'a>, name: &str, numbers: &mut Numbers<'a>) -> Result<Air, FormatError> {
    let Some(value) = test.get("air") else { return Ok(Air::default()) };
    let table = value.table()?;
    table.allow(&["moment", "displaced"])?;
    if table.get("moment").or_else(|| table.get("displaced")).is_none() {
        return Err(table.missing("moment", "moment = \"1e-5 kg m^2\", or displaced = \"2 g\""));
    }
    if let (Some(displaced), "spindle") = (table.get("displaced"), test.require("rig", "")?.string()?) {
        return Err(displaced.invalid("omitted: the weight has no effect on the swing about a vertical axis"));
    }
    let name = format!("{name}: air");
    Ok(Air {
        moment: numbers.or_zero(&table, "moment", Dimension::INERTIA, &name)?,
        displaced: numbers.or_zero(&table, "displaced", Dimension::MASS, &name)?,
    })
}
