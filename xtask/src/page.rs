//! The interactive page, `polhode.html`: the engine as a WebAssembly module, and the viewer around it.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use lzma_rust2::{XzOptions, XzWriter};

use crate::module::{self, Build};
use crate::process::{output, run};
use crate::viewer;
use crate::{Outcome, root};

/// Largest size of the page, bytes.
const MOST: u64 = 3_000_000;

/// Length of a match that ends the search for a longer one: the most that XZ permits.
const LONGEST_MATCH: u32 = 273;

/// Builds the module and the page into `target/page/`.
pub(crate) fn build(build: Build) -> Outcome {
    let module = module::build(build, "page", "page", "polhode")?;
    let module = packed(&module, build)?;
    let page = path();
    let mut viewer = Command::new("node");
    viewer.args(["build.mjs", "--module"]).arg(&module).arg("--page").arg(&page);
    if build == Build::Release {
        let commit = output(Command::new("git").args(["rev-parse", "HEAD"]).current_dir(root()))?;
        viewer.args(["--commit", commit.trim()]);
    }
    run(viewer.current_dir(root().join("viewer")))?;
    if build == Build::Release { size() } else { Ok(()) }
}

/// Builds the page quickly, and runs its tests in a browser.
pub(crate) fn check() -> Outcome {
    build(Build::Quick)?;
    viewer::check_page(&path(), &viewer::tested()?)
}

/// Returns the path of the page.
pub(crate) fn path() -> PathBuf {
    module::folder().join("polhode.html")
}

/// Puts the page of a release where the command includes it.
pub(crate) fn release() -> Outcome {
    build(Build::Release)?;
    viewer::check_page(&path(), &viewer::tested()?)?;
    viewer::check_bits()?;
    let committed = root().join("crates/polhode-live/assets/polhode.html");
    std::fs::copy(path(), &committed).map(|_| ()).map_err(|error| format!("{}: {error}", committed.display()))
}

/// Compresses the module as XZ, and returns its new path.
///
/// XZ makes the module of a release 23 % smaller than gzip does.
fn packed(module: &Path, build: Build) -> Result<PathBuf, String> {
    let failed = |error| format!("{}: {error}", module.display());
    let bytes = std::fs::read(module).map_err(failed)?;
    let mut options = XzOptions::with_preset(if build == Build::Release { 9 } else { 0 });
    // Code has no alignment, and its literals follow from the byte before.
    (options.lzma_options.lc, options.lzma_options.pb) = (4, 0);
    if build == Build::Release {
        options.lzma_options.nice_len = LONGEST_MATCH;
    }
    let mut writer = XzWriter::new(Vec::new(), options).map_err(failed)?;
    writer.write_all(&bytes).map_err(failed)?;
    let out = writer.finish().map_err(failed)?;
    println!("   module: {} kB, {} kB compressed", bytes.len() / 1000, out.len() / 1000);
    let packed = module.with_extension("wasm.xz");
    std::fs::write(&packed, out).map_err(failed)?;
    Ok(packed)
}

/// Checks the size of a release.
fn size() -> Outcome {
    let page = path();
    let length = std::fs::metadata(&page).map_err(|error| format!("{}: {error}", page.display()))?.len();
    if length <= MOST { Ok(()) } else { Err(format!("the page has {length} bytes, more than {MOST}")) }
}
