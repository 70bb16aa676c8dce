//! Access to files in certain folders only.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use super::{Files, Kind, Look, OpenFile, lexical};

/// Files in certain folders: the folder of a data file, and the folders that the user allows
/// (`--root`).
///
/// A log, a parts list, a mesh or a robot model is data. It cannot open files outside these folders
/// by any path, address or link.
///
/// ```
/// use polhode_source::files::{Confined, Disk, Files, NotOpened};
/// let folder = std::env::temp_dir().join(format!("polhode-confined-{}", std::process::id()));
/// std::fs::create_dir_all(folder.join("inner"))?;
/// std::fs::write(folder.join("inner/a.stl"), "")?;
/// let files = Confined::to_folder_of(&Disk, &folder.join("list.csv"), &[]);
/// assert!(files.named(&folder, "inner/../inner/a.stl".as_ref()).is_ok());
/// assert_eq!(files.named(&folder, "b.stl".as_ref()), Err(NotOpened::Missing));
/// assert_eq!(files.named(&folder, "inner".as_ref()), Err(NotOpened::NotRegular));
/// assert_eq!(files.named(&folder, "../b.stl".as_ref()), Err(NotOpened::Outside));
/// assert_eq!(files.named(&folder, "/etc/hostname".as_ref()), Err(NotOpened::Outside));
/// assert!(files.open("/etc/hostname".as_ref()).is_err());
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Confined<'a> {
    files: &'a dyn Files,
    /// Canonical paths of the folders.
    folders: Vec<PathBuf>,
}

/// Reason why a file that another file names is not opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotOpened {
    /// It lies outside the folders.
    Outside,
    /// It does not exist.
    Missing,
    /// It is a folder, a pipe or a device.
    NotRegular,
    /// It is not one of the files that the user opened.
    NotGiven,
}

impl<'a> Confined<'a> {
    /// Allows the folder of a data file, and the roots;
    /// [`require_folders`](crate::file::require_folders) checks the roots.
    pub fn to_folder_of(files: &'a dyn Files, file: &Path, roots: &[PathBuf]) -> Self {
        let folder = or_here(file.parent().unwrap_or(Path::new(""))).to_owned();
        Self::within(files, std::iter::once(folder).chain(roots.iter().cloned()))
    }

    /// Allows these folders; a folder that does not exist allows nothing.
    pub fn within(files: &'a dyn Files, folders: impl IntoIterator<Item = PathBuf>) -> Self {
        Self {
            files,
            folders: folders
                .into_iter()
                .filter_map(|folder| files.canonical(or_here(&folder)).ok())
                .collect(),
        }
    }

    /// Returns true if a canonical path lies in one of the folders.
    fn holds(&self, path: &Path) -> bool {
        self.folders.iter().any(|folder| path.starts_with(folder))
    }

    /// # Errors
    /// [`io::ErrorKind::PermissionDenied`] if the path is outside the folders, whether or not a file
    /// is there.
    fn require(&self, path: &Path) -> io::Result<PathBuf> {
        let here = || self.files.canonical(Path::new(".")).unwrap_or_default();
        match self.files.canonical(path) {
            Ok(path) if self.holds(&path) => Ok(path),
            Err(error) if self.holds(&lexical(&here().join(path))) => Err(error),
            Ok(_) | Err(_) => {
                let rule = "it lies outside the folders that may be read; --root DIR allows another one";
                Err(io::Error::new(io::ErrorKind::PermissionDenied, rule))
            }
        }
    }
}

impl Files for Confined<'_> {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        self.files.open(&self.require(path)?)
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        self.files.look(&self.require(path)?)
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.require(path)
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        // Paths begin with the folder as it was named, as for other sources of files.
        let named = |(path, kind): (PathBuf, Kind)| match path.file_name() {
            Some(name) => (folder.join(name), kind),
            None => (path, kind),
        };
        Ok(self.files.entries(&self.require(folder)?)?.into_iter().map(named).collect())
    }

    /// Returns the canonical path of a file that is named relative to a folder, or by an absolute
    /// path.
    ///
    /// The path must lie in the folders both as written and with its links resolved. Nothing
    /// outside the folders is accessed. The file must be a regular file: opening a pipe or device
    /// may block forever.
    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        self.files.named(folder, name)?;
        let folder = self.files.canonical(or_here(folder)).map_err(|_| NotOpened::Missing)?;
        let path = lexical(&folder.join(name));
        if !self.holds(&path) {
            return Err(NotOpened::Outside);
        }
        let path = self.files.canonical(&path).map_err(|_| NotOpened::Missing)?;
        if !self.holds(&path) {
            return Err(NotOpened::Outside);
        }
        if self.files.is_file(&path) { Ok(path) } else { Err(NotOpened::NotRegular) }
    }
}

/// Returns true if a name, relative to a folder or absolute, is the path of `given`. Does not
/// access the named file.
pub fn is_path_of(files: &dyn Files, folder: &Path, name: &Path, given: &Path) -> bool {
    let absolute = |folder: &Path, name: &Path| {
        files.canonical(or_here(folder)).ok().map(|folder| lexical(&folder.join(name)))
    };
    let own =
        given.file_name().and_then(|file| absolute(given.parent().unwrap_or(Path::new("")), file.as_ref()));
    let named = absolute(folder, name);
    named.is_some() && (named == own || named == files.canonical(given).ok())
}

fn or_here(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() { Path::new(".") } else { folder }
}

impl fmt::Display for NotOpened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Outside => "it lies outside the folder of the file that names it",
            Self::Missing => "the file does not exist",
            Self::NotRegular => "it is not a regular file",
            Self::NotGiven => "it was not opened together with the file that names it",
        })
    }
}

impl std::error::Error for NotOpened {}
