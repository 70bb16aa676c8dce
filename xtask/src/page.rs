//! The interactive page, `polhode.html`: the engine as a WebAssembly module, and the viewer around it.

use std::process::Command;

use crate::module::{self, Build};
use crate::process::{output, run};
use crate::viewer;
use crate::{Outcome, root};

/// Largest size of the page, bytes.
const MOST: u64 = 3_000_000;

/// Builds the module and the page into `target/page/`.
pub(crate) fn build(build: Build) -> Outcome {
    let module = module::build(build, "page", "page", "polhode")?;
    let module = if build == Build::Release { module::packed(&module)? } else { module };
    let page = module::folder().join("polhode.html");
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
    viewer::check_page()
}

/// Puts the page of a release where the command includes it.
pub(crate) fn release() -> Outcome {
    build(Build::Release)?;
    viewer::check_page()?;
    viewer::check_bits()?;
    let committed = root().join("crates/polhode-live/assets/polhode.html");
    std::fs::copy(module::folder().join("polhode.html"), &committed)
        .map(|_| ())
        .map_err(|error| format!("{}: {error}", committed.display()))
}

/// Checks the size of a release.
fn size() -> Outcome {
    let page = module::folder().join("polhode.html");
    let length = std::fs::metadata(&page).map_err(|error| format!("{}: {error}", page.display()))?.len();
    if length <= MOST { Ok(()) } else { Err(format!("the page has {length} bytes, more than {MOST}")) }
}
