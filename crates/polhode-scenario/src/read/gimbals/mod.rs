//! `[gimbals]`: a rotor in two gimbals, on a base that may rotate.

mod axis;

use polhode::math::{Acceleration, AngularVelocity, Direction, Position};
use polhode::motion::gimbal::{Axis, Base, Gimbal, Gimbals};
use polhode::motion::{Method, MotionError, Scenario};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::tensor;

/// Keys of a gimbal's inertia, in addition to those of its axis.
const MASS: [&str; 6] = tensor::KEYS;

/// Reads `[gimbals]`, if present, and mounts the scenario's body in them; `pivot` is the value of a
/// pivot, if there is one.
pub(crate) fn gimbals(
    root: &Table<'_>,
    scenario: Scenario,
    pivot: Option<Value<'_>>,
) -> Result<Scenario, FormatError> {
    const KEYS: [&str; 9] =
        ["outer_axis", "inner_axis", "rotor_axis", "crossing", "outer", "inner", "rotor", "base", "gravity"];
    let Some(value) = root.get("gimbals") else { return Ok(scenario) };
    let table = value.table()?;
    table.allow(&KEYS)?;
    if let Some(pivot) = pivot {
        let hint = "gimbals hold the body at the intersection of their axes: write crossing under [gimbals]";
        return Err(pivot.invalid("left out with [gimbals]").with_hint(hint));
    }
    let [outer_axis, inner_axis] = [
        direction(&table.require("outer_axis", "outer_axis = [0, 0, 1]")?)?,
        direction(&table.require("inner_axis", "inner_axis = [1, 0, 0]")?)?,
    ];
    let [outer, inner] = ["outer", "inner"].map(|key| table.get(key));
    let (outer_held, outer) = of_gimbal(outer)?;
    let (inner_held, inner) = of_gimbal(inner)?;
    let rotor = match table.get("rotor") {
        Some(rotor) => {
            let keys = rotor.table()?;
            keys.allow(&axis::KEYS)?;
            axis::axis(&rotor, &keys)?
        }
        None => Axis::FREE,
    };
    let inner_place = table.get("inner_axis").unwrap_or(value);
    let gimbals = Gimbals::new(outer_axis, inner_axis, [outer_held, inner_held, rotor])
        .map_err(|error| inner_place.motion(error).with_hint("it is defined with all angles at zero"))?;
    let crossing = match table.get("crossing") {
        Some(crossing) => Position::from_array(crossing.quantities(Dimension::LENGTH)?),
        None => scenario.body().center_of_mass(),
    };
    let rotor_axis =
        table.get("rotor_axis").map_or(Ok(Direction::new(0.0, 0.0, 1.0)), |axis| direction(&axis))?;
    let gravity = match table.get("gravity") {
        Some(gravity) => Acceleration::from_array(gravity.quantities(Dimension::ACCELERATION)?),
        None => Acceleration::new(0.0, 0.0, -9.806_65),
    };
    let base = table.get("base").map_or(Ok(Base::FIXED), |base| base_of(&base))?;
    let gimbals = gimbals
        .holding(crossing, rotor_axis)
        .and_then(|gimbals| gimbals.with_mass(outer, inner).with_base(base).with_gravity(gravity))
        .map_err(|error| value.motion(error))?;
    let method = scenario.run().map_or(Method::Auto, |run| run.method);
    if !matches!(method, Method::Auto | Method::Taylor) {
        let run = root.get("run").map(|run| run.table()).transpose()?;
        let value = run.and_then(|run| run.get("method")).unwrap_or(value);
        return Err(value.invalid("\"auto\" or \"taylor\": a rotor in gimbals is computed by Taylor series"));
    }
    scenario.in_gimbals(gimbals).map_err(|error| refused(&value, &table, error))
}

/// Returns an error of the core at the key that causes it.
fn refused(value: &Value<'_>, table: &Table<'_>, error: MotionError) -> FormatError {
    let (key, inside, hint) = match &error {
        MotionError::ParameterOutOfRange { parameter: "the angle of the inner gimbal", .. } => (
            "inner",
            "angle",
            "start at another angle, or give the outer gimbal an inertia: moments = [\"1e-4 kg m^2\", \"1e-4 kg m^2\", \"1e-4 kg m^2\"]",
        ),
        MotionError::NonPositiveParameter {
            parameter: "the moment of inertia about the outer axis", ..
        } => ("outer", "moments", "give the body or the gimbal an extent, or lock the axis"),
        MotionError::NonPositiveParameter {
            parameter: "the moment of inertia about the inner axis", ..
        } => ("inner", "moments", "give the body or the gimbal an extent, or lock the axis"),
        MotionError::NonPositiveParameter {
            parameter: "the moment of inertia about the rotor's axis",
            ..
        } => ("rotor_axis", "", "give the body a thickness, or lock or drive the rotor"),
        _ => return value.motion(error),
    };
    let at = table.get(key);
    let inside = at.and_then(|at| at.table().ok()?.get(inside)).or(at);
    inside.unwrap_or(*value).motion(error).with_hint(hint)
}

fn direction<F>(value: &Value<'_>) -> Result<Direction<F>, FormatError> {
    let axis = Direction::from_array(value.numbers()?);
    axis.direction().ok_or_else(|| value.invalid("a direction: finite and not zero"))
}

/// Reads the axis and the inertia of a gimbal.
fn of_gimbal(value: Option<Value<'_>>) -> Result<(Axis, Gimbal), FormatError> {
    let Some(value) = value else { return Ok((Axis::FREE, Gimbal::MASSLESS)) };
    let table = value.table()?;
    table.allow(&[&axis::KEYS[..], &MASS].concat())?;
    let held = axis::axis(&value, &table)?;
    let gimbal = match MASS.iter().find_map(|key| table.get(key)) {
        None => Gimbal::MASSLESS,
        Some(_) if ["mass", "center_of_mass", "about"].iter().any(|key| table.get(key).is_some()) => {
            Gimbal::pendulous(&tensor::mass_properties(&table)?)
        }
        Some(_) => Gimbal::balanced(&tensor::tensor(&table)?),
    };
    Ok((held, gimbal))
}

/// Reads `{ latitude = "52 deg" }`, the Earth's rotation there, or `{ rate = [3] }`.
fn base_of(value: &Value<'_>) -> Result<Base, FormatError> {
    let table = value.table()?;
    table.allow(&["latitude", "rate"])?;
    let Some(given) = table.at_most_one(&["latitude", "rate"], "both define the rotation of the base")?
    else {
        return Err(table.missing("latitude", "latitude = \"52 deg\""));
    };
    let base = match given.key() {
        "latitude" => Base::on_earth(given.quantity(Dimension::ANGLE)?),
        _ => Base::turning(AngularVelocity::from_array(given.quantities(Dimension::ANGULAR_VELOCITY)?)),
    };
    base.map_err(|error| given.motion(error))
}
