//! The `orbit` about a point mass that torques which depend on the place act on: one body, one orbit.

use std::ops::Range;
use std::sync::Arc;

use polhode::body::{Finding, Severity};
use polhode::math::{Direction, Position, Velocity};
use polhode::motion::{Anomaly, MU_EARTH, MotionError, Orbit, OrbitalElements};

use crate::error::FormatError;
use crate::scenario::reader::{Table, Value};
use crate::scenario::tree::{Entries, Kind, Node};
use crate::unit::Dimension;

/// What to write where an orbit is missing.
pub(super) const EXAMPLE: &str = "orbit = { radius = \"6778 km\" }";

/// The four forms, by the key that each of them needs, and the others that it may have.
const FORMS: [(&str, &[&str]); 4] = [
    ("radius", &["radial", "motion"]),
    ("rate", &["radial", "motion"]),
    ("position", &["velocity"]),
    (
        "semi_major_axis",
        &["eccentricity", "inclination", "node", "periapsis", "mean_anomaly", "true_anomaly"],
    ),
];

/// The orbit of the torques of a scenario, as the first of them that has one gives it.
#[derive(Debug)]
pub(crate) struct SharedOrbit {
    orbit: Orbit,
    place: Range<usize>,
    /// Given by its rate: nothing but that matters to the gravity gradient on a circle.
    by_rate: bool,
}

/// The orbit that a torque acts on: that of the torques before it, or its own, which must be the same.
pub(super) fn orbit_of(table: &Table<'_>, shared: &mut Option<SharedOrbit>) -> Result<Orbit, FormatError> {
    let Some(value) = table.get("orbit") else {
        let first = shared.as_ref().map(|shared| shared.orbit.clone());
        return first.ok_or_else(|| table.missing("orbit", EXAMPLE));
    };
    let own = orbit(&value)?;
    match shared {
        Some(first) if !same(&first.orbit, &own) => {
            let line = value.source().place(first.place.clone()).line;
            let rule = format!("the orbit that line {line} gives: a body is on one");
            return Err(value
                .invalid(rule)
                .with_hint("leave out this one: the torque acts on that of the other"));
        }
        Some(_) => {}
        None => {
            let by_rate = value.table()?.get("rate").is_some();
            *shared = Some(SharedOrbit { orbit: own.clone(), place: value.span(), by_rate });
        }
    }
    Ok(own)
}

/// True of one orbit given twice, perhaps in two forms.
fn same(a: &Orbit, b: &Orbit) -> bool {
    /// Relative; what two forms of the same numbers differ by is rounding.
    const ROUNDING: f64 = 1e-9;
    let near = |difference: f64, size: f64| difference <= ROUNDING * size;
    let (position, velocity) = (a.position(0.0), a.velocity(0.0));
    near((a.mu() - b.mu()).abs(), a.mu())
        && near((position - b.position(0.0)).norm(), position.norm())
        && near((velocity - b.velocity(0.0)).norm(), velocity.norm())
}

impl SharedOrbit {
    /// An orbit about the Earth that goes through it: a height where a radius belongs, or a rate in another unit.
    pub(crate) fn underground(&self) -> Option<Finding> {
        /// The Earth's least radius, at the poles, m (WGS 84).
        const POLES: f64 = 6_356_752.3;
        let is_earth = (self.orbit.mu() / MU_EARTH - 1.0).abs() < 1e-2;
        let least = self.orbit.periapsis();
        let km = least / 1e3;
        let message = match self.orbit.mean_motion().filter(|_| self.by_rate) {
            Some(rate) => format!(
                "no orbit about the Earth has the rate {rate} rad/s: its radius would be {km:.1} km, and the Earth reaches to 6356.8 km; is \
                 its unit right, or is mu another body's?"
            ),
            None => format!(
                "the orbit comes within {km:.1} km of the centre of what has the Earth's µ, and the Earth reaches to 6356.8 km: is a \
                 height given as a radius?"
            ),
        };
        let severity = Severity::Warning;
        (is_earth && least < POLES).then_some(Finding {
            code: "orbit.underground",
            severity,
            message,
            place: None,
        })
    }
}

/// The places of the values of each orbit that a torque gives.
pub(crate) fn places(entries: &Entries) -> Vec<Vec<usize>> {
    let Some(Kind::List(torques)) = entries.get("torque").map(|torques| &torques.node.kind) else {
        return Vec::new();
    };
    let of = |torque: &Arc<Node>| match &torque.kind {
        Kind::Table(torque) => torque.get("orbit").map(|orbit| orbit.node.places()),
        _ => None,
    };
    torques.iter().filter_map(of).collect()
}

/// Reads an orbit from one of its four forms.
///
/// `{ radius = … }` or `{ rate = … }` with `radial` and `motion`, `{ position = [3], velocity = [3] }`, or
/// `{ semi_major_axis = …, eccentricity = … }` with its angles; `mu` with each.
pub(super) fn orbit(value: &Value<'_>) -> Result<Orbit, FormatError> {
    const KEYS: [&str; 14] = [
        "mu",
        "radius",
        "rate",
        "radial",
        "motion",
        "position",
        "velocity",
        "semi_major_axis",
        "eccentricity",
        "inclination",
        "node",
        "periapsis",
        "mean_anomaly",
        "true_anomaly",
    ];
    const RULE: &str = "an orbit is given once";
    let table = value.table()?;
    table.allow(&KEYS)?;
    let Some(form) = table.at_most_one(&FORMS.map(|(key, _)| key), RULE)? else {
        return Err(table.missing("radius", "radius = \"6778 km\", or rate, position or semi_major_axis"));
    };
    let own = FORMS.iter().find(|(key, _)| *key == form.key()).map_or(&[][..], |(_, own)| own);
    for key in KEYS.iter().filter(|key| !["mu", form.key()].contains(key) && !own.contains(key)) {
        table.at_most_one(&[form.key(), key], RULE)?;
    }
    let mu = match table.get("mu") {
        Some(mu) => positive(&mu, Dimension::GRAVITATIONAL_PARAMETER)?,
        None => MU_EARTH,
    };
    let direction = |key, default: [f64; 3]| {
        let numbers = table.get(key).map_or(Ok(default), |value| value.numbers());
        numbers.map(Direction::from_array)
    };
    let made: Result<Orbit, MotionError> = match form.key() {
        "position" => {
            let velocity = table.require("velocity", "velocity = [0, \"7.6 km/s\", 0]")?;
            let velocity = Velocity::from_array(velocity.quantities(Dimension::VELOCITY)?);
            Orbit::through(mu, Position::from_array(form.quantities(Dimension::LENGTH)?), velocity, 0.0)
        }
        "semi_major_axis" => Orbit::of_elements(mu, &elements(&table, &form)?),
        key => {
            let (radial, motion) =
                (direction("radial", [1.0, 0.0, 0.0])?, direction("motion", [0.0, 1.0, 0.0])?);
            if key == "rate" {
                Orbit::circular_at_rate(mu, positive(&form, Dimension::ANGULAR_VELOCITY)?, radial, motion)
            } else {
                Orbit::circular(mu, positive(&form, Dimension::LENGTH)?, radial, motion)
            }
        }
    };
    made.map_err(|error| value.motion(error))
}

/// Eccentricity and angles are zero where they are not given.
fn elements(table: &Table<'_>, semi_major_axis: &Value<'_>) -> Result<OrbitalElements, FormatError> {
    let angle = |key| table.get(key).map_or(Ok(0.0), |value| value.quantity(Dimension::ANGLE));
    let anomaly = table.at_most_one(&["mean_anomaly", "true_anomaly"], "either says where on the orbit")?;
    Ok(OrbitalElements {
        semi_major_axis: semi_major_axis.quantity(Dimension::LENGTH)?,
        eccentricity: table.get("eccentricity").map_or(Ok(0.0), |value| value.number())?,
        inclination: angle("inclination")?,
        node: angle("node")?,
        periapsis: angle("periapsis")?,
        anomaly: match anomaly {
            None => Anomaly::Mean(0.0),
            Some(value) if value.key() == "true_anomaly" => Anomaly::True(value.quantity(Dimension::ANGLE)?),
            Some(value) => Anomaly::Mean(value.quantity(Dimension::ANGLE)?),
        },
    })
}

fn positive(value: &Value<'_>, dimension: Dimension) -> Result<f64, FormatError> {
    let number = value.quantity(dimension)?;
    if number > 0.0 {
        return Ok(number);
    }
    Err(value.invalid("positive").with_hint("radial and motion say where the body is, and which way it goes"))
}
