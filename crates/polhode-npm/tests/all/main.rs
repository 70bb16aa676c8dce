//! Integration tests of `polhode-npm`, built as one program so that the library is linked only once.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

mod answers;
mod refused;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;

use polhode_npm::{Answer, answer};
use polhode_source::files::Memory;
use serde_json::Value;

/// Returns the JSON of an answer, and its numbers.
pub(crate) fn ask(request: &Value, files: &Memory) -> (Value, Vec<f64>) {
    let Answer { json, numbers } = answer(request.to_string().as_bytes(), files);
    (serde_json::from_slice(&json).unwrap(), numbers)
}
