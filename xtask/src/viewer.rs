//! Checks of the viewer of the page: its tests, and the proof that the committed bundle is the
//! build of its source.
//!
//! This needs Node, npm and Chromium; building the command does not.

use std::path::PathBuf;
use std::process::Command;

use crate::process::{output, run, run_beside};
use crate::{Outcome, root};

/// Major version of the oldest Node that the viewer is built and tested with.
const NODE: u32 = 20;

/// Names under which Chromium is installed.
const CHROMIUM: [&str; 4] = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];

/// Installs the viewer's packages, builds it in memory, and runs its tests in a browser.
///
/// The build equals the committed bundle, byte by byte.
pub(crate) fn check() -> Outcome {
    node()?;
    let chromium = chromium()?;
    run_beside(&mut npm(&["ci", "--no-audit", "--no-fund"]))?;
    // It begins with the types. It also checks that crates/polhode-scenario/assets/viewer.html and
    // crates/polhode-live/assets are the builds.
    run_beside(npm(&["test"]).env("CHROMIUM", chromium))
}

/// Runs the tests of the live page in a browser, after [`check`].
///
/// They use the command that the tests have built.
pub(crate) fn check_live() -> Outcome {
    let name = format!("polhode{}", std::env::consts::EXE_SUFFIX);
    let command = root().join("target/debug").join(name);
    run_beside(npm(&["run", "test:live"]).env("CHROMIUM", chromium()?).env("POLHODE", command))
}

fn npm(arguments: &[&str]) -> Command {
    let mut npm = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
    npm.args(arguments).current_dir(root().join("viewer"));
    npm
}

fn node() -> Outcome {
    let hint = format!("the viewer's tests need Node {NODE} or later, https://nodejs.org");
    let version = output(Command::new("node").arg("--version")).map_err(|why| format!("{why}\n{hint}"))?;
    match major(&version) {
        Some(major) if NODE <= major => Ok(()),
        _ => Err(format!("Node is {}: {hint}", version.trim())),
    }
}

/// Returns 20 for `v20.11.1`.
fn major(version: &str) -> Option<u32> {
    version.trim().strip_prefix('v')?.split('.').next()?.parse().ok()
}

/// Returns the path of Chromium, installed if it is not there and this machine lets us.
pub(crate) fn chromium() -> Result<PathBuf, String> {
    if let Some(found) = std::env::var_os("CHROMIUM").map(PathBuf::from).or_else(on_path) {
        return Ok(found);
    }
    println!("   no Chromium: installing it");
    let apt = |arguments: &[&str]| {
        run(Command::new("apt-get").args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
    };
    let installed = apt(&["update", "-qq"])
        .and_then(|()| apt(&["install", "-qq", "-y", "--no-install-recommends", "chromium"]));
    match (installed, on_path()) {
        (_, Some(found)) => Ok(found),
        (why, None) => Err(format!(
            "the viewer's tests need Chromium on the path, or its place in the variable CHROMIUM{}",
            why.err().map_or_else(String::new, |why| format!(" ({why})"))
        )),
    }
}

fn on_path() -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let mut folders = std::env::split_paths(&path);
    folders.find_map(|folder| CHROMIUM.iter().map(|name| folder.join(name)).find(|file| file.is_file()))
}

#[cfg(test)]
mod tests {
    use super::major;

    #[test]
    fn the_version_of_node_is_read() {
        assert_eq!(major("v20.11.1\n"), Some(20));
        assert_eq!(major("v9.0.0"), Some(9));
        assert_eq!(major("20"), None);
        assert_eq!(major("command not found"), None);
    }
}
