//! Licence texts of all linked crates, which must accompany the program.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::dependencies::tree;
use crate::{files, read, root};

const INTRODUCTION: &str = "\
What is linked into polhode, beside its own code, and under which licences. Where a licence is one of several, any of them may be chosen.
";

/// Prefixes of the names of licence files.
const NAMES: [&str; 6] = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"];

/// Returns the licence texts of the crates that are linked into the command.
pub(crate) fn notices(target: &str) -> Result<String, String> {
    notices_of(&["--package", "polhode-cli", "--target", target])
}

/// Returns each distinct licence text once, after the names of the crates with this text. `linked`
/// are arguments of `cargo tree`: package, features and target.
pub(crate) fn notices_of(linked: &[&str]) -> Result<String, String> {
    let packages = tree(&[linked, &["--edges", "normal"]].concat())?;
    let sources = sources()?;
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let ours = root().display().to_string();
    for (package, licence) in packages.iter().filter(|(package, _)| !package.contains(&ours)) {
        let (name, version) = package.split_once(" v").ok_or_else(|| format!("{package}: no version"))?;
        let version = version.split(' ').next().unwrap_or_default();
        let folder = format!("{name}-{version}");
        let found = sources.iter().map(|source| source.join(&folder)).find(|folder| folder.is_dir());
        let found = found.ok_or_else(|| format!("{folder} is not among the sources that cargo has"))?;
        let licences = licences(&found)?;
        if licences.is_empty() {
            return Err(format!("{folder} ({licence}) has no file with its licence"));
        }
        for text in licences {
            texts.entry(text).or_default().push(format!("{name} {version} ({licence})"));
        }
    }
    for file in files(&root().join("crates/polhode-document/assets"), "txt")? {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        texts.entry(read(&file)?).or_default().push(name);
    }
    let mut sections: Vec<(String, String)> =
        texts.into_iter().map(|(text, names)| (names.join("\n"), text)).collect();
    sections.sort();
    let line = "-".repeat(80);
    let sections = sections.iter().map(|(names, text)| format!("\n{line}\n{names}\n\n{}\n", text.trim_end()));
    Ok(std::iter::once(INTRODUCTION.to_owned()).chain(sections).collect())
}

/// Returns cargo's folders of registry sources.
fn sources() -> Result<Vec<PathBuf>, String> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| std::env::home_dir().map(|home| home.join(".cargo")));
    let folder = home.ok_or("where is CARGO_HOME?")?.join("registry/src");
    let entries = std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    entries.map(|entry| entry.map(|entry| entry.path()).map_err(|error| error.to_string())).collect()
}

/// Returns the licence texts of a package, with Unix line ends.
fn licences(package: &Path) -> Result<Vec<String>, String> {
    let entries = std::fs::read_dir(package).map_err(|error| format!("{}: {error}", package.display()))?;
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| error.to_string())?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        if path.is_file() && NAMES.iter().any(|start| name.starts_with(start)) {
            found.push(read(&path)?.replace("\r\n", "\n"));
        }
    }
    found.sort();
    Ok(found)
}
