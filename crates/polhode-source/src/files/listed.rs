//! Access to listed files only.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};

use super::{Files, Kind, Look, NotOpened, OpenFile};

/// Files restricted to a list: a text may name only files that were opened together with it.
#[derive(Clone, Copy, Debug)]
pub struct Listed<'a> {
    /// Underlying source of files.
    pub files: &'a dyn Files,
    /// Allowed paths, as resolved from the text.
    pub paths: &'a BTreeSet<PathBuf>,
}

impl Files for Listed<'_> {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        self.files.open(path)
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        self.files.look(path)
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.files.canonical(path)
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        self.files.entries(folder)
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        let path = folder.join(name);
        if self.paths.contains(&path) { self.files.named(folder, name) } else { Err(NotOpened::NotGiven) }
    }
}
