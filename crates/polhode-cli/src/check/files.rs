//! The models that a command line names: files as they are, folders searched.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::model_file::is_model;

/// All models, in the order of the command line, those of a folder by name.
///
/// In a folder only files that are models by ending and root element count, and hidden folders are left out. Links are
/// followed; a folder that has been searched is not searched again, so that links in a circle end.
pub(super) fn models(named: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut models = Vec::new();
    for path in named {
        if !path.is_dir() {
            models.push(path.clone());
            continue;
        }
        let before = models.len();
        search(path, &mut models)?;
        if models.len() == before {
            return Err(Failure::usage(
                format!("{} holds no model", path.display()),
                "a model ends in .urdf, .sdf, .world or .xml; name a file with another ending by itself",
            ));
        }
    }
    Ok(models)
}

fn search(root: &Path, models: &mut Vec<PathBuf>) -> Result<(), Failure> {
    let mut searched = BTreeSet::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        let failed = |error: io::Error| {
            Failure::usage(format!("cannot search {}: {error}", folder.display()), "name the files instead")
        };
        if !searched.insert(fs::canonicalize(&folder).map_err(failed)?) {
            continue;
        }
        let entries =
            fs::read_dir(&folder).and_then(Iterator::collect::<io::Result<Vec<_>>>).map_err(failed)?;
        let mut paths: Vec<PathBuf> =
            entries.into_iter().filter(|e| !is_hidden(e)).map(|e| e.path()).collect();
        paths.sort();
        let (inner, files): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_dir());
        models.extend(files.into_iter().filter(|file| is_model(file)));
        folders.extend(inner.into_iter().rev());
    }
    Ok(())
}

fn is_hidden(entry: &fs::DirEntry) -> bool {
    entry.file_name().as_encoded_bytes().starts_with(b".")
}
