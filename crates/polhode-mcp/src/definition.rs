//! Definitions of tools. Their schemas are made from those of requests and reports.

use serde_json::{Map, Value, json};

/// Definition of a tool.
#[derive(Debug)]
pub(crate) struct Definition {
    /// Name of the tool and of its command.
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    /// Question that the tool answers, with units and an example.
    pub(crate) description: &'static str,
    /// JSON schema of the command's request.
    pub(crate) request: &'static str,
    /// JSON schema of the command's report.
    pub(crate) report: fn() -> &'static str,
    /// JSON schema of further arguments; an empty text if there are none.
    pub(crate) more: &'static str,
    /// Keys of the request that are not arguments.
    pub(crate) without: &'static [&'static str],
    /// Arguments that must be given.
    pub(crate) required: &'static [&'static str],
}

/// Schema of the argument that all tools have.
const CONTENTS: &str = r#"{
    "description": "Texts of files by path. If given, the tool reads these instead of files of the server: file, files and the names in these texts are paths of this object.",
    "type": ["object", "null"],
    "additionalProperties": { "type": "string" }
}"#;

impl Definition {
    /// Returns the definition as the protocol lists it.
    pub(crate) fn to_json(&self) -> Value {
        json!({
            "name": self.name,
            "title": self.title,
            "description": self.description,
            "inputSchema": self.input(),
            "outputSchema": self.output(),
            "annotations": {
                "title": self.title,
                "readOnlyHint": true,
                "destructiveHint": false,
                "idempotentHint": true,
                "openWorldHint": false,
            },
        })
    }

    /// Returns the schemas of the arguments by name.
    pub(crate) fn properties(&self) -> Map<String, Value> {
        let of = |schema: &str| match read(schema).remove("properties") {
            Some(Value::Object(properties)) => properties,
            _ => Map::new(),
        };
        let mut properties = of(self.request);
        properties.retain(|key, _| !self.without.contains(&key.as_str()));
        properties.extend(of(self.more));
        properties.insert("contents".to_owned(), read(CONTENTS).into());
        properties.values_mut().for_each(make_portable);
        properties
    }

    /// Returns the schema of the arguments.
    fn input(&self) -> Value {
        let mut schema = read(self.request);
        schema.insert("properties".to_owned(), self.properties().into());
        schema.insert("required".to_owned(), json!(self.required));
        schema.into()
    }

    /// Returns the schema of the structured result.
    ///
    /// The root is an object, as clients before 2026-07-28 require. The definitions move there, so
    /// that references to them stay valid.
    fn output(&self) -> Value {
        let mut report = read((self.report)());
        let [dialect, definitions] = ["$schema", "$defs"].map(|key| report.remove(key));
        json!({
            "$schema": dialect,
            "type": "object",
            "additionalProperties": false,
            "required": ["exit_status", "report"],
            "properties": {
                "exit_status": {
                    "description": "Exit status of the command for the same request: 0 success, 1 findings, 2 a file cannot be read, 3 tolerance not reached.",
                    "enum": [0, 1, 2, 3]
                },
                "report": report
            },
            "$defs": definitions,
        })
    }
}

/// Removes null, as every argument may be left out, and lists of types.
///
/// Some clients read only schemas with one type each: the inspector of the protocol warns of others.
fn make_portable(schema: &mut Value) {
    let Some(schema) = schema.as_object_mut() else { return };
    if let Some(Value::Array(values)) = schema.get_mut("enum") {
        values.retain(|value| !value.is_null());
    }
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|name| name != "null");
        match std::mem::take(types).as_slice() {
            [name] => schema.insert("type".to_owned(), name.clone()),
            names => {
                schema.shift_remove("type");
                let forms: Vec<Value> = names.iter().map(|name| json!({ "type": name })).collect();
                schema.insert("anyOf".to_owned(), forms.into())
            }
        };
    }
    schema.get_mut("items").into_iter().for_each(make_portable);
}

/// Reads a schema of this program. Tests read all of them.
fn read(schema: &str) -> Map<String, Value> {
    serde_json::from_str(schema).unwrap_or_default()
}
