//! Files in memory.

use std::collections::BTreeMap;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Files, Kind, Look, NotOpened, OpenFile, lexical};

/// Files in memory by path, such as the files opened in a web page or created by a test. No other
/// files exist.
///
/// A folder exists if a file lies in it. All relative paths have the same base.
///
/// ```
/// use polhode_source::files::{Files, Memory};
/// let files = Memory::from([("arm/link.stl", "solid link\nendsolid\n")]);
/// assert!(files.is_file("arm/../arm/link.stl".as_ref()));
/// assert!(!files.is_file("/etc/hostname".as_ref()));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Memory {
    files: BTreeMap<PathBuf, Arc<[u8]>>,
}

impl Memory {
    /// Adds a file, or replaces the one at its path.
    pub fn insert(&mut self, path: impl AsRef<Path>, bytes: impl Into<Arc<[u8]>>) {
        self.files.insert(lexical(path.as_ref()), bytes.into());
    }

    /// Returns the paths of all files and their contents, in the order of the paths.
    pub fn all(&self) -> impl Iterator<Item = (&Path, &[u8])> {
        self.files.iter().map(|(path, bytes)| (path.as_path(), &**bytes))
    }

    fn bytes(&self, path: &Path) -> io::Result<&Arc<[u8]>> {
        let plain = lexical(path);
        self.files.get(&plain).ok_or_else(|| match self.is_folder(&plain) {
            true => io::ErrorKind::IsADirectory.into(),
            false => io::ErrorKind::NotFound.into(),
        })
    }

    fn is_folder(&self, plain: &Path) -> bool {
        plain.as_os_str().is_empty() || self.files.keys().any(|file| file != plain && file.starts_with(plain))
    }
}

impl<P: AsRef<Path>, B: AsRef<[u8]>, const N: usize> From<[(P, B); N]> for Memory {
    fn from(files: [(P, B); N]) -> Self {
        let mut memory = Self::default();
        files.iter().for_each(|(path, bytes)| memory.insert(path, bytes.as_ref()));
        memory
    }
}

impl Files for Memory {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        Ok(Box::new(Cursor::new(self.bytes(path)?.clone())))
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        let look = |kind, length| Look { kind, length, changed: None };
        match self.bytes(path) {
            Ok(bytes) => Ok(look(Kind::File, bytes.len() as u64)),
            Err(error) if error.kind() == io::ErrorKind::IsADirectory => Ok(look(Kind::Folder, 0)),
            Err(error) => Err(error),
        }
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.look(path).map(|_| lexical(path))
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        let plain = self.canonical(folder)?;
        let mut entries = Vec::new();
        for file in self.files.keys() {
            let Ok(rest) = file.strip_prefix(&plain) else { continue };
            let mut words = rest.components();
            let Some(first) = words.next() else { continue };
            let kind = if words.next().is_some() { Kind::Folder } else { Kind::File };
            entries.push((folder.join(first), kind));
        }
        entries.dedup();
        Ok(entries)
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        let path = folder.join(name);
        if self.is_file(&path) { Ok(path) } else { Err(NotOpened::NotGiven) }
    }
}

impl OpenFile for Cursor<Arc<[u8]>> {
    fn look(&self) -> io::Result<Look> {
        Ok(Look { kind: Kind::File, length: self.get_ref().len() as u64, changed: None })
    }
}
