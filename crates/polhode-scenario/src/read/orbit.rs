//! `[orbit]` about a point mass: position of the body, and orbital axes for its attitude.

use polhode::body::{Finding, Severity};
use polhode::math::{Direction, Position, Velocity};
use polhode::motion::{Anomaly, MU_EARTH, MotionError, Orbit, OrbitalElements};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Example for a missing orbit.
const EXAMPLE: &str = "[orbit] on a line of its own, and under it altitude = \"500 km\"";

/// The five forms: the required key, and the optional keys.
const FORMS: [(&str, &[&str]); 5] = [
    ("altitude", &["radial", "motion", "inclination", "node", "mean_anomaly", "true_anomaly"]),
    ("radius", &["radial", "motion", "inclination", "node", "mean_anomaly", "true_anomaly"]),
    ("rate", &["radial", "motion"]),
    ("position", &["velocity"]),
    (
        "semi_major_axis",
        &["eccentricity", "inclination", "node", "periapsis", "mean_anomaly", "true_anomaly"],
    ),
];

/// Equatorial radius of the Earth, m (WGS 84); altitudes are measured from it.
const EARTH: f64 = 6_378_137.0;

/// Orbit of a scenario.
#[derive(Debug)]
pub(crate) struct SharedOrbit {
    pub orbit: Orbit,
    /// True if the orbit is given by its rate, the only quantity that the gravity gradient on a
    /// circle needs.
    by_rate: bool,
}

/// Reads `[orbit]`, if present.
pub(crate) fn read(root: &Table<'_>) -> Result<Option<SharedOrbit>, FormatError> {
    let Some(value) = root.get("orbit") else { return Ok(None) };
    let by_rate = value.table()?.get("rate").is_some();
    Ok(Some(SharedOrbit { orbit: orbit(&value)?, by_rate }))
}

/// Returns the orbit required by a table; an error if there is none.
pub(crate) fn require<'a>(table: &Table<'_>, orbit: Option<&'a Orbit>) -> Result<&'a Orbit, FormatError> {
    orbit.ok_or_else(|| table.missing("orbit", EXAMPLE))
}

impl SharedOrbit {
    /// Returns a finding for an orbit that passes through the Earth: probably a height instead of a
    /// radius, or a wrong unit.
    pub(crate) fn underground(&self) -> Option<Finding> {
        /// Polar radius of the Earth, its least, m (WGS 84).
        const POLES: f64 = 6_356_752.3;
        let is_earth = (self.orbit.mu() / MU_EARTH - 1.0).abs() < 1e-2;
        let least = self.orbit.periapsis();
        let km = least / 1e3;
        let message = match self.orbit.mean_motion().filter(|_| self.by_rate) {
            Some(rate) => format!(
                "no orbit about the Earth has the rate {rate} rad/s: its radius would be {km:.1} km, below the Earth's polar radius of 6356.8 km; check the unit, or give mu of another body"
            ),
            None => format!(
                "the orbit comes within {km:.1} km of the Earth's centre, below the polar radius of 6356.8 km: perhaps an altitude was given as a radius"
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

/// Reads an orbit in one of its forms.
///
/// The forms are: `altitude` (above the Earth's equator), `radius` or `rate`, with `radial` and
/// `motion`, or with angles except for the rate; `position` and `velocity`; or `semi_major_axis`
/// and `eccentricity` with angles. `mu` goes with each, except with an altitude.
fn orbit(value: &Value<'_>) -> Result<Orbit, FormatError> {
    const KEYS: [&str; 15] = [
        "mu",
        "altitude",
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
        return Err(
            table.missing("altitude", "altitude = \"500 km\", or radius, rate, position or semi_major_axis")
        );
    };
    let own = FORMS.iter().find(|(key, _)| *key == form.key()).map_or(&[][..], |(_, own)| own);
    for key in KEYS.iter().filter(|key| !["mu", form.key()].contains(key) && !own.contains(key)) {
        table.at_most_one(&[form.key(), key], RULE)?;
    }
    table.at_most_one(
        &["altitude", "mu"],
        "an altitude is relative to the Earth: for another body give the radius",
    )?;
    let mu = match table.get("mu") {
        Some(mu) => positive(&mu, Dimension::GRAVITATIONAL_PARAMETER)?,
        None => MU_EARTH,
    };
    let angles = ["inclination", "node", "mean_anomaly", "true_anomaly"];
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
        "semi_major_axis" => Orbit::of_elements(mu, &elements(&table, form.quantity(Dimension::LENGTH)?)?),
        _ if let Some(angle) = angles.iter().find_map(|key| table.get(key)) => {
            for key in ["radial", "motion"] {
                table.at_most_one(
                    &[key, angle.key()],
                    "give the orientation of the orbit either by directions or by angles",
                )?;
            }
            Orbit::of_elements(mu, &elements(&table, radius(&form)?)?)
        }
        key => {
            let (radial, motion) =
                (direction("radial", [1.0, 0.0, 0.0])?, direction("motion", [0.0, 1.0, 0.0])?);
            if key == "rate" {
                Orbit::circular_at_rate(mu, positive(&form, Dimension::ANGULAR_VELOCITY)?, radial, motion)
            } else {
                Orbit::circular(mu, radius(&form)?, radial, motion)
            }
        }
    };
    made.map_err(|error| value.motion(error))
}

/// Returns the radius of a circular orbit, m.
fn radius(form: &Value<'_>) -> Result<f64, FormatError> {
    if form.key() == "radius" {
        return positive(form, Dimension::LENGTH);
    }
    Ok(EARTH + form.quantity(Dimension::LENGTH)?)
}

/// Reads orbital elements; eccentricity and angles default to zero.
fn elements(table: &Table<'_>, semi_major_axis: f64) -> Result<OrbitalElements, FormatError> {
    let angle = |key| table.get(key).map_or(Ok(0.0), |value| value.quantity(Dimension::ANGLE));
    let anomaly =
        table.at_most_one(&["mean_anomaly", "true_anomaly"], "both define the position on the orbit")?;
    Ok(OrbitalElements {
        semi_major_axis,
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
    Err(value
        .invalid("positive")
        .with_hint("radial and motion define the position and the direction of motion"))
}
