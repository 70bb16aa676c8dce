//! Common definitions of JSON schemas.

use polhode_document::json::pretty;
use serde_json::{Map, Value};

/// Definitions by name.
const SHARED: &str = include_str!("../../schema/defs.json");

/// Returns a self-contained schema, with the common definitions that it refers to.
pub(super) fn complete(schema: &str) -> String {
    let [mut schema, shared] = [schema, SHARED].map(|text| serde_json::from_str(text).unwrap_or(Value::Null));
    while let Some((name, definition)) = missing(&schema, &shared) {
        schema["$defs"][name] = definition;
    }
    pretty(&schema) + "\n"
}

/// Returns the first definition that a schema refers to but does not contain.
fn missing(schema: &Value, shared: &Value) -> Option<(String, Value)> {
    let is_missing = |name: &&str| schema["$defs"].get(name).is_none();
    let name = references(schema).into_iter().find(is_missing)?;
    Some((name.to_owned(), shared.get(name)?.clone()))
}

/// Returns the names of the definitions that a part of a schema refers to.
fn references(part: &Value) -> Vec<&str> {
    let own = part["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/"));
    let values = part.as_object().into_iter().flat_map(Map::values);
    let inner = values.chain(part.as_array().into_iter().flatten()).flat_map(references);
    own.into_iter().chain(inner).collect()
}
