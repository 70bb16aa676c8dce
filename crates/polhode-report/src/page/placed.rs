//! A shape at its place.

use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

/// What is thin is shown with a thickness, so that it can be seen: this part of its smallest size.
pub(super) const THIN: f64 = 1.0 / 40.0;

/// A shape, and where it is.
pub(super) fn at(own: Value, name: &str, position: [f64; 3], quaternion: [f64; 4]) -> Value {
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
