//! Models that a request names: files, and folders that are searched; names of files in reports.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Component, Path, PathBuf};

use polhode_source::files::{Files, Kind};
use polhode_source::{Failure, shown};

use crate::read::is_model;

/// Path of a model; or the path of a file or folder without a model, with the reason.
pub(crate) type Found = Result<PathBuf, (PathBuf, Failure)>;

/// Returns all models in the order of the request, and the alternative names of models that are
/// named twice.
///
/// The models of a folder are sorted by name. A folder that cannot be searched or has no model is
/// listed as a failure in their place. In a folder, models are recognized by extension and root
/// element, and hidden folders are skipped. Symbolic links are followed. Each folder is searched
/// once, so circular links end.
pub(crate) fn models(files: &dyn Files, named: &[PathBuf]) -> (Vec<Found>, Vec<[PathBuf; 2]>) {
    let mut models = Vec::new();
    for path in named {
        if !is_folder(files, path) {
            models.push(Ok(path.clone()));
            continue;
        }
        let before = models.len();
        search(files, path, &mut models);
        if models.len() == before {
            let hint = "model files have the extension .urdf, .sdf, .world, .xml, .usd, .usda, .usdc, .usdz or .osim; name a file with another extension directly";
            models.push(unread(path, format!("{} contains no model", shown(path)), hint));
        }
    }
    let (mut names, mut repeated): (BTreeMap<PathBuf, PathBuf>, _) = (BTreeMap::new(), Vec::new());
    let is_first = |input: &Found| {
        let Ok(path) = input else { return true };
        let Ok(real) = files.canonical(path) else { return true };
        match names.entry(real) {
            Entry::Vacant(place) => {
                place.insert(path.clone());
                true
            }
            Entry::Occupied(first) => {
                repeated.push([path.clone(), first.get().clone()]);
                false
            }
        }
    };
    models.retain(is_first);
    (models, repeated)
}

pub(crate) fn is_folder(files: &dyn Files, path: &Path) -> bool {
    files.look(path).is_ok_and(|look| look.is_folder())
}

fn unread(path: &Path, message: String, hint: &str) -> Found {
    Err((path.to_owned(), Failure::usage(message, hint).in_file(path)))
}

fn search(files: &dyn Files, root: &Path, models: &mut Vec<Found>) {
    let mut searched = BTreeSet::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let is_new = files.canonical(&folder).map(|real| searched.insert(real));
        let entries = match is_new {
            Ok(false) => continue,
            Ok(true) => visible(files, &folder),
            Err(error) => Err(error),
        };
        match entries {
            Ok(entries) => {
                let (inner, own): (Vec<_>, Vec<_>) =
                    entries.into_iter().partition(|(_, is_folder)| *is_folder);
                models.extend(
                    own.into_iter().map(|(file, _)| file).filter(|file| is_model(files, file)).map(Ok),
                );
                folders.extend(inner.into_iter().rev().map(|(folder, _)| folder));
            }
            Err(error) => {
                let message = format!("cannot search {}: {error}", shown(&folder));
                models.push(unread(&folder, message, "name the files instead"));
            }
        }
    }
}

/// Returns the entries of a folder that are not hidden, sorted by name. The flag is true for
/// folders and links to folders.
fn visible(files: &dyn Files, folder: &Path) -> io::Result<Vec<(PathBuf, bool)>> {
    let is_seen =
        |path: &Path| path.file_name().is_some_and(|name| !name.as_encoded_bytes().starts_with(b"."));
    let mut entries: Vec<(PathBuf, bool)> = Vec::new();
    for (path, kind) in files.entries(folder)?.into_iter().filter(|(path, _)| is_seen(path)) {
        let is_folder = kind == Kind::Folder || kind == Kind::Other && is_folder(files, &path);
        entries.push((path, is_folder));
    }
    entries.sort();
    Ok(entries)
}

/// Names of files in globs, baselines and reports.
#[derive(Debug)]
pub(crate) struct Names<'a> {
    files: &'a dyn Files,
    /// Working folder; names of files in it are relative to it.
    here: PathBuf,
}

impl<'a> Names<'a> {
    pub(crate) fn new(files: &'a dyn Files) -> Self {
        let here = files.canonical(Path::new(".")).unwrap_or_default();
        // Windows path without the prefix `\\?\`.
        let plain = here.to_str().and_then(|here| here.strip_prefix(r"\\?\")).map(PathBuf::from);
        Self { files, here: plain.unwrap_or(here) }
    }

    /// Returns the name with slashes, relative to the working folder if the file is in it.
    pub(crate) fn of(&self, path: &Path) -> String {
        let path = path.strip_prefix(&self.here).unwrap_or(path);
        let mut name = String::new();
        for component in path.components() {
            match component {
                Component::CurDir => {}
                Component::RootDir => name.push('/'),
                other => {
                    if !name.is_empty() && !name.ends_with('/') {
                        name.push('/');
                    }
                    name.push_str(&other.as_os_str().to_string_lossy());
                }
            }
        }
        name
    }

    /// Returns the name without `..`, as used in diffs and for included files.
    pub(crate) fn real(&self, path: &Path) -> String {
        let leads_up = path.components().any(|component| component == Component::ParentDir);
        match self.files.canonical(path).ok().filter(|_| leads_up) {
            Some(real) => self.of(&real),
            None => self.of(path),
        }
    }
}
