//! The workflows of GitHub, which cannot be run here: they are what their schema says, and do nothing that is known to be unsafe.

use std::process::Command;

use crate::process::output;
use crate::python::Environment;
use crate::{Outcome, files, root};

/// Needs no network: the schema comes with its tool.
pub(crate) fn check(environment: &Environment) -> Outcome {
    let workflows = files(&root().join(".github/workflows"), "yml")?;
    let schema = ["--builtin-schema", "vendor.github-workflows"];
    output(Command::new(environment.program("check-jsonschema")).args(schema).args(&workflows))?;
    output(Command::new(environment.program("zizmor")).args(["--offline", "--quiet"]).args(&workflows))?;
    println!("   {} workflows", workflows.len());
    Ok(())
}
