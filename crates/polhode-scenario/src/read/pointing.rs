//! `[[pointing]]`: angles between a body direction and a reference direction of orbit, field or
//! space.

use polhode::math::{Body, Direction, Frame};
use polhode::motion::torque::MagneticField;
use polhode::motion::{Orbit, Pointing, Reference};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Named directions.
pub(crate) const NAMED: [&str; 4] = ["nadir", "velocity", "orbit_normal", "field"];

/// Sources of the named directions.
pub(crate) struct References<'a> {
    pub orbit: Option<&'a Orbit>,
    /// Field of the magnetic torques.
    pub field: Option<&'a MagneticField>,
}

/// Reads all pointings.
pub(crate) fn pointings(root: &Table<'_>, references: &References<'_>) -> Result<Vec<Pointing>, FormatError> {
    let Some(list) = root.get("pointing") else { return Ok(Vec::new()) };
    let mut pointings: Vec<Pointing> = Vec::new();
    for table in list.tables("pointing")? {
        table.allow(&["name", "body", "to", "limit"])?;
        let named = table.require("name", "name = \"antenna\"")?;
        let name = named.string()?;
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if name.is_empty() || !name.chars().all(is_word) {
            let hint = "it names a column: write name = \"antenna\"";
            return Err(named
                .invalid("letters of the Latin alphabet, digits and underscores")
                .with_hint(hint));
        }
        if pointings.iter().any(|other| other.name().eq_ignore_ascii_case(name)) {
            return Err(named
                .invalid("different from the names of other pointings")
                .with_hint("give each pointing its own name"));
        }
        let axis = table.require("body", "body = [0, 0, 1]")?;
        let body: Direction<Body> = direction(&axis)?;
        let to = table.require("to", "to = \"nadir\"")?;
        let reference = if to.is_array() {
            return Err(to
                .invalid(format!("\"{}\", or {{ space = [3] }}", NAMED.join("\", \"")))
                .with_hint("a direction that is fixed in space is written { space = [1, 0, 0] }"));
        } else if to.string().is_ok() {
            references.named(&to, to.choice(&NAMED)?)?
        } else {
            let table = to.table()?;
            table.allow(&["space"])?;
            Reference::Space(direction(&table.require("space", "{ space = [1, 0, 0] }")?)?)
        };
        let pointing = Pointing::new(name, body, reference).map_err(|error| axis.motion(error))?;
        pointings.push(match table.get("limit") {
            Some(limit) => {
                let angle = limit.quantity(Dimension::ANGLE)?;
                pointing.with_limit(angle).map_err(|_| limit.invalid("between 0 and 180 degrees"))?
            }
            None => pointing,
        });
    }
    Ok(pointings)
}

/// Reads a nonzero direction.
pub(crate) fn direction<F: Frame>(value: &Value<'_>) -> Result<Direction<F>, FormatError> {
    let direction = Direction::from_array(value.numbers()?);
    match direction.direction() {
        Some(_) => Ok(direction),
        None => Err(value
            .invalid("a direction: not all zero")
            .with_hint("the z axis is [0, 0, 1]; its length does not matter")),
    }
}

impl References<'_> {
    /// Returns one of the directions in [`NAMED`].
    pub(crate) fn named(&self, value: &Value<'_>, name: &str) -> Result<Reference, FormatError> {
        if name == "field" {
            let field = self.field.ok_or_else(|| {
                let rule = "left out, since no [[torque]] of model \"magnetic\" defines the field, or two fields differ";
                value.invalid(rule).with_hint("give its direction as { space = [0, 0, 1] }")
            })?;
            return Ok(Reference::Field(field.clone()));
        }
        let orbit = self.orbit.cloned().ok_or_else(|| {
            let hint = "write [orbit] on a line of its own, and under it altitude = \"500 km\"";
            value.invalid("used with an [orbit], which defines this direction").with_hint(hint)
        })?;
        Ok(match name {
            "nadir" => Reference::Nadir(orbit),
            "velocity" => Reference::Velocity(orbit),
            _ => Reference::OrbitNormal(orbit),
        })
    }
}
