//! Options of a slice, for a form: from the JSON schema of its request.

use serde::Serialize;
use serde_json::Value;

/// Option of a request.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Field {
    /// Key of the request, and name of the command's option without its dashes.
    pub key: String,
    /// Description in a sentence.
    pub what: String,
    /// Form of the value: `text`, `integer`, `flag` or `choice`.
    pub form: &'static str,
    /// Values of a choice.
    pub choices: Vec<String>,
}

/// Options whose value is the path of another table.
const PATHS: [&str; 2] = ["diff", "against"];

/// Returns the options of these keys, in their order. `others` are the paths of other tables.
pub(crate) fn fields(schema: &str, keys: &[&str], others: &[String]) -> Vec<Field> {
    let schema: Value = serde_json::from_str(schema).unwrap_or_default();
    let text = |value: &Value| value.as_str().map(str::to_owned);
    let field = |key: &&str| {
        let property = schema.get("properties")?.get(*key)?;
        let has_type = |name: &str| match &property["type"] {
            Value::Array(all) => all.iter().any(|one| one == name),
            one => one == name,
        };
        let (form, choices) = match &property["enum"] {
            Value::Array(values) => ("choice", values.iter().filter_map(text).collect()),
            _ if PATHS.contains(key) => ("choice", others.to_vec()),
            _ if has_type("integer") => ("integer", Vec::new()),
            _ if has_type("boolean") => ("flag", Vec::new()),
            _ => ("text", Vec::new()),
        };
        Some(Field { key: (*key).to_owned(), what: text(&property["description"])?, form, choices })
    };
    keys.iter().filter_map(field).collect()
}
