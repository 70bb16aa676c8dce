//! `[[group]]`: rows with correlated errors.

use polhode_source::FormatError;
use polhode_source::toml::reader::Value;

use crate::Group;

const KEYS: [&str; 8] =
    ["name", "correlation", "mass", "center", "tensor", "position", "rotation", "density"];

/// Reads all groups of a plan.
pub(crate) fn groups(value: &Value<'_>) -> Result<Vec<Group>, FormatError> {
    let mut groups: Vec<Group> = Vec::new();
    for table in value.tables("group")? {
        table.allow(&KEYS)?;
        let name = table.require("name", "name = \"wheels\"")?;
        let text = name.string()?.to_owned();
        if groups.iter().any(|group| group.name == text) {
            return Err(name.invalid("unique among the groups"));
        }
        let all = table.get("correlation").map_or(Ok(0.0), |value| correlation(&value))?;
        let of = |key| table.get(key).map_or(Ok(all), |value| correlation(&value));
        let group = Group {
            name: text,
            mass: of("mass")?,
            center: of("center")?,
            tensor: of("tensor")?,
            position: of("position")?,
            rotation: of("rotation")?,
            density: of("density")?,
        };
        if KEYS.iter().skip(1).all(|key| table.get(key).is_none()) {
            return Err(table.missing("correlation", "correlation = 0.8, or mass = 0.8 for masses alone"));
        }
        groups.push(group);
    }
    Ok(groups)
}

fn correlation(value: &Value<'_>) -> Result<f64, FormatError> {
    let correlation = super::fraction(value)?;
    match (0.0..=1.0).contains(&correlation) {
        true => Ok(correlation),
        false => Err(value.invalid("from 0 to 1")),
    }
}
