//! A release: one folder, `target/upload/`, with all that is uploaded.
//!
//! The workflow of releases makes archives and wheels of other platforms by the same tasks.
//! [`check`] uses each artefact where nothing of this project is installed.

mod check;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::archive::sha256_line;
use crate::process::{build_folder, copy, output, run};
use crate::{
    Outcome, book, dist, files, installation, module, npm, packages, page, python, read, root, sbom, vscode,
};

pub(crate) use check::check;

/// Tools that build wheels for older systems, with versions as in the workflow of releases.
const TOOLS: [&str; 3] = ["maturin==1.16.0", "ziglang==0.17.1", "cargo-zigbuild==0.24.1"];

/// Oldest glibc of the archive, and the platform tag of the wheel.
const GLIBC: &str = ".2.17";
const PLATFORM: &str = "manylinux_2_28";

/// Largest size of the archive, bytes.
const MOST: u64 = 15_000_000;

/// First answers from each artefact; [`check`] runs the commands.
const START: &str = include_str!("release/start.md");

/// File of a release with the commit that it was made of.
const COMMIT: &str = "COMMIT";

/// Makes every artefact of the last commit.
pub(crate) fn make() -> Outcome {
    let changed = output(Command::new("git").args(["status", "--porcelain"]).current_dir(root()))?;
    if !changed.is_empty() {
        return Err(format!("a release is made of a commit; commit or remove these files first:\n{changed}"));
    }
    let folder = folder()?;
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    take(&[npm::build(module::Build::Release)?], &folder)?;
    page::build(module::Build::Release)?;
    take(&[page::path()], &folder)?;
    compiled(&folder)?;
    take(&[vscode::package(&dist::program(&dist::host()?))?], &folder)?;
    take(&files(&packages::compiled(&head()?)?, "crate")?, &folder.join("crates"))?;
    book::build(false)?;
    copy(&in_target("book")?, &folder.join("site"))?;
    take(&[page::path()], &folder.join("site"))?;
    let triple = dist::host()?;
    write(&folder.join("polhode.cdx.json"), &sbom::bill(&triple)?)?;
    write(&folder.join("NOTES.md"), &notes(&read(&root().join("CHANGELOG.md"))?)?)?;
    write(&folder.join("START.md"), &START.replace("VERSION", VERSION).replace("TRIPLE", &triple))?;
    write(&folder.join(COMMIT), &head()?)?;
    for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
        take(&[root().join(name)], &folder)?;
    }
    write(&folder.join("SHA256SUMS"), &sums(&folder)?)?;
    println!("   {}", folder.display());
    Ok(())
}

/// Returns true if the last commit has been made into a release.
fn is_made() -> Result<bool, String> {
    let head = head()?;
    Ok(std::fs::read_to_string(folder()?.join(COMMIT)).is_ok_and(|commit| commit == head))
}

/// Returns the last commit, with the end of a line.
fn head() -> Result<String, String> {
    output(Command::new("git").args(["rev-parse", "HEAD"]).current_dir(root()))
}

/// Version of all artefacts.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Makes the archive of the command, the wheel and the sdist.
///
/// Uses zig as linker on Linux, for systems with an older glibc than this one.
fn compiled(folder: &Path) -> Outcome {
    let python = python::make(&crate::process::empty_folder("release")?.join("venv"))?;
    run(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(TOOLS))?;
    let tools = python.parent().map(Path::to_owned);
    let found = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(tools.into_iter().chain(std::env::split_paths(&found)))
        .map_err(|error| format!("PATH: {error}"))?;
    let triple = dist::host()?;
    let is_glibc = triple.ends_with("linux-gnu");
    let this = std::env::current_exe().map_err(|error| format!("where is this program? {error}"))?;
    let target = if is_glibc { format!("{triple}{GLIBC}") } else { triple.clone() };
    let begun = Instant::now();
    run(Command::new(this).args(["dist", "--target", &target]).env("PATH", &path))?;
    installation::check_build_time(begun.elapsed().as_secs_f64())?;
    take(&[dist::archive(&triple)], folder)?;
    let mut maturin = Command::new(python.with_file_name("maturin"));
    maturin.args(["build", "--release", "--locked", "--target", &triple, "--out"]).arg(folder);
    if is_glibc {
        maturin.args(["--zig", "--compatibility", PLATFORM]);
    }
    let manifest = root().join("crates/polhode-py/Cargo.toml");
    run(maturin
        .arg("--manifest-path")
        .arg(&manifest)
        .env("PATH", &path)
        .env(dist::FLAGS, dist::flags(&triple)))?;
    let mut sdist = Command::new(python.with_file_name("maturin"));
    run(sdist.args(["sdist", "--out"]).arg(folder).arg("--manifest-path").arg(&manifest))
}

/// Returns the changes of this version: its section of the changelog, after that of the next version
/// if this one has no date.
fn notes(changelog: &str) -> Result<String, String> {
    let section = |name: &str| {
        let (_, rest) = changelog.split_once(&format!("\n## [{name}]"))?;
        let (heading, text) = rest.split_once('\n')?;
        Some((heading.trim(), text.split("\n## ").next().unwrap_or(text).trim()))
    };
    let is_dated = |(heading, _): &(&str, &str)| heading.ends_with(|c: char| c.is_ascii_digit());
    let this = section(VERSION);
    let next = section("Unreleased").filter(|_| !this.as_ref().is_some_and(is_dated));
    let texts: Vec<&str> = next.into_iter().chain(this).map(|(_, text)| text).collect();
    if texts.is_empty() {
        return Err("CHANGELOG.md has no section for this version".to_owned());
    }
    Ok(format!("# polhode {VERSION}\n\nFirst answers from each file: START.md.\n\n{}\n", texts.join("\n\n")))
}

/// Returns the checksums of all files in a folder, with paths relative to it.
fn sums(folder: &Path) -> Result<String, String> {
    let mut lines = Vec::new();
    for path in all(folder)? {
        let bytes = std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.strip_prefix(folder).unwrap_or(&path).display().to_string().replace('\\', "/");
        lines.push(sha256_line(&name, &bytes));
    }
    Ok(lines.concat())
}

/// Returns all files below a folder, in order.
fn all(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let failed = |error| format!("{}: {error}", folder.display());
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() { found.extend(all(&path)?) } else { found.push(path) }
    }
    found.sort();
    Ok(found)
}

/// Copies files into a folder, which is made.
fn take(files: &[PathBuf], folder: &Path) -> Outcome {
    let failed = |error| format!("{}: {error}", folder.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    for file in files {
        let name = file.file_name().ok_or_else(|| format!("{} has no name", file.display()))?;
        std::fs::copy(file, folder.join(name)).map_err(|error| format!("{}: {error}", file.display()))?;
    }
    Ok(())
}

/// Returns the only file of a folder with this ending.
fn one(folder: &Path, ending: &str) -> Result<PathBuf, String> {
    let mut found: Vec<_> =
        all(folder)?.into_iter().filter(|path| path.to_string_lossy().ends_with(ending)).collect();
    match (found.pop(), found.len()) {
        (Some(path), 0) => Ok(path),
        _ => Err(format!("{} does not have one file *{ending}", folder.display())),
    }
}

fn write(path: &Path, text: &str) -> Outcome {
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// Returns the folder of the release.
fn folder() -> Result<PathBuf, String> {
    in_target("upload")
}

/// Returns a folder of the build output.
fn in_target(name: &str) -> Result<PathBuf, String> {
    Ok(build_folder()?.with_file_name(name))
}

#[cfg(test)]
mod tests {
    use super::{VERSION, notes};

    #[test]
    fn the_notes_are_those_of_the_version_and_of_the_next_one_before_the_release() {
        let next = "# Changelog\n\n## [Unreleased]\n\n- A top.\n\n## [0.0.1] - 2026-01-01\n\n- A body.\n";
        assert!(notes(next).is_ok_and(|text| text.ends_with("START.md.\n\n- A top.\n")));
        let this = next.replace("0.0.1", VERSION);
        assert!(notes(&this).is_ok_and(|text| text.ends_with("START.md.\n\n- A body.\n")));
        let both = this.replace("2026-01-01", "unreleased");
        assert!(notes(&both).is_ok_and(|text| text.ends_with("START.md.\n\n- A top.\n\n- A body.\n")));
        assert!(notes("# Changelog\n").is_err());
    }
}
