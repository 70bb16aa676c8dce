//! Shape at its place.

use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

/// Display thickness of thin shapes, relative to their smallest size.
pub(crate) const THIN: f64 = 1.0 / 40.0;

/// Returns a shape with its name, position and orientation.
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
