//! Arrays of numbers that may be large: the points and faces of meshes.

use std::sync::Arc;

/// Attributes of a `Mesh` whose numbers are stored as an array.
pub(super) const ARRAYS: [&str; 4] = ["points", "faceVertexCounts", "faceVertexIndices", "holeIndices"];

/// Length of an array in the text from which its numbers are skipped, bytes, such as those of normals.
const LONG: usize = 4096;

/// Returns the length of an array of numbers at the start of a text, with its brackets, if its numbers
/// are stored as an array or skipped; `name` is that of the attribute.
pub(super) fn length(name: &str, rest: &str) -> Option<usize> {
    let is_numeric =
        |byte: &u8| byte.is_ascii_digit() || byte.is_ascii_whitespace() || b"+-.,()eEinfa".contains(byte);
    let inner = rest.as_bytes().get(1..)?;
    let length = 2 + inner.iter().position(|byte| !is_numeric(byte))?;
    let ends = rest.as_bytes().get(length - 1) == Some(&b']');
    let is_skipped = length > LONG && !is_schema(name);
    (ends && (ARRAYS.contains(&name) || is_skipped)).then_some(length)
}

/// Returns true for a name of a schema about physics, whose numbers may matter.
fn is_schema(name: &str) -> bool {
    ["physics:", "physx", "newton:", "mjc:", "xformOp:"].iter().any(|start| name.starts_with(start))
}

/// Returns the numbers in a text; NaN for a malformed one.
pub(super) fn numbers(text: &str) -> Arc<[f64]> {
    let is_between = |c: char| matches!(c, '[' | ']' | '(' | ')' | ',') || c.is_ascii_whitespace();
    let words = text.split(is_between).filter(|word| !word.is_empty());
    words.map(|word| word.parse().unwrap_or(f64::NAN)).collect()
}
