//! Statements about mass in the schemas of physics engines that are not read: PhysX (`physx…`),
//! Newton (`newton:`) and MuJoCo (`mjc:`).

use super::layer::Prim;
use super::value::Value;
use crate::finding::Severity;
use crate::model::Note;

/// Parts of a name that indicate mass properties, or the coupling of a joint.
const WORDS: [&str; 6] = ["mass", "inertia", "density", "centerof", "totalmass", "mimic"];

/// Names that are read, or do not change the mass properties of a body.
const KNOWN: [&str; 3] = ["physxMimicJoint:", "physxRigidBody:solve", "physxScene:"];

/// Returns the first statement about mass of a prim that is not read, and reports all of them.
pub(super) fn of(prim: &Prim, notes: &mut Vec<Note>) -> Option<String> {
    let foreign = |name: &str| ["physx", "newton:", "mjc:"].iter().any(|prefix| name.starts_with(prefix));
    let matters = |name: &str| {
        let lower = name.to_ascii_lowercase();
        foreign(name)
            && WORDS.iter().any(|word| lower.contains(word))
            && !KNOWN.iter().any(|known| name.starts_with(known))
    };
    let mut found: Vec<_> =
        prim.properties.iter().filter(|(name, value)| matters(name) && !is_default(name, value)).collect();
    found.sort_by_key(|(name, value)| (value.span.start, name.as_str()));
    for (name, value) in &found {
        let message =
            format!("{name} = {} is not read; it may change mass properties or joints", value.text());
        let note = Note::new("read.unknown", &prim.path, value.span.clone(), message);
        notes.push(Note { severity: Severity::Suspect, ..note });
    }
    found.first().map(|(name, _)| format!("{name} of {} is not read", prim.path))
}

/// Returns true for the default value of the MuJoCo schema, which changes nothing.
fn is_default(name: &str, value: &Value) -> bool {
    let default = match name {
        "mjc:compiler:setTotalMass" => -1.0,
        "mjc:compiler:inertiaFromGeom" => return value.words.iter().any(|word| word == "auto"),
        "mjc:inertia" => return value.words.iter().any(|word| matches!(word.as_str(), "legacy" | "exact")),
        _ => 0.0,
    };
    value.words.iter().all(|word| word == "false")
        && value.numbers.iter().all(|number| number.value == Some(default))
}
