//! A shape at its place.

use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

/// Thickness with which thin shapes are shown, so that they can be seen, relative to their smallest
/// size.
pub(crate) const THIN: f64 = 1.0 / 40.0;

/// Returns a shape with its name and its place.
pub(crate) fn at(own: Value, name: &str, position: [f64; 3], quaternion: [f64; 4]) -> Value {
    let mut shape = json!({
        "name": name,
        "position": numbers(&position.map(finite)),
        "quaternion": numbers(&quaternion),
    });
    if let (Value::Object(shape), Value::Object(own)) = (&mut shape, own) {
        shape.extend(own);
    }
    shape
}
