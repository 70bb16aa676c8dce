//! Sources of files: this machine, memory, and rules that restrict which files may be opened.

mod confined;
mod disk;
mod listed;
mod memory;
mod overlay;
mod recorded;

use std::fmt;
use std::io::{self, Read, Seek};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

pub use confined::{Confined, NotOpened, is_path_of};
pub use disk::Disk;
pub use listed::Listed;
pub use memory::Memory;
pub use overlay::Overlay;
pub use recorded::{Asked, Recorded};

/// Source of all files that a reader opens.
///
/// [`Disk`] is this machine. [`Memory`] holds given files (of a web page, of a test). [`Confined`]
/// limits another source to some folders. A reader with a `&dyn Files` argument opens no file in
/// any other way.
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
    /// I/O error of the system if the path cannot be opened, or may not be.
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>>;

    /// Returns the metadata of a path. Links are followed.
    ///
    /// # Errors
    /// I/O error of the system, mostly [`io::ErrorKind::NotFound`].
    fn look(&self, path: &Path) -> io::Result<Look>;

    /// Returns the absolute path of a file or folder with all links resolved.
    ///
    /// # Errors
    /// Same as [`Files::look`].
    fn canonical(&self, path: &Path) -> io::Result<PathBuf>;

    /// Returns the paths and kinds of the entries of a folder, in no particular order; links are
    /// [`Kind::Other`].
    ///
    /// # Errors
    /// Same as [`Files::look`], and an error if the path is not a folder.
    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>>;

    /// Returns the path of a file that another file names: relative to its folder, or absolute.
    ///
    /// # Errors
    /// [`NotOpened`] if the other file may not open it.
    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened>;

    /// Returns the source in which a path has its own content, if this one replaces that content by
    /// what a program makes of it.
    fn beneath(&self, _path: &Path) -> Option<&dyn Files> {
        None
    }

    /// Returns true for a regular file.
    fn is_file(&self, path: &Path) -> bool {
        self.look(path).is_ok_and(|look| look.is_file())
    }
}

/// Open file.
pub trait OpenFile: Read + Seek + Send + Sync + fmt::Debug {
    /// Returns the current metadata of the file.
    ///
    /// # Errors
    /// I/O error of the system.
    fn look(&self) -> io::Result<Look>;
}

/// Metadata of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Kind of entry.
    pub kind: Kind,
    /// Number of bytes; 0 for virtual files, such as those in /proc.
    pub length: u64,
    /// Time of the last change, if known.
    pub changed: Option<SystemTime>,
}

/// Kind of entry at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Regular file, or a link to one.
    File,
    /// Folder, or a link to one.
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

/// Returns the path with `.` and `..` resolved lexically, without access to the file system.
pub fn lexical(path: &Path) -> PathBuf {
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
