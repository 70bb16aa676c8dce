//! Points, directions and amounts in words, with so many digits.

use polhode::math::{Body, Direction};
use polhode_document::number::vector;

/// `(10, 0, -2.5) mm`
pub(super) fn point(at: [f64; 3], digits: usize) -> String {
    format!("{} mm", vector(at.map(|x| 1e3 * x), digits))
}

/// `z`, `-x`, or three numbers.
pub(super) fn direction(along: Direction<Body>, digits: usize) -> String {
    const NAMES: [(&str, [f64; 3]); 6] = [
        ("x", [1.0, 0.0, 0.0]),
        ("y", [0.0, 1.0, 0.0]),
        ("z", [0.0, 0.0, 1.0]),
        ("-x", [-1.0, 0.0, 0.0]),
        ("-y", [0.0, -1.0, 0.0]),
        ("-z", [0.0, 0.0, -1.0]),
    ];
    let all = along.to_array();
    let named = NAMES.iter().find(|(_, unit)| *unit == all);
    named.map_or_else(|| vector(all, digits), |(name, _)| (*name).to_owned())
}

/// Names in no order, with commas between; one that has a comma itself in quotes.
pub(super) fn names(all: &[String]) -> String {
    let quoted = |name: &String| if name.contains(',') { format!("\"{name}\"") } else { name.clone() };
    let mut all: Vec<String> = all.iter().map(quoted).collect();
    all.sort();
    all.join(", ")
}
