//! Ground of a contact, and the point of it that is touched at the start.

use polhode::math::{Acceleration, Direction, Position, Space};
use polhode::motion::contact::{Ground, GroundShape, GroundSide};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::all_keys;

const COMMON: [&str; 2] = ["shape", "rate"];

/// Shapes of the ground, each with its own keys.
const SHAPES: [(&str, &[&str]); 3] = [
    ("plane", &["normal", "slope"]),
    ("sphere", &["radius", "side", "axis"]),
    ("cylinder", &["radius", "side", "axis"]),
];

/// Reads `{ shape = "plane", slope = "10 deg", rate = "3 rad/s" }`; without it, returns a level
/// plane.
pub(crate) fn ground(value: Option<&Value<'_>>) -> Result<Ground, FormatError> {
    let Some(value) = value else { return Ok(Ground::LEVEL) };
    let table = value.table()?;
    if table.get("shape").is_none() {
        table.allow(&all_keys(&COMMON, &SHAPES))?;
    }
    let named = table.get("shape").map(|shape| shape.choice(&SHAPES.map(|(name, _)| name))).transpose()?;
    let kind = named.unwrap_or("plane");
    let own = SHAPES.iter().find(|(name, _)| *name == kind).map_or(&[][..], |(_, keys)| keys);
    let keys: Vec<_> = COMMON.iter().chain(own).copied().collect();
    let table = table.called(format!("a ground of shape \"{kind}\""));
    table.allow(&keys)?;
    let shape = match kind {
        "plane" => GroundShape::Plane,
        _ => {
            let radius = table.require("radius", "radius = \"0.5 m\"")?.positive(Dimension::LENGTH)?;
            let side = match table.require("side", "side = \"inside\"")?.choice(&["inside", "outside"])? {
                "inside" => GroundSide::Inside,
                _ => GroundSide::Outside,
            };
            if kind == "sphere" {
                GroundShape::Sphere { radius, side }
            } else {
                GroundShape::Cylinder { radius, side }
            }
        }
    };
    let ground = Ground::new(shape, axis(&table, kind)?).map_err(|error| value.motion(error))?;
    let Some(rate) = table.get("rate") else { return Ok(ground) };
    ground.turning_at(rate.quantity(Dimension::ANGULAR_VELOCITY)?).map_err(|error| rate.motion(error))
}

/// Returns the normal of a plane; else the axis, which is required for a cylinder, and is the
/// rotation axis of a sphere.
fn axis(table: &Table<'_>, kind: &str) -> Result<Direction<Space>, FormatError> {
    let given = table.at_most_one(&["normal", "slope"], "both define the inclination of the plane")?;
    let given = match kind {
        "cylinder" => Some(table.require("axis", "axis = [0, 1, 0]")?),
        "sphere" => table.get("axis"),
        _ => given,
    };
    let Some(given) = given else { return Ok(Direction::new(0.0, 0.0, 1.0)) };
    if given.key() == "slope" {
        let slope = given.quantity(Dimension::ANGLE)?;
        if slope.abs() >= std::f64::consts::FRAC_PI_2 {
            return Err(given
                .invalid("between -90 and 90 deg")
                .with_hint("the plane descends towards +x; for other directions write normal = [0, 0, 1]"));
        }
        return Ok(Direction::new(slope.sin(), 0.0, slope.cos()));
    }
    let axis = Direction::from_array(given.numbers()?);
    axis.direction().ok_or_else(|| given.invalid("a direction: finite and not zero"))
}

/// Returns the point touched at the start: `at`, else the origin of a plane, the lowest point of a
/// bowl or trough, or the highest point of ground touched from outside.
pub(crate) fn touched(
    table: &Table<'_>,
    ground: &Ground,
    gravity: Acceleration<Space>,
) -> Result<Position<Space>, FormatError> {
    if let Some(at) = table.get("at") {
        return Ok(Position::from_array(at.quantities(Dimension::LENGTH)?));
    }
    let gravity = Direction::from_array(gravity.to_array());
    let (radius, side, down) = match *ground.shape() {
        GroundShape::Sphere { radius, side } => (radius, side, gravity),
        GroundShape::Cylinder { radius, side } => {
            (radius, side, gravity - ground.axis() * ground.axis().dot(gravity))
        }
        _ => return Ok(Position::ZERO),
    };
    let Some(down) = down.direction() else {
        let error = table.missing("at", "at = [\"0 m\", \"0 m\", \"-0.5 m\"]");
        return Err(error.with_hint("gravity does not determine the lowest point of the ground: write at"));
    };
    let reach = if side == GroundSide::Inside { radius } else { -radius };
    Ok(Position::from_array((down * reach).to_array()))
}
