//! The tools.

mod check;
mod explain;
mod inertia;
mod judge;
mod simulate;

use std::sync::atomic::AtomicBool;

use polhode_source::Failure;
use polhode_source::files::Files;
use serde_json::{Map, Value};

use crate::arguments::Arguments;
use crate::definition::Definition;
use crate::outcome::Outcome;

/// Tool: its definition, and the command that it runs.
#[derive(Debug)]
pub(crate) struct Tool {
    pub(crate) definition: Definition,
    run: Run,
}

/// Runs a command on its arguments. The flag becomes true if the call is cancelled.
type Run = fn(Arguments, &dyn Files, &AtomicBool) -> Result<Outcome, Failure>;

/// All tools, in the order in which they are listed.
pub(crate) static TOOLS: [Tool; 5] = [
    Tool { definition: inertia::DEFINITION, run: inertia::run },
    Tool { definition: check::DEFINITION, run: check::run },
    Tool { definition: simulate::DEFINITION, run: simulate::run },
    Tool { definition: judge::DEFINITION, run: judge::run },
    Tool { definition: explain::DEFINITION, run: explain::run },
];

impl Tool {
    /// Runs the tool. It reads `files`, or only those among the arguments.
    pub(crate) fn call(
        &'static self,
        arguments: Map<String, Value>,
        files: &dyn Files,
        cancelled: &AtomicBool,
    ) -> Outcome {
        let called = || {
            let mut arguments = Arguments::new(&self.definition, arguments)?;
            if let Some(contents) = arguments.contents()? {
                return (self.run)(arguments, &contents, cancelled);
            }
            arguments.require_inside(files)?;
            (self.run)(arguments, files, cancelled)
        };
        called().unwrap_or_else(Outcome::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_schema_is_an_object_and_every_argument_is_described() {
        for Tool { definition, .. } in &TOOLS {
            let listed = definition.to_json();
            for schema in [definition.request, (definition.report)(), definition.more] {
                assert!(schema.is_empty() || serde_json::from_str::<Map<String, Value>>(schema).is_ok());
            }
            for property in definition.properties().values() {
                assert!(property["description"].is_string(), "{}: {property}", definition.name);
            }
            for key in definition.required.iter().chain(definition.without) {
                assert!(definition.request.contains(&format!("\"{key}\"")), "{key}");
            }
            assert!(listed["outputSchema"]["$defs"].is_object());
        }
    }
}
