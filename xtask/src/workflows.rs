//! Checks of the GitHub workflows, of the published action, and of the job for GitLab.
//!
//! They must conform to their schemas; those for GitHub must be free of known security problems.
//! `integrations/try.py` runs the action and the job.

use std::process::Command;

use crate::process::output;
use crate::python::Environment;
use crate::{Outcome, files, root};

/// Checks the workflows; the schemas come with the tool, so no network is needed.
pub(crate) fn check(environment: &Environment) -> Outcome {
    let workflows = files(&root().join(".github/workflows"), "yml")?;
    let actions = files(&root().join("integrations/github-action"), "yml")?;
    let jobs = files(&root().join("integrations/gitlab"), "yml")?;
    let schemas = [
        ("vendor.github-workflows", &workflows),
        ("vendor.github-actions", &actions),
        ("vendor.gitlab-ci", &jobs),
    ];
    for (schema, files) in schemas {
        let schema = ["--builtin-schema", schema];
        output(Command::new(environment.program("check-jsonschema")).args(schema).args(files))?;
    }
    let all = workflows.iter().chain(&actions);
    output(Command::new(environment.program("zizmor")).args(["--offline", "--quiet"]).args(all))?;
    println!("   {} workflows, {} action, {} job", workflows.len(), actions.len(), jobs.len());
    Ok(())
}
