//! `[shaft]`: a body that rotates in two bearings.

use polhode::math::{Acceleration, Direction, Position};
use polhode::motion::{MountedShaft, Scenario, Shaft};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::start::Start;

/// Reads `[shaft]`: the body has a pivot on the axis, and rotates about it as a prescribed motion.
pub(crate) fn shaft(
    root: &Table<'_>,
    start: &Start<'_>,
    scenario: Scenario,
) -> Result<Scenario, FormatError> {
    let Some(value) = root.get("shaft") else { return Ok(scenario) };
    let table = value.table()?;
    table.allow(&["axis", "point", "bearings", "rate", "acceleration", "gravity", "balance"])?;
    if let Some(spin) = &start.spin {
        return Err(spin
            .invalid("left out, since the shaft rotates at its rate")
            .with_hint("leave out spin"));
    }
    if scenario.pivot().is_some() {
        let rule = "given without a pivot of the body: the bearings hold the shaft";
        return Err(value.invalid(rule).with_hint("leave out pivot: the shaft's point holds the body"));
    }
    if start.velocity.is_some()
        && let Some(velocity) = root.get("start").and_then(|start| start.table().ok()?.get("velocity"))
    {
        let rule = "left out, since the bearings hold the body";
        return Err(velocity.invalid(rule).with_hint("a shaft only rotates"));
    }
    let axis = table.require("axis", "axis = [0, 0, 1]")?;
    let point = table.get("point").map_or(Ok([0.0; 3]), |point| point.quantities(Dimension::LENGTH))?;
    let point = Position::from_array(point);
    let bearings = table.require("bearings", "bearings = [\"-0.1 m\", \"0.3 m\"]")?;
    let places = bearings.quantities(Dimension::LENGTH)?;
    let direction = Direction::from_array(axis.numbers()?);
    if direction.direction().is_none() {
        let rule = "a direction: finite and not zero";
        return Err(axis.invalid(rule).with_hint("the z axis is [0, 0, 1]; its length does not matter"));
    }
    let shaft =
        Shaft::new(*scenario.body(), point, direction, places).map_err(|error| bearings.motion(error))?;
    let rate = table.require("rate", "rate = \"3000 rpm\"")?.quantity(Dimension::ANGULAR_VELOCITY)?;
    let acceleration = table.get("acceleration");
    let acceleration = acceleration.map_or(Ok(0.0), |a| a.quantity(Dimension::ANGULAR_ACCELERATION))?;
    let gravity = table.get("gravity").map_or(Ok([0.0; 3]), |g| g.quantities(Dimension::ACCELERATION))?;
    let balance = table.get("balance").map_or(Ok(Vec::new()), |value| balance(&value, &shaft))?;
    let gravity = Acceleration::from_array(gravity);
    let mounted = MountedShaft { shaft, rate, acceleration, gravity, balance };
    scenario.mounted(mounted).map_err(|error| axis.motion(error))
}

/// Reads `balance = { planes = [one or two], radii = [as many] }`; returns each plane, m, with its
/// radius, m.
fn balance(value: &Value<'_>, shaft: &Shaft) -> Result<Vec<[f64; 2]>, FormatError> {
    let table = value.table()?;
    table.allow(&["planes", "radii"])?;
    let planes = table.require("planes", "planes = [0, \"0.2 m\"]")?;
    let radii = table.require("radii", "radii = [\"50 mm\", \"50 mm\"]")?;
    let places = planes.elements("an array of one or two lengths")?;
    let sizes = radii.elements("an array of one or two lengths")?;
    if !(1..=2).contains(&places.len()) {
        let rule = "one plane, or two";
        return Err(planes
            .invalid(rule)
            .with_hint("one plane corrects the static unbalance, two planes the whole unbalance"));
    }
    if sizes.len() != places.len() {
        return Err(radii.invalid("as many as there are planes").with_hint("each plane has its radius"));
    }
    let read = |(place, size): (&Value<'_>, &Value<'_>)| {
        Ok([place.quantity(Dimension::LENGTH)?, size.positive(Dimension::LENGTH)?])
    };
    let pairs: Vec<[f64; 2]> = places.iter().zip(&sizes).map(read).collect::<Result<_, FormatError>>()?;
    MountedShaft::corrections(shaft, &pairs).map_err(|error| planes.motion(error))?;
    Ok(pairs)
}
