//! Work tree of a repository, with its name and commit.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::process::output;

/// Work tree of a repository.
#[derive(Debug)]
pub(super) struct Repository {
    /// Name of the repository, `OWNER/NAME`.
    pub(super) name: String,
    pub(super) commit: String,
    pub(super) folder: PathBuf,
    /// Parent folders of packages, relative to the work tree.
    pub(super) roots: BTreeSet<PathBuf>,
    /// Number of files of the commit that are missing from the work tree.
    pub(super) absent: usize,
}

impl Repository {
    /// Reads the work tree in a folder.
    ///
    /// Its name is that of the remote `origin`, or the last two folders of the path.
    pub(super) fn at(folder: &Path) -> Result<Self, String> {
        let folder =
            std::fs::canonicalize(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let git = |arguments: &[&str]| output(Command::new("git").arg("-C").arg(&folder).args(arguments));
        let commit = git(&["log", "-1", "--format=%H"])?.trim().to_owned();
        let url = git(&["remote", "get-url", "origin"]).unwrap_or_else(|_| folder.display().to_string());
        let url = url.trim().trim_end_matches(".git").replace(['\\', ':'], "/");
        let mut last = url.rsplit('/');
        let name = last.next().unwrap_or_default();
        let name = format!("{}/{name}", last.next().unwrap_or_default());
        let listed = git(&["ls-tree", "-r", "-z", "HEAD"])?;
        let is_absent = |line: &&str| {
            let Some((kind, path)) = line.split_once('\t') else { return false };
            kind.starts_with("100") && !folder.join(path).is_file()
        };
        let absent = listed.split('\0').filter(is_absent).count();
        let mut roots = BTreeSet::from([PathBuf::from(".")]);
        packages(&folder, Path::new("."), &mut roots)?;
        Ok(Self { name, commit, folder, roots, absent })
    }
}

/// Adds the parent folder of each package.
fn packages(tree: &Path, within: &Path, roots: &mut BTreeSet<PathBuf>) -> Result<(), String> {
    let folder = tree.join(within);
    if ["package.xml", "model.config"].iter().any(|file| folder.join(file).is_file())
        && let Some(around) = within.parent().filter(|around| !around.as_os_str().is_empty())
    {
        roots.insert(around.to_owned());
    }
    let unreadable = |error| format!("{}: {error}", folder.display());
    for entry in std::fs::read_dir(&folder).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let is_hidden = entry.file_name().as_encoded_bytes().starts_with(b".");
        if !is_hidden && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            packages(tree, &within.join(entry.file_name()), roots)?;
        }
    }
    Ok(())
}
