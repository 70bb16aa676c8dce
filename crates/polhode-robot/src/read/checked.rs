//! Folder that is checked as a whole, and the index of the packages below it.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use polhode_source::files::{Files, Kind};

use super::package::package_name;

/// Folder whose models are checked together, with the packages below it by name.
#[derive(Debug)]
pub struct CheckedFolder {
    /// Path as the user named it.
    named: PathBuf,
    /// Canonical path.
    path: PathBuf,
    /// Folders by name and by the name in their `package.xml`; computed at the first lookup of a
    /// package.
    packages: OnceLock<HashMap<String, Vec<PathBuf>>>,
}

impl PartialEq for CheckedFolder {
    fn eq(&self, other: &Self) -> bool {
        self.named == other.named && self.path == other.path
    }
}

impl Eq for CheckedFolder {}

impl CheckedFolder {
    /// Returns the folder; `None` if it does not exist.
    pub fn new(files: &dyn Files, named: &Path) -> Option<Self> {
        let path = files.canonical(named).ok()?;
        files.look(&path).is_ok_and(|look| look.is_folder()).then_some(())?;
        Some(Self { named: named.to_owned(), path, packages: OnceLock::new() })
    }

    /// Returns true if a path begins with the folder. Both paths are as the user names them.
    pub fn names(&self, path: &Path) -> bool {
        path.starts_with(&self.named)
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the folders with this name, among this folder and those below it.
    pub(super) fn packages(&self, files: &dyn Files, name: &str) -> &[PathBuf] {
        let packages = self.packages.get_or_init(|| packages(files, &self.path));
        packages.get(name).map_or(&[], Vec::as_slice)
    }
}

/// Returns all folders by name, sorted. Hidden folders are skipped. Symbolic links are not
/// followed, so the search ends.
fn packages(files: &dyn Files, root: &Path) -> HashMap<String, Vec<PathBuf>> {
    let mut packages: HashMap<String, Vec<PathBuf>> = HashMap::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let own = folder.file_name().map(|name| name.to_string_lossy().into_owned());
        let stated = package_name(files, &folder, |file| file.starts_with(root))
            .filter(|name| own.as_ref() != Some(name));
        for name in own.into_iter().chain(stated) {
            packages.entry(name).or_default().push(folder.clone());
        }
        let is_seen =
            |path: &Path| path.file_name().is_some_and(|name| !name.as_encoded_bytes().starts_with(b"."));
        let inner = files.entries(&folder).into_iter().flatten();
        let inner = inner.filter(|(path, kind)| *kind == Kind::Folder && is_seen(path));
        folders.extend(inner.map(|(path, _)| path));
    }
    packages.values_mut().for_each(|folders| folders.sort());
    packages
}
