//! Folders that the files which a data file names may lie in.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use crate::error::FormatError;
use crate::file;

/// Folders that the files which a data file names may lie in: its own folder, and those that the user allows (`--root`).
///
/// A log, a parts list, a mesh or a robot model is data: it opens no other files, by whatever path, address or link.
///
/// ```
/// use polhode_source::{Confinement, NotOpened};
/// let folder = std::env::temp_dir().join(format!("polhode-confined-{}", std::process::id()));
/// std::fs::create_dir_all(folder.join("inner"))?;
/// std::fs::write(folder.join("inner/a.stl"), "")?;
/// let confinement = Confinement::of(&folder.join("list.csv"), &[]);
/// assert!(confinement.file(&folder, "inner/../inner/a.stl".as_ref()).is_ok());
/// assert_eq!(confinement.file(&folder, "b.stl".as_ref()), Err(NotOpened::Missing));
/// assert_eq!(confinement.file(&folder, "inner".as_ref()), Err(NotOpened::NotRegular));
/// assert_eq!(confinement.file(&folder, "../b.stl".as_ref()), Err(NotOpened::Outside));
/// assert_eq!(confinement.file(&folder, "/etc/hostname".as_ref()), Err(NotOpened::Outside));
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Confinement {
    /// Canonical paths.
    folders: Vec<PathBuf>,
}

/// Reason why a file that a data file names is not opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotOpened {
    /// It lies outside the folders.
    Outside,
    /// It does not exist.
    Missing,
    /// It is a folder, a pipe or a device.
    NotRegular,
}

impl Confinement {
    /// The folder of a data file, and the roots; [`Confinement::require_folders`] checks these.
    pub fn of(file: &Path, roots: &[PathBuf]) -> Self {
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).to_owned();
        Self::within(std::iter::once(folder).chain(roots.iter().cloned()))
    }

    /// These folders; one that does not exist holds nothing.
    pub fn within(folders: impl IntoIterator<Item = PathBuf>) -> Self {
        Self { folders: folders.into_iter().filter_map(|folder| fs::canonicalize(folder).ok()).collect() }
    }

    /// Checks the folders that a user allows.
    ///
    /// # Errors
    /// [`FormatError`] of one that does not exist or is a file.
    pub fn require_folders(roots: &[PathBuf]) -> Result<(), FormatError> {
        let require = |root: &PathBuf| {
            let not_folder = io::Error::from(io::ErrorKind::NotADirectory);
            match fs::metadata(root) {
                Ok(metadata) if metadata.is_dir() => Ok(()),
                found => Err(found.err().unwrap_or(not_folder)),
            }
        };
        let failed = |root: &PathBuf, error| {
            FormatError::new(root, None, file::failed(&root.to_string_lossy(), &error))
                .with_hint("a root is a folder: --root DIR")
        };
        roots.iter().try_for_each(|root| require(root).map_err(|error| failed(root, error)))
    }

    /// True if a name, relative to a folder or absolute, is the path of a given file. The named file itself is not looked at.
    pub fn is_path_of(folder: &Path, name: &Path, given: &Path) -> bool {
        let absolute = |folder: &Path, name: &Path| {
            let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
            fs::canonicalize(folder).ok().map(|folder| lexical(&folder.join(name)))
        };
        let own = given
            .file_name()
            .and_then(|file| absolute(given.parent().unwrap_or(Path::new("")), file.as_ref()));
        let named = absolute(folder, name);
        named.is_some() && (named == own || named == fs::canonicalize(given).ok())
    }

    /// True if a canonical path lies in one of the folders.
    pub fn holds(&self, path: &Path) -> bool {
        self.folders.iter().any(|folder| path.starts_with(folder))
    }

    /// The canonical path of a file that is named relative to a folder, or by an absolute path.
    ///
    /// Nothing outside the folders is looked at: the path has to lie in them by its words, and with
    /// its links resolved. The file has to be a regular one. A pipe or a device may be endless, and
    /// opening one may wait for ever.
    ///
    /// # Errors
    /// [`NotOpened`]
    pub fn file(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let folder = fs::canonicalize(folder).map_err(|_| NotOpened::Missing)?;
        let path = lexical(&folder.join(name));
        if !self.holds(&path) {
            return Err(NotOpened::Outside);
        }
        let path = fs::canonicalize(path).map_err(|_| NotOpened::Missing)?;
        if !self.holds(&path) {
            return Err(NotOpened::Outside);
        }
        if fs::metadata(&path).is_ok_and(|metadata| metadata.is_file()) {
            Ok(path)
        } else {
            Err(NotOpened::NotRegular)
        }
    }
}

impl fmt::Display for NotOpened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Outside => "it lies outside the folder of the file that names it",
            Self::Missing => "the file does not exist",
            Self::NotRegular => "it is not a regular file",
        })
    }
}

impl std::error::Error for NotOpened {}

/// The path without `.` and `..`, by its words alone.
fn lexical(path: &Path) -> PathBuf {
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
