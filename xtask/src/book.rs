//! Site of the book: pages of `book/` built by Sphinx, documentation of the crates, and a check of
//! all links.
//!
//! This requires Python and its package index, unlike a build of the command.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::{FEATURES, build_folder, cargo, copy, empty_folder, run, run_beside};
use crate::{Outcome, python, read, root, viewer};

/// Python executable of an environment with Sphinx.
#[derive(Debug)]
pub(crate) struct Environment(PathBuf);

/// Builds the site in `target/book`; opens it in a browser if `open`.
pub(crate) fn build(open: bool) -> Outcome {
    let environment = environment()?;
    document_crates()?;
    build_in(&environment)?;
    if open { open_in_browser(&site()?.join("index.html")) } else { Ok(()) }
}

/// Installs the packages of `book/site/requirements.txt`, checked by their hashes.
///
/// An existing environment for the same list is reused.
pub(crate) fn environment() -> Result<Environment, String> {
    let list = root().join("book/site/requirements.txt");
    let wanted = read(&list)?;
    let folder = build_folder()?.join("xtask-tmp/book");
    let installed = folder.join("installed.txt");
    let python = folder.join("venv").join(python::EXECUTABLE);
    if python.is_file() && std::fs::read_to_string(&installed).is_ok_and(|text| text == wanted) {
        return Ok(Environment(python));
    }
    let folder = empty_folder("book")?;
    let python = python::make(&folder.join("venv"))?;
    run(Command::new(&python)
        .args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--no-compile",
            "--require-hashes",
            "--only-binary",
            ":all:",
            "--requirement",
        ])
        .arg(&list))?;
    std::fs::write(&installed, wanted).map_err(|error| format!("{}: {error}", installed.display()))?;
    Ok(Environment(python))
}

/// Documents the crates in an empty folder, because rustdoc keeps pages of removed items; warnings
/// are errors.
pub(crate) fn document_crates() -> Outcome {
    let folder = documentation()?;
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let doc = ["doc", "--workspace", "--lib", "--no-deps", "--locked", "--features", FEATURES];
    run_beside(cargo(&doc).env("RUSTDOCFLAGS", "-D warnings"))
}

pub(crate) fn documentation() -> Result<PathBuf, String> {
    Ok(build_folder()?.with_file_name("doc"))
}

/// Builds the site with existing documentation of the crates.
///
/// Warnings are errors, such as a broken link or a page outside the navigation.
pub(crate) fn build_in(Environment(python): &Environment) -> Outcome {
    let (root, site) = (root(), site()?);
    if site.exists() {
        std::fs::remove_dir_all(&site).map_err(|error| format!("{}: {error}", site.display()))?;
    }
    let here = |arguments: &[&str]| {
        let mut command = Command::new(python);
        command.args(arguments).current_dir(&root).env("PYTHONDONTWRITEBYTECODE", "1");
        command
    };
    let trees = build_folder()?.join("xtask-tmp/book-trees");
    run(here(&["-m", "sphinx", "--builder", "html", "--quiet", "--fresh-env", "--fail-on-warning"])
        .args(["--conf-dir", "book/site", "--doctree-dir"])
        .arg(trees)
        .arg(".")
        .arg(&site))?;
    copy(&documentation()?, &site.join("rust"))?;
    run(here(&["book/site/links.py"]).arg(&site))?;
    println!("   {}", site.join("index.html").display());
    Ok(())
}

/// Checks the links of a copy of the site, and its front page and search in a browser.
pub(crate) fn check_site(site: &Path) -> Outcome {
    let Environment(python) = environment()?;
    run(Command::new(python).arg(root().join("book/site/links.py")).arg(site))?;
    let mut test = Command::new("node");
    test.arg("test/site.mjs").arg(site).current_dir(root().join("viewer"));
    run_beside(test.env("CHROMIUM", viewer::chromium()?))
}

fn site() -> Result<PathBuf, String> {
    Ok(build_folder()?.with_file_name("book"))
}

fn open_in_browser(page: &Path) -> Outcome {
    let program = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    run(Command::new(program).arg(page))
}
