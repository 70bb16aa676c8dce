//! Record of the paths that a reader asks for.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::{Files, Kind, Look, NotOpened, OpenFile};

/// Files of another source, with a record of every path that a reader opens or looks at.
///
/// ```
/// use polhode_source::files::{Files, Memory, Recorded};
/// let mut memory = Memory::from([("arm/arm.urdf", "<robot/>"), ("arm/notes.txt", "")]);
/// let files = Recorded::new(&memory);
/// files.open("arm/arm.urdf".as_ref())?;
/// assert!(!files.is_file("arm/link.stl".as_ref()));
/// let asked = files.end();
/// assert_eq!(asked.files().collect::<Vec<_>>(), ["arm/arm.urdf"]);
/// assert!(asked.is_current(&memory));
/// memory.insert("arm/link.stl", *b"solid");
/// assert!(!asked.is_current(&memory));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Recorded<'a> {
    files: &'a dyn Files,
    asked: Mutex<Asked>,
}

/// Paths that a reader asked for, and their state at that time.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// Metadata of each path before it was first opened; `None` if it did not exist.
    paths: BTreeMap<PathBuf, Option<Look>>,
    /// Folders whose entries were listed.
    listed: BTreeSet<PathBuf>,
    /// Paths that have another canonical path.
    links: BTreeMap<PathBuf, PathBuf>,
}

impl<'a> Recorded<'a> {
    /// Starts a record with no path.
    pub fn new(files: &'a dyn Files) -> Self {
        Self { files, asked: Mutex::default() }
    }

    /// Returns the record.
    pub fn end(self) -> Asked {
        self.asked.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes a path, with its state before the first access.
    fn note(&self, path: &Path) -> MutexGuard<'_, Asked> {
        let mut asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        if !asked.paths.contains_key(path) {
            asked.paths.insert(path.to_owned(), self.files.look(path).ok());
        }
        asked
    }
}

impl Files for Recorded<'_> {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        drop(self.note(path));
        self.files.open(path)
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        drop(self.note(path));
        self.files.look(path)
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        let mut asked = self.note(path);
        let canonical = self.files.canonical(path)?;
        if canonical != path {
            asked.links.insert(path.to_owned(), canonical.clone());
        }
        Ok(canonical)
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        self.note(folder).listed.insert(folder.to_owned());
        self.files.entries(folder)
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        self.files.named(folder, name)
    }
}

impl Asked {
    /// Returns the paths of regular files, in alphabetical order.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.paths.iter().filter(|(_, look)| look.is_some_and(|look| look.is_file())).map(|(path, _)| &**path)
    }

    /// Returns the paths that lead through links, each with its canonical path.
    pub fn links(&self) -> impl Iterator<Item = (&Path, &Path)> {
        self.links.iter().map(|(path, canonical)| (&**path, &**canonical))
    }

    /// Returns true if no path has been written to, created or removed since it was asked for.
    pub fn is_current(&self, files: &dyn Files) -> bool {
        self.paths.iter().all(|(path, before)| {
            let now = files.look(path).ok();
            // The time of a folder changes with each file that a program saves there.
            let is_same_folder = || {
                let is_folder = |look: Option<Look>| look.is_some_and(|look| look.is_folder());
                is_folder(now) && is_folder(*before) && !self.listed.contains(path)
            };
            now == *before || is_same_folder()
        })
    }
}
