//! An `orbit` about a point mass, as torques that depend on the place have one.

use polhode::{Anomaly, Direction, MU_EARTH, MotionError, Orbit, OrbitalElements, Position, Velocity};

use crate::error::FormatError;
use crate::scenario::reader::{Table, Value};
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
