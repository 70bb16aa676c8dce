//! Places in the file for errors of the core about a body on the ground.

use polhode::motion::contact::StartVelocity;
use polhode::motion::{Event, Measure, MotionError};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};

use super::OnGround;

/// Parameter name in the core, table and key in the file, and advice.
const PLACES: [(&str, &str, &str, &str); 17] = [
    (
        "the height of the point of contact above the ground",
        "contact",
        "at",
        "at must be a point of the ground: on a plane n · x = 0; on a sphere or cylinder at its radius",
    ),
    ("the point of contact from the axis of the ground", "contact", "at", ""),
    ("the point of contact", "contact", "at", ""),
    ("the velocity of the centre of mass along the normal", "start", "velocity", ALONG_THE_GROUND),
    ("the velocity of the centre of mass", "start", "velocity", ""),
    (
        "the slip at the start",
        "start",
        "velocity",
        "a rolling body does not slip: leave out velocity, or write law = \"friction\" for a slipping body",
    ),
    ("the least principal moment about the centre of mass", "body", "part", "give the body a thickness"),
    (
        "the distance of the centre of mass from the centre of the surface",
        "contact",
        "surface",
        "its position is the position of its centre, in body axes",
    ),
    ("the radius of the ground", "contact", "ground", ""),
    (
        "the tilt of the disk",
        "start",
        "attitude",
        "tilt it: attitude = { axis = [1, 0, 0], angle = \"80 deg\" }",
    ),
    ("the angular velocity of a cylinder across its axis", "start", "spin", ""),
    (
        "the tilt of a lying cylinder",
        "start",
        "attitude",
        "the z axis of the surface is the cylinder axis: attitude = { axis = [1, 0, 0], angle = \"90 deg\" } lays it along y",
    ),
    ("the angle between two touching cylinders", "start", "attitude", ""),
    ("the ground of a lying cylinder", "contact", "ground", ""),
    (
        "the products of inertia with the axis of a cylinder",
        "contact",
        "surface",
        "rotate the surface onto a principal axis",
    ),
    (
        "the rate of the ground below a lying cylinder",
        "contact",
        "ground",
        "a sphere may lie on rotating ground",
    ),
    ("the lever of pivoting friction", "contact", "pivoting_friction", ""),
];

const ALONG_THE_GROUND: &str =
    "the component along the normal follows from the spin: give the velocity along the ground";

impl OnGround<'_> {
    /// Returns an error of the core at the key that causes it.
    pub(crate) fn refused(&self, error: MotionError, events: &[Event]) -> FormatError {
        let parameter = match &error {
            MotionError::ParameterOutOfRange { parameter, .. }
            | MotionError::NonFiniteParameter { parameter, .. }
            | MotionError::NoDirection { parameter, .. } => *parameter,
            MotionError::Exclusive { parts: ["contact", "event"], .. } => {
                return self.event(events).unwrap_or(self.value).motion(error);
            }
            _ => return self.value.motion(error),
        };
        if parameter == "the rate of rolling" {
            let value = self.table.get("rolling_friction").unwrap_or(self.value);
            return value
                .motion(error)
                .with_hint("give the body a spin that agrees with rolling, or leave it out");
        }
        let Some((_, table, key, hint)) = PLACES.iter().find(|(name, ..)| *name == parameter) else {
            return self.value.motion(error);
        };
        let placed = self.at(table, key).unwrap_or(self.value).motion(error);
        if *hint == ALONG_THE_GROUND
            && let Some([x, y, z]) = self.along_the_ground()
        {
            return placed.with_hint(format!("{hint}, velocity = [{x:?}, {y:?}, {z:?}]"));
        }
        if hint.is_empty() { placed } else { placed.with_hint(*hint) }
    }

    /// Returns the component of the initial velocity along the ground, m/s, space axes: v − (v · n)
    /// n.
    fn along_the_ground(&self) -> Option<[f64; 3]> {
        let StartVelocity::Along(velocity) = self.ground.velocity else { return None };
        let normal = self.ground.contact.ground.normal_at(self.ground.at)?;
        let (v, n, across) = (velocity.to_array(), normal.to_array(), velocity.dot(normal));
        // Rounding errors of the difference are set to zero.
        let rounding = 4.0 * f64::EPSILON * velocity.norm();
        Some([0, 1, 2].map(|k| v[k] - across * n[k]).map(|x| if x.abs() <= rounding { 0.0 } else { x }))
    }

    /// Returns the value of a key in a table of the file; the table itself if it has no such key.
    fn at(&self, table: &'static str, key: &'static str) -> Option<Value<'_>> {
        let value = self.root.get(table)?;
        let inside = value.table().ok().and_then(|table: Table<'_>| table.get(key));
        Some(inside.unwrap_or(value))
    }

    /// Returns the first event that is not supported for a body on the ground.
    fn event(&self, events: &[Event]) -> Option<Value<'_>> {
        let k = events.iter().position(|event| matches!(event.measure(), Measure::TotalEnergy))?;
        let event = self.root.get("event")?.elements("events").ok()?.get(k).copied()?;
        let measure = event.table().ok().and_then(|table| table.get("measure"));
        Some(measure.unwrap_or(event))
    }
}
