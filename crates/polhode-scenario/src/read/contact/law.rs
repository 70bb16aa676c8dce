//! Contact law: constraint or friction at the point of contact, and resistance to rolling and
//! pivoting.

use polhode::motion::contact::{ContactLaw, Friction, Resistance};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::not_negative;

/// Reads `law = "rolling"`, `"friction"` with its coefficients, or `"frictionless"`, and the
/// resistance to rolling and pivoting.
pub(crate) fn law(table: &Table<'_>) -> Result<ContactLaw, FormatError> {
    const OF_FRICTION: [&str; 3] = ["friction", "static_friction", "viscous"];
    let rubs = OF_FRICTION.iter().any(|key| table.get(key).is_some()) || table.get("rolls").is_some();
    let value = table.require("law", if rubs { "law = \"friction\"" } else { "law = \"rolling\"" })?;
    let law = match value.choice(&["rolling", "friction", "frictionless"])? {
        "friction" => friction(table)?,
        other => {
            if let Some(key) = OF_FRICTION.iter().find_map(|key| table.get(key)) {
                let rule = format!("left out with law = \"{other}\"");
                return Err(key.invalid(rule).with_hint("law = \"friction\" has coefficients"));
            }
            if other == "rolling" { ContactLaw::ROLLING } else { ContactLaw::FRICTIONLESS }
        }
    };
    let lever = |key| match table.get(key) {
        Some(lever) => not_negative(&lever, Dimension::LENGTH),
        None => Ok(0.0),
    };
    let resistance =
        Resistance { rolling: lever("rolling_friction")?, pivoting: lever("pivoting_friction")? };
    law.resisted_by(resistance).map_err(|error| value.motion(error))
}

fn friction(table: &Table<'_>) -> Result<ContactLaw, FormatError> {
    let given = table.require("friction", "friction = 0.3")?;
    let kinetic = not_negative(&given, Dimension::NONE)?;
    let sticking = match table.get("static_friction") {
        None => kinetic,
        Some(value) => match not_negative(&value, Dimension::NONE)? {
            sticking if sticking >= kinetic => sticking,
            _ => {
                let rule = format!("at least the kinetic coefficient, friction = {kinetic}");
                return Err(value.invalid(rule).with_hint("leave it out if both are equal"));
            }
        },
    };
    let viscous = match table.get("viscous") {
        Some(value) => not_negative(&value, Dimension::VISCOUS_FRICTION)?,
        None => 0.0,
    };
    placed(&given, Friction { sticking, kinetic, viscous })
}

fn placed(value: &Value<'_>, friction: Friction) -> Result<ContactLaw, FormatError> {
    ContactLaw::with_friction(friction).map_err(|error| value.motion(error))
}
