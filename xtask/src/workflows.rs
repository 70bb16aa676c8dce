//! Checks of the workflows of GitHub, and of the action for those of others, which cannot be run
//! here.
//!
//! They follow their schemas, and do nothing that is known to be unsafe.

use std::process::Command;

use crate::process::output;
use crate::python::Environment;
use crate::{Outcome, files, root};

/// Checks the workflows; it needs no network, since the schema comes with its tool.
pub(crate) fn check(environment: &Environment) -> Outcome {
    let workflows = files(&root().join(".github/workflows"), "yml")?;
    let actions = files(&root().join("integrations"), "yml")?;
    for (schema, files) in [("vendor.github-workflows", &workflows), ("vendor.github-actions", &actions)] {
        let schema = ["--builtin-schema", schema];
        output(Command::new(environment.program("check-jsonschema")).args(schema).args(files))?;
    }
    let all = workflows.iter().chain(&actions);
    output(Command::new(environment.program("zizmor")).args(["--offline", "--quiet"]).args(all))?;
    println!("   {} workflows, {} action", workflows.len(), actions.len());
    Ok(())
}
