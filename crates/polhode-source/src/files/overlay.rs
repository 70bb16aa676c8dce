//! Files with other contents over those of another source.

use std::collections::BTreeMap;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Files, Kind, Look, NotOpened, OpenFile};

/// Files of another source, some of them with another content: what a program makes of them.
///
/// A path with another content stays where it is, so that files named relative to it are found.
/// [`Files::beneath`] returns the source with its own content.
///
/// ```
/// use polhode_source::files::{Files, Memory, Overlay};
/// let memory = Memory::from([("arm/arm.xacro", "<robot>${a}</robot>")]);
/// let mut files = Overlay::new(&memory);
/// files.insert("arm/arm.xacro", Ok(b"<robot>1.7</robot>".to_vec()));
/// assert_eq!(files.look("arm/arm.xacro".as_ref())?.length, 18);
/// assert!(files.beneath("arm/arm.xacro".as_ref()).is_some());
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Overlay<'a> {
    files: &'a dyn Files,
    /// Contents by path, or the reason why a path has none.
    contents: BTreeMap<PathBuf, Result<Arc<[u8]>, String>>,
}

impl<'a> Overlay<'a> {
    /// Returns the files of another source without changes.
    pub fn new(files: &'a dyn Files) -> Self {
        Self { files, contents: BTreeMap::new() }
    }

    /// Gives a path another content, or a reason why it cannot be opened.
    pub fn insert(&mut self, path: impl AsRef<Path>, content: Result<Vec<u8>, String>) {
        self.contents.insert(path.as_ref().to_owned(), content.map(Arc::from));
    }

    /// Returns the paths with another content.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.contents.keys().map(PathBuf::as_path)
    }
}

impl Files for Overlay<'_> {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        match self.contents.get(path) {
            Some(Ok(bytes)) => Ok(Box::new(Cursor::new(bytes.clone()))),
            Some(Err(why)) => Err(io::Error::other(why.clone())),
            None => self.files.open(path),
        }
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        let look = self.files.look(path)?;
        Ok(match self.contents.get(path) {
            Some(Ok(bytes)) => Look { kind: Kind::File, length: bytes.len() as u64, ..look },
            _ => look,
        })
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.files.canonical(path)
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        self.files.entries(folder)
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        self.files.named(folder, name)
    }

    fn beneath(&self, path: &Path) -> Option<&dyn Files> {
        self.contents.contains_key(path).then_some(self.files)
    }
}
