//! JSON schema of scenario files, generated from the requests of their reader.

mod accepted;
mod answer;
mod crawl;
mod json;
mod sample;
mod seeds;

use serde_json::Value;

/// Returns the JSON schema (draft 2020-12) of scenario files, for data in TOML or JSON.
///
/// It contains the types, names, dimensions and required keys that the reader requests. Ranges of
/// numbers and mutually exclusive keys are checked by the reader only.
///
/// ```
/// let schema = polhode_scenario::read::schema();
/// assert_eq!(schema["properties"]["run"]["required"], serde_json::json!(["duration"]));
/// assert_eq!(schema["properties"]["run"]["properties"]["order"]["type"], "integer");
/// ```
pub fn schema() -> Value {
    json::of(&crawl::crawl())
}
