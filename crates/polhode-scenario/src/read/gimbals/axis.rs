//! One axis of the gimbals: initial angle and rate, constraint, and torques.

use polhode::motion::gimbal::{Axis, Spring};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Keys of an axis.
pub(crate) const KEYS: [&str; 8] =
    ["angle", "rate", "locked", "driven", "damping", "spring", "rest", "torque"];

/// Reads `{ angle = "10 deg", rate = "2 deg/s", damping = "0.1 N m s/rad", spring = "2 N m/rad",
/// rest = "5 deg", torque = "3 N m" }`, or `locked = true` or `driven = true` with the angle and
/// rate.
pub(crate) fn axis(value: &Value<'_>, table: &Table<'_>) -> Result<Axis, FormatError> {
    let quantity = |key, dimension| table.get(key).map_or(Ok(0.0), |value| value.quantity(dimension));
    let angle = quantity("angle", Dimension::ANGLE)?;
    let rate = quantity("rate", Dimension::ANGULAR_VELOCITY)?;
    let axis = match held(table)? {
        Some("locked") => Axis::locked(angle),
        Some(_) => Axis::driven(angle, rate),
        None => Axis::free(angle, rate),
    };
    let mut axis = axis.map_err(|error| value.motion(error))?;
    if let Some(damping) = table.get("damping") {
        let number = damping.quantity(Dimension::DRAG)?;
        axis = axis.damped(number).map_err(|error| damping.motion(error))?;
    }
    if let Some(spring) = table.get("spring") {
        let (stiffness, rest) = (spring.positive(Dimension::STIFFNESS)?, quantity("rest", Dimension::ANGLE)?);
        axis = axis.sprung(Spring { stiffness, rest }).map_err(|error| spring.motion(error))?;
    } else if let Some(rest) = table.get("rest") {
        let hint =
            "rest is the angle of zero spring torque, so it needs a spring: write spring = \"2 N m/rad\"";
        return Err(rest.invalid("left out without spring").with_hint(hint));
    }
    let Some(torque) = table.get("torque") else { return Ok(axis) };
    axis.turned_by(torque.quantity(Dimension::TORQUE)?).map_err(|error| torque.motion(error))
}

/// Returns `locked` or `driven`, if one of these is set.
fn held(table: &Table<'_>) -> Result<Option<&'static str>, FormatError> {
    let keys = ["locked", "driven"];
    let Some(held) = table.at_most_one(&keys, "a lock fixes the angle of an axis; a motor fixes its rate")?
    else {
        return Ok(None);
    };
    if !held.boolean()? {
        return Ok(None);
    }
    let still = [
        ("rate", "leave out rate; or write driven = true for locked = true: a motor keeps the rate constant"),
        ("damping", "leave out damping"),
    ];
    for (key, hint) in still {
        if let Some(idle) = table.get(key).filter(|_| held.key() == "locked") {
            return Err(idle.invalid("left out with locked = true: the axis does not turn").with_hint(hint));
        }
    }
    if held.key() == "driven" {
        table.require("rate", "rate = \"24000 rpm\"")?;
    }
    Ok(Some(held.key()))
}
