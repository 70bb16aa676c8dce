//! Checks of the viewer: its tests, and whether the committed bundle is the build of its source.
//!
//! This requires Node, npm and Chromium, unlike a build of the command.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{build_folder, cargo, output, run, run_beside};
use crate::{Outcome, module, root};

/// Oldest major version of Node for the build and the tests.
const NODE: u32 = 20;

/// Names of the Chromium executable.
const CHROMIUM: [&str; 4] = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"];

/// Installs the viewer's packages, compares a build with the committed bundle, and runs the tests
/// in a browser.
pub(crate) fn check() -> Outcome {
    node()?;
    let chromium = chromium()?;
    run_beside(&mut npm(&["ci", "--no-audit", "--no-fund"]))?;
    // The script `test` first checks the types, then the bundles.
    run_beside(npm(&["test"]).env("CHROMIUM", chromium))
}

/// Runs the tests of the interactive page in a browser, with the answers of a command, after
/// [`check`].
pub(crate) fn check_page(page: &Path, command: &Path) -> Outcome {
    let tests = &mut npm(&["run", "test:page"]);
    run_beside(tests.env("CHROMIUM", chromium()?).env("POLHODE", command).env("POLHODE_PAGE", page))
}

/// Returns the path of the command as built by the tests.
pub(crate) fn tested() -> Result<PathBuf, String> {
    Ok(build_folder()?.join(format!("polhode{}", std::env::consts::EXE_SUFFIX)))
}

/// Compares the bits of 11,000 motions in `target/page/polhode.wasm`, in Node and in a browser, with
/// those of a native build without fused multiply–add.
pub(crate) fn check_bits() -> Outcome {
    let folder = module::folder();
    let native = folder.join("native");
    let example = ["build", "--locked", "--package", "polhode-web", "--example", "answers", "--release"];
    run(cargo(&example).env("CARGO_TARGET_DIR", &native).env("RUSTFLAGS", "--cfg no_avx512 --cfg no_avx2"))?;
    let answers = native.join(format!("release/examples/answers{}", std::env::consts::EXE_SUFFIX));
    run_beside(
        npm(&["run", "test:bits"])
            .env("CHROMIUM", chromium()?)
            .env("POLHODE_ANSWERS", answers)
            .env("POLHODE_MODULE", folder.join("polhode.wasm")),
    )
}

/// Returns a command of npm in the folder of the viewer.
pub(crate) fn npm(arguments: &[&str]) -> Command {
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

/// Parses `v20.11.1` to 20.
fn major(version: &str) -> Option<u32> {
    version.trim().strip_prefix('v')?.split('.').next()?.parse().ok()
}

/// Returns the path of Chromium; installs it if it is missing and the system permits that.
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
