//! Points, directions and names in words, with a given number of digits.

use polhode::math::{Body, Direction};
use polhode_document::number::vector;

use crate::limit::DIRECTIONS;

/// Returns words such as `(10, 0, -2.5) mm`.
pub(crate) fn point(at: [f64; 3], digits: usize) -> String {
    format!("{} mm", vector(at.map(|x| 1e3 * x), digits))
}

/// Returns a named direction such as `z` or `-x`, or three numbers.
pub(crate) fn direction(along: Direction<Body>, digits: usize) -> String {
    let all = along.to_array();
    let named = DIRECTIONS.iter().find(|(_, unit)| *unit == all);
    named.map_or_else(|| vector(all, digits), |(name, _)| (*name).to_owned())
}

/// Returns names in alphabetical order, separated by commas. A name with a comma is quoted.
pub(crate) fn names(all: &[String]) -> String {
    let quoted = |name: &String| if name.contains(',') { format!("\"{name}\"") } else { name.clone() };
    let mut all: Vec<String> = all.iter().map(quoted).collect();
    all.sort();
    all.join(", ")
}
