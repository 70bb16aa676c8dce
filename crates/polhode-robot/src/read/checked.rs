//! Folder that is checked: searched once for packages that no root holds.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::package::package_name;

/// A folder whose models are checked together, with the packages below it by their names.
#[derive(Debug)]
pub struct CheckedFolder {
    /// Path as the user named it.
    named: PathBuf,
    /// Canonical path.
    path: PathBuf,
    /// Folders by their names and by the name in their `package.xml`; found when a package is first looked up.
    packages: OnceLock<HashMap<String, Vec<PathBuf>>>,
}

impl PartialEq for CheckedFolder {
    fn eq(&self, other: &Self) -> bool {
        self.named == other.named && self.path == other.path
    }
}

impl Eq for CheckedFolder {}

impl CheckedFolder {
    /// Returns `None` if the folder does not exist.
    pub fn new(named: &Path) -> Option<Self> {
        let path = fs::canonicalize(named).ok().filter(|path| path.is_dir())?;
        Some(Self { named: named.to_owned(), path, packages: OnceLock::new() })
    }

    /// Returns true if a path begins with the folder, both as the user names them.
    pub fn names(&self, path: &Path) -> bool {
        path.starts_with(&self.named)
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Folders below, or the folder itself, that are called so.
    pub(super) fn packages(&self, name: &str) -> &[PathBuf] {
        let packages = self.packages.get_or_init(|| packages(&self.path));
        packages.get(name).map_or(&[], Vec::as_slice)
    }
}

/// All folders by their names, sorted. Hidden folders are left out. Links are not followed, so the search ends.
fn packages(root: &Path) -> HashMap<String, Vec<PathBuf>> {
    let mut packages: HashMap<String, Vec<PathBuf>> = HashMap::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let own = folder.file_name().map(|name| name.to_string_lossy().into_owned());
        let stated =
            package_name(&folder, |file| file.starts_with(root)).filter(|name| own.as_ref() != Some(name));
        for name in own.into_iter().chain(stated) {
            packages.entry(name).or_default().push(folder.clone());
        }
        let Ok(entries) = fs::read_dir(&folder) else { continue };
        let is_folder = |entry: &fs::DirEntry| {
            !entry.file_name().as_encoded_bytes().starts_with(b".")
                && entry.file_type().is_ok_and(|kind| kind.is_dir())
        };
        folders.extend(entries.flatten().filter(is_folder).map(|entry| entry.path()));
    }
    packages.values_mut().for_each(|folders| folders.sort());
    packages
}
