//! The viewer of the page: its tests, and the proof that the committed bundle is the build of its source.
//!
//! Nobody who builds the command needs what this needs: Node, npm and Chromium.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{empty_folder, output, polhode, run};
use crate::{Outcome, root};

/// The build that the command carries.
const BUNDLE: &str = "crates/polhode-report/assets/viewer.html";

/// The oldest Node that the viewer is built and tested with.
const NODE: u32 = 20;

/// Names under which Chromium is installed.
const CHROMIUM: [&str; 4] = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];

/// Installs the viewer's packages, builds it, compares, and runs its tests in a browser.
pub(crate) fn check() -> Outcome {
    node()?;
    let chromium = chromium()?;
    let command = polhode()?;
    let viewer = root().join("viewer");
    let npm = |arguments: &[&str]| {
        let mut npm = Command::new(if cfg!(windows) { "npm.cmd" } else { "npm" });
        npm.args(arguments).current_dir(&viewer);
        npm
    };
    run(&mut npm(&["ci", "--no-audit", "--no-fund"]))?;
    let built = empty_folder("viewer")?.join("viewer.html");
    run(Command::new("node").arg("build.mjs").arg(&built).current_dir(&viewer))?;
    same(&built, &root().join(BUNDLE))?;
    run(npm(&["test"]).env("CHROMIUM", chromium).env("POLHODE", command))
}

/// The bundle must have the bytes of the build.
fn same(built: &Path, committed: &Path) -> Outcome {
    let bytes = |path: &Path| fs::read(path).map_err(|error| format!("{}: {error}", path.display()));
    if bytes(built)? == bytes(committed)? {
        println!("   {BUNDLE} is the build of viewer/");
        return Ok(());
    }
    Err(format!(
        "{BUNDLE} is not the build of viewer/: run `npm ci` and `npm run build` there, and commit it"
    ))
}

fn node() -> Outcome {
    let hint = format!("the viewer's tests need Node {NODE} or later, https://nodejs.org");
    let version = output(Command::new("node").arg("--version")).map_err(|why| format!("{why}\n{hint}"))?;
    let major = version.trim().trim_start_matches('v').split('.').next().and_then(|major| major.parse().ok());
    match major {
        Some(major) if NODE <= major => Ok(()),
        _ => Err(format!("Node is {}: {hint}", version.trim())),
    }
}

/// Chromium, installed if it is not there and this machine lets us.
fn chromium() -> Result<PathBuf, String> {
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
    use super::*;

    #[test]
    fn a_bundle_of_other_bytes_is_refused() {
        let folder = std::env::temp_dir().join(format!("polhode-viewer-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let [a, b] = ["a", "b"].map(|name| folder.join(name));
        fs::write(&a, "one").unwrap();
        fs::write(&b, "two").unwrap();
        assert!(same(&a, &b).is_err() && same(&a, &a).is_ok() && same(&a, &folder.join("c")).is_err());
        fs::remove_dir_all(&folder).unwrap();
    }
}
