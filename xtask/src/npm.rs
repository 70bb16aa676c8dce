//! The npm package `polhode`: two WebAssembly modules, and the JavaScript around them.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::module::{self, Build};
use crate::notices::notices_of;
use crate::process::{output, run, run_beside};
use crate::viewer::{chromium, npm, tested};
use crate::{Outcome, root};

/// Largest size of the small module compressed by gzip, bytes.
const MOST: usize = 400_000;

/// Builds and packs the package for a release into `target/npm/`, and runs its tests.
pub(crate) fn release() -> Outcome {
    let package = build(Build::Release)?;
    test(&package, &tested()?)?;
    println!("   {}", package.display());
    Ok(())
}

/// Builds the package quickly, and runs its tests, after the checks of the viewer.
pub(crate) fn check() -> Outcome {
    test(&build(Build::Quick)?, &tested()?)
}

/// Builds and packs the package, and returns the path of the archive.
pub(crate) fn build(build: Build) -> Result<PathBuf, String> {
    let small = module::build(build, "package", module::SMALL, "npm-small")?;
    if build == Build::Release {
        let size = gzipped(&small)?;
        println!("   small module: {} kB compressed", size / 1000);
        if size > MOST {
            return Err(format!("the small module has {size} bytes compressed, more than {MOST}"));
        }
    }
    let full = module::build(build, "full", "page", "npm-full")?;
    let folder = root().join("target/npm");
    let package = folder.join("package");
    let mut node = Command::new("node");
    node.arg("build.mjs").arg("--small").arg(small).arg("--full").arg(full).arg("--into").arg(&package);
    run(node.current_dir(root().join("npm")))?;
    let linked = ["--package", "polhode-wasm", "--features", "full", "--target", "wasm32-unknown-unknown"];
    let file = package.join("THIRD-PARTY-LICENSES.txt");
    std::fs::write(&file, notices_of(&linked)?).map_err(|error| format!("{}: {error}", file.display()))?;
    let name = output(npm(&["pack", "--silent", "--pack-destination", ".."]).current_dir(&package))?;
    Ok(folder.join(name.trim()))
}

/// Returns the size of a file compressed by gzip, bytes.
fn gzipped(file: &Path) -> Result<usize, String> {
    let failed = |error| format!("{}: {error}", file.display());
    let bytes = std::fs::read(file).map_err(failed)?;
    let mut out = Vec::new();
    zopfli::compress(zopfli::Options::default(), zopfli::Format::Gzip, bytes.as_slice(), &mut out)
        .map_err(failed)?;
    Ok(out.len())
}

/// Runs the tests of the archive in Node and in a browser, with the answers of a command.
pub(crate) fn test(package: &Path, command: &Path) -> Outcome {
    let mut tests = Command::new("node");
    tests.args(["--test", "test/node.test.mjs", "test/browser.test.mjs"]).current_dir(root().join("npm"));
    run_beside(tests.env("CHROMIUM", chromium()?).env("POLHODE", command).env("POLHODE_PACKAGE", package))
}
