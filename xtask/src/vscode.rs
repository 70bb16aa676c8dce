//! The extension of VS Code, which contains the npm package.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::run_beside;
use crate::viewer::{chromium, npm, tested};
use crate::{Outcome, root};

/// Builds the extension and runs its tests without VS Code, after the npm package is built.
pub(crate) fn check() -> Outcome {
    install()?;
    run_beside(script("unit").env("POLHODE", tested()?))
}

/// Packs the extension and returns its path; `command` prints the schema of scenarios.
pub(crate) fn package(command: &Path) -> Result<PathBuf, String> {
    install()?;
    run_beside(script("package").env("POLHODE", command))?;
    Ok(folder().join("polhode.vsix"))
}

/// Runs all tests, those in the extension host of VS Code too, which npm installs.
pub(crate) fn test(command: &Path) -> Outcome {
    run_beside(script("test").env("POLHODE", command).env("CHROMIUM", chromium()?))
}

/// Tests the extension with the command of the tests, and packs it.
pub(crate) fn release() -> Outcome {
    let command = tested()?;
    println!("   {}", package(&command)?.display());
    test(&command)
}

fn install() -> Outcome {
    run_beside(npm(&["ci", "--ignore-scripts", "--no-audit", "--no-fund"]).current_dir(folder()))
}

fn script(name: &str) -> Command {
    let mut command = npm(&["run", name]);
    command.current_dir(folder());
    command
}

fn folder() -> PathBuf {
    root().join("integrations/vscode")
}
