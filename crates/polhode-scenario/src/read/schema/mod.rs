//! The JSON schema of scenario files, made from what their reader asks for.

mod accepted;
mod answer;
mod crawl;
mod json;
mod sample;
mod seeds;

use serde_json::Value;

/// Returns the JSON schema (draft 2020-12) of scenario files, as data that TOML and JSON have in common.
///
/// It has the types, names, dimensions and required keys that the reader requests. The reader alone checks
/// ranges of numbers and keys that exclude each other.
///
/// ```
/// let schema = polhode_scenario::read::schema();
/// assert_eq!(schema["properties"]["run"]["required"], serde_json::json!(["duration"]));
/// assert_eq!(schema["properties"]["run"]["properties"]["order"]["type"], "integer");
/// ```
pub fn schema() -> Value {
    json::of(&crawl::crawl())
}
