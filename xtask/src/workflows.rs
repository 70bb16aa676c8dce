//! Checks of the GitHub workflows and of the published action, which cannot be run here.
//!
//! They must conform to their schemas, and be free of known security problems.

use std::process::Command;

use crate::process::output;
use crate::python::Environment;
use crate::{Outcome, files, root};

/// Checks the workflows; the schemas come with the tool, so no network is needed.
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
