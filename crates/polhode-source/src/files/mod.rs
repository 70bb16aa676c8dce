//! Files: folders of this machine, files in memory, and the rule which of them may be opened.

mod confined;
mod disk;
mod listed;
mod memory;

use std::fmt;
use std::io::{self, Read, Seek};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

pub use confined::{Confined, NotOpened, is_path_of};
pub use disk::Disk;
pub use listed::Listed;
pub use memory::Memory;

/// Place that readers take all their files from.
///
/// [`Disk`] is this machine, [`Memory`] holds files that somebody gave (a page, a test), [`Confined`] limits another
/// one to some folders. A reader that takes `&dyn Files` opens no file in any other way.
///
/// ```
/// use polhode_source::files::{Files, Memory};
/// let files = Memory::from([("parts/list.csv", "name,mass\nbox,1 kg\n")]);
/// let length = polhode_source::read_file(&files, "parts/list.csv".as_ref(), |bytes| Ok(bytes.len()))?;
/// assert_eq!(length, 19);
/// assert!(files.look("parts".as_ref())?.is_folder());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Files: fmt::Debug + Sync {
    /// Opens a file for reading.
    ///
    /// # Errors
    /// What the system says of a path that cannot be opened, or that may not be.
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>>;

    /// Returns what is at a path. Links are followed.
    ///
    /// # Errors
    /// What the system says, most often that there is nothing.
    fn look(&self, path: &Path) -> io::Result<Look>;

    /// Returns the one absolute path of a file or folder, without links.
    ///
    /// # Errors
    /// As [`Files::look`].
    fn canonical(&self, path: &Path) -> io::Result<PathBuf>;

    /// Returns the paths of what is in a folder, in no order, with its kind; links are [`Kind::Other`].
    ///
    /// # Errors
    /// As [`Files::look`], and if it is no folder.
    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>>;

    /// Returns the path of a file that another file names: relative to its folder, or absolute.
    ///
    /// # Errors
    /// [`NotOpened`] if a file may not name it.
    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened>;

    /// Returns true for a regular file.
    fn is_file(&self, path: &Path) -> bool {
        self.look(path).is_ok_and(|look| look.is_file())
    }
}

/// Open file.
pub trait OpenFile: Read + Seek + Send + Sync + fmt::Debug {
    /// Returns what the system says of the file now.
    ///
    /// # Errors
    /// What the system says.
    fn look(&self) -> io::Result<Look>;
}

/// What is at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Kind of what is there.
    pub kind: Kind,
    /// Number of bytes; 0 for files that the system makes up as they are read.
    pub length: u64,
    /// Time of the last change, where it is known.
    pub changed: Option<SystemTime>,
}

/// Kind of what is at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Regular file.
    File,
    /// Folder.
    Folder,
    /// Pipe, device or socket.
    Other,
}

impl Look {
    /// Returns true for a regular file.
    pub fn is_file(&self) -> bool {
        self.kind == Kind::File
    }

    /// Returns true for a folder.
    pub fn is_folder(&self) -> bool {
        self.kind == Kind::Folder
    }
}

/// Returns the path without `.` and `..`, by its words alone.
pub(crate) fn lexical(path: &Path) -> PathBuf {
    use std::path::Component;
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}
