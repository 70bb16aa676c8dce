//! The models that a command line names: files as they are, folders searched.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use polhode_source::shown;

use crate::failure::Failure;
use crate::model_file::is_model;
use crate::stderr::tell;

/// A file or folder of which there is no report.
#[derive(Debug)]
pub(super) struct Unread {
    pub(super) path: PathBuf,
    pub(super) failure: Failure,
}

impl Unread {
    fn new(path: &Path, message: String, hint: &str) -> Self {
        Self { path: path.to_owned(), failure: Failure::usage(message, hint).about(path) }
    }
}

/// All models, in the order of the command line, those of a folder by name; a folder that cannot be searched, or is searched in vain,
/// stands in the place of its models.
///
/// In a folder only files that are models by ending and root element count, and hidden folders are left out. Links are
/// followed; a folder that has been searched is not searched again, so that links in a circle end.
pub(super) fn models(named: &[PathBuf]) -> Vec<Result<PathBuf, Unread>> {
    let mut models: Vec<Result<PathBuf, Unread>> = Vec::new();
    for path in named {
        if !path.is_dir() {
            models.push(Ok(path.clone()));
            continue;
        }
        let before = models.len();
        search(path, &mut models);
        if models.len() == before {
            let hint = "a model ends in .urdf, .sdf, .world, .xml, .usda or .osim; name a file with another ending by itself";
            models.push(Err(Unread::new(path, format!("{} holds no model", shown(path)), hint)));
        }
    }
    once(models)
}

/// Each file under the first of its names; the others are said.
fn once(models: Vec<Result<PathBuf, Unread>>) -> Vec<Result<PathBuf, Unread>> {
    let mut names: BTreeMap<PathBuf, PathBuf> = BTreeMap::new();
    let is_first = |input: &Result<PathBuf, Unread>| {
        let Ok(path) = input else { return true };
        let Ok(real) = fs::canonicalize(path) else { return true };
        match names.entry(real) {
            Entry::Vacant(place) => {
                place.insert(path.clone());
                true
            }
            Entry::Occupied(first) => {
                let message = format!("{} is {}, which is checked once", shown(path), shown(first.get()));
                tell(&format!("{message}\n"));
                false
            }
        }
    };
    models.into_iter().filter(is_first).collect()
}

/// What globs, baselines and reports call a file: relative to the working directory if it is in it, with slashes.
pub(super) fn name(path: &Path) -> String {
    let here = env::current_dir().unwrap_or_default();
    let path = path.strip_prefix(&here).unwrap_or(path);
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

/// The same without `..`, as it is in diffs, and of files that a model includes.
pub(super) fn real_name(path: &Path) -> String {
    let leads_up = path.components().any(|component| component == Component::ParentDir);
    match fs::canonicalize(path).ok().filter(|_| leads_up) {
        Some(real) => name(&real),
        None => name(path),
    }
}

fn search(root: &Path, models: &mut Vec<Result<PathBuf, Unread>>) {
    let mut searched = BTreeSet::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let is_new = fs::canonicalize(&folder).map(|real| searched.insert(real));
        let paths = match is_new {
            Ok(false) => continue,
            Ok(true) => visible(&folder),
            Err(error) => Err(error),
        };
        let paths = match paths {
            Ok(paths) => paths,
            Err(error) => {
                let message = format!("cannot search {}: {error}", shown(&folder));
                models.push(Err(Unread::new(&folder, message, "name the files instead")));
                continue;
            }
        };
        let (inner, files): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_dir());
        models.extend(files.into_iter().filter(|file| is_model(file)).map(Ok));
        folders.extend(inner.into_iter().rev());
    }
}

/// What is in a folder and is not hidden, by name.
fn visible(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    let mut paths: Vec<PathBuf> = entries.into_iter().filter(|e| !is_hidden(e)).map(|e| e.path()).collect();
    paths.sort();
    Ok(paths)
}

fn is_hidden(entry: &fs::DirEntry) -> bool {
    entry.file_name().as_encoded_bytes().starts_with(b".")
}
