//! Attributes with `timeSamples`, `connect` or `spline` instead of a single value. They are not
//! read: `read.animated`.

use super::array::ARRAYS;
use super::layer::Prim;
use crate::finding::Severity;
use crate::model::{Note, Span};

/// Suffixes of the names of such attributes.
const SUFFIXES: [&str; 3] = ["timeSamples", "connect", "spline"];

/// Reports such an attribute among the mass properties of a body, and returns the reason why the
/// body has none.
pub(super) fn of_mass(prim: &Prim, attributes: &[&str], notes: &mut Vec<Note>) -> Option<String> {
    let (name, span) = first(prim, |name| attributes.contains(&name))?;
    let message =
        format!("{name} is not read: an inertia that changes over time is not that of one rigid body");
    notes.push(Note { severity: Severity::Suspect, ..Note::new("read.animated", &prim.path, span, message) });
    Some(format!("{name} is not read"))
}

/// Reports such an attribute of the size or pose of a shape; returns true if there is one.
pub(super) fn of_shape(prim: &Prim, link: &str, notes: &mut Vec<Note>) -> bool {
    let is_shape = |name: &str| {
        matches!(name, "size" | "radius" | "height" | "axis")
            || name.starts_with("xformOp:")
            || ARRAYS.contains(&name) && prim.properties.contains_key(name)
    };
    let Some((name, span)) = first(prim, is_shape) else { return false };
    let message = format!("{name} of {} is not read; the shape is used without it", prim.path);
    notes.push(Note::new("read.animated", link, span, message));
    true
}

/// Returns the name of such an attribute of a mesh that has no single value.
pub(super) fn of_mesh<'p>(prim: &'p Prim, name: &str) -> Option<&'p str> {
    first(prim, |own| own == name).map(|(name, _)| name)
}

/// Returns the first such attribute, in file order.
fn first(prim: &Prim, matters: impl Fn(&str) -> bool) -> Option<(&str, Span)> {
    let changes = |name: &str| {
        name.rsplit_once('.').is_some_and(|(own, suffix)| SUFFIXES.contains(&suffix) && matters(own))
    };
    let all = prim.properties.iter().filter(|(name, _)| changes(name));
    let first = all.min_by_key(|(name, value)| (value.span.start, name.as_str()))?;
    Some((first.0.as_str(), first.1.span.clone()))
}
