//! The tools: their definitions, with schemas made from those of requests and reports.

use std::sync::atomic::AtomicBool;

use polhode_robot::LINK_CHOICE_SCHEMA;
use polhode_scenario::request::{explain, simulate};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::{Map, Value, json};

use crate::arguments::Arguments;
use crate::command;
use crate::outcome::Outcome;

/// Tool that runs a command.
#[derive(Debug)]
pub(crate) struct Tool {
    /// Name of the tool and of its command.
    pub(crate) name: &'static str,
    /// Title in the first line; then the question that the tool answers, units, and an example.
    about: &'static str,
    request: &'static str,
    report: fn() -> &'static str,
    /// JSON schema of arguments that the request does not have.
    more: &'static str,
    /// Keys of the request that are not arguments.
    without: &'static [&'static str],
    /// Arguments that must be given.
    required: &'static [&'static str],
    run: Run,
}

/// Runs a command on its arguments. The flag becomes true if the call is cancelled.
type Run = fn(Arguments, &dyn Files, &AtomicBool) -> Result<Outcome, Failure>;

/// All tools, in the order in which they are listed.
pub(crate) const TOOLS: &[Tool] = &[
    Tool {
        name: "inertia",
        about: include_str!("../text/inertia.md"),
        request: polhode_shape::REQUEST_SCHEMA,
        report: || polhode_shape::REPORT_SCHEMA,
        more: LINK_CHOICE_SCHEMA,
        without: &["write-mesh"],
        required: &[],
        run: command::inertia,
    },
    Tool {
        name: "check",
        about: include_str!("../text/check.md"),
        request: polhode_robot::REQUEST_SCHEMA,
        report: || polhode_robot::REPORT_SCHEMA,
        without: &["today"],
        required: &["files"],
        more: "{}",
        run: command::check,
    },
    Tool {
        name: "simulate",
        about: include_str!("../text/simulate.md"),
        request: simulate::REQUEST_SCHEMA,
        report: || &simulate::REPORT_SCHEMA,
        more: include_str!("../schema/samples.json"),
        required: &["file"],
        without: &[],
        run: command::simulate,
    },
    Tool {
        name: "judge",
        about: include_str!("../text/judge.md"),
        request: polhode_judge::REQUEST_SCHEMA,
        report: || polhode_judge::REPORT_SCHEMA,
        more: "{}",
        without: &[],
        required: &[],
        run: command::judge,
    },
    Tool {
        name: "explain",
        about: include_str!("../text/explain.md"),
        request: explain::REQUEST_SCHEMA,
        report: || &explain::REPORT_SCHEMA,
        required: &["file"],
        more: "{}",
        without: &[],
        run: command::explain,
    },
];

impl Tool {
    /// Returns the definition of the tool.
    pub(crate) fn definition(&self) -> Value {
        let (title, description) = self.about.split_once('\n').unwrap_or_default();
        let mut input = read(self.request);
        input["properties"] = self.properties().into();
        input["required"] = json!(self.required);
        // The root is an object, as older clients require. References to definitions stay valid.
        let (mut output, mut report) = (read(include_str!("../schema/result.json")), read((self.report)()));
        if let Some(report) = report.as_object_mut() {
            output["$defs"] = report.shift_remove("$defs").unwrap_or_else(|| json!({}));
            report.shift_remove("$schema");
        }
        output["properties"]["report"] = report;
        json!({
            "name": self.name,
            "title": title,
            "description": description.trim_end(),
            "inputSchema": input,
            "outputSchema": output,
            "annotations": { "readOnlyHint": true, "idempotentHint": true, "openWorldHint": false },
        })
    }

    /// Runs the tool. It reads `files`, or only those among the arguments.
    pub(crate) fn call(
        &self,
        values: Map<String, Value>,
        files: &dyn Files,
        cancelled: &AtomicBool,
    ) -> Outcome {
        let called = || {
            let mut arguments = Arguments::new(self.name, values, self.properties(), self.required)?;
            match arguments.contents()? {
                Some(contents) => (self.run)(arguments, &contents, cancelled),
                None => (self.run)(arguments, files, cancelled),
            }
        };
        called().unwrap_or_else(Outcome::from)
    }

    /// Returns the schemas of the arguments by name.
    fn properties(&self) -> Map<String, Value> {
        let schemas = [self.request, self.more, include_str!("../schema/contents.json")];
        let all = schemas.into_iter().filter_map(|schema| match read(schema)["properties"].take() {
            Value::Object(properties) => Some(properties),
            _ => None,
        });
        let mut all: Map<String, Value> = all.flatten().collect();
        all.retain(|key, _| !self.without.contains(&key.as_str()));
        all.values_mut().for_each(make_portable);
        all
    }
}

/// Removes null, as every argument may be left out, and lists of types, which some clients cannot
/// read.
fn make_portable(schema: &mut Value) {
    let Some(schema) = schema.as_object_mut() else { return };
    schema.get_mut("items").into_iter().for_each(make_portable);
    let lists = ["enum", "type"].map(|key| schema.shift_remove(key));
    if let [Some(Value::Array(values)), _] = &lists {
        let values: Vec<&Value> = values.iter().filter(|value| !value.is_null()).collect();
        schema.insert("enum".to_owned(), json!(values));
    }
    match &lists[1] {
        Some(Value::Array(types)) => {
            let types = types.iter().filter(|name| *name != "null").map(|name| json!({ "type": name }));
            let forms: Vec<Value> = types.collect();
            schema.insert("anyOf".to_owned(), forms.into());
        }
        Some(one) => _ = schema.insert("type".to_owned(), one.clone()),
        None => {}
    }
}

/// Reads a schema of this program. A test reads all of them.
fn read(schema: &str) -> Value {
    serde_json::from_str(schema).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_schema_is_an_object_and_every_argument_is_described() {
        for tool in TOOLS {
            for schema in [tool.request, (tool.report)(), tool.more] {
                assert!(read(schema).is_object(), "{schema}");
            }
            for property in tool.properties().values() {
                assert!(property["description"].is_string(), "{}: {property}", tool.name);
            }
            for key in tool.required.iter().chain(tool.without) {
                assert!(read(tool.request)["properties"][key].is_object(), "{key}");
            }
            let output = &tool.definition()["outputSchema"];
            assert!(output["$defs"].as_object().is_some_and(|definitions| !definitions.is_empty()));
            assert!(output["properties"]["report"].get("$defs").is_none());
        }
    }
}
