//! Dropped files, kept in a private folder that is removed with the session.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use hyper::StatusCode;

use crate::answer::{RESTART, Refusal};
use crate::limits;

/// Folder of a session's dropped files. It is made for the first file and has a subfolder for each
/// set.
#[derive(Debug)]
pub(crate) struct Dropped {
    folder: PathBuf,
    kept: Mutex<Kept>,
}

#[derive(Debug, Default)]
struct Kept {
    files: usize,
    bytes: usize,
}

impl Dropped {
    /// Chooses a folder among the system's temporary files.
    pub(crate) fn new() -> io::Result<Self> {
        let mut random = [0; 8];
        getrandom::fill(&mut random).map_err(|error| io::Error::other(error.to_string()))?;
        let name = format!("polhode-live-{}-{:016x}", std::process::id(), u64::from_le_bytes(random));
        // The canonical path, so that paths of its files begin with it.
        let folder = fs::canonicalize(std::env::temp_dir())?.join(name);
        Ok(Self { folder, kept: Mutex::default() })
    }

    /// Makes the folder, accessible only to the user.
    fn make(&self) -> io::Result<()> {
        let mut builder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        builder.create(&self.folder)
    }

    /// Returns the folder of a set.
    pub(crate) fn set(&self, set: u64) -> PathBuf {
        self.folder.join(set.to_string())
    }

    /// Returns the path of a file of a set.
    pub(crate) fn path(&self, set: u64, name: &str) -> Result<PathBuf, Refusal> {
        Ok(self.set(set).join(relative(name)?))
    }

    /// Begins to receive a file of a set. It is written while it arrives.
    pub(crate) fn receive(&self, set: u64, name: &str) -> Result<Incoming<'_>, Refusal> {
        let path = self.path(set, name)?;
        let number = {
            let mut kept = self.kept();
            if kept.files >= limits::FILE_COUNT {
                return Err(full());
            }
            if kept.files == 0 {
                self.make().map_err(|error| unkept(name, &error))?;
            }
            kept.files += 1;
            kept.files
        };
        // The file is kept outside the sets until it is complete.
        let written = self.folder.join(format!("incoming-{number}"));
        let file = File::create_new(&written).map_err(|error| unkept(name, &error))?;
        Ok(Incoming { dropped: self, name: name.to_owned(), path, written, file })
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the files of a set.
    pub(crate) fn files(&self, set: u64) -> Vec<PathBuf> {
        let mut found = Vec::new();
        below(&self.set(set), &mut found);
        found
    }
}

/// A file that is being received. It joins its set when it is complete, and is removed if the
/// remainder does not arrive.
#[derive(Debug)]
pub(crate) struct Incoming<'a> {
    dropped: &'a Dropped,
    name: String,
    path: PathBuf,
    written: PathBuf,
    file: File,
}

impl Incoming<'_> {
    /// Writes the next bytes.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), Refusal> {
        {
            let mut kept = self.dropped.kept();
            if kept.bytes + bytes.len() > limits::FILES {
                return Err(full());
            }
            kept.bytes += bytes.len();
        }
        self.file.write_all(bytes).map_err(|error| unkept(&self.name, &error))
    }

    /// Completes the file.
    pub(crate) fn end(self) -> Result<(), Refusal> {
        let made = self.path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::rename(&self.written, &self.path)).map_err(|error| unkept(&self.name, &error))
    }
}

impl Drop for Incoming<'_> {
    fn drop(&mut self) {
        // A completed file has been renamed, so that nothing is removed.
        let _ = fs::remove_file(&self.written);
    }
}

fn full() -> Refusal {
    let rule =
        format!("a session keeps at most {} files and {} MiB", limits::FILE_COUNT, limits::FILES >> 20);
    Refusal::new(StatusCode::INSUFFICIENT_STORAGE, rule).hint(RESTART)
}

fn unkept(name: &str, error: &io::Error) -> Refusal {
    Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, format!("{name:?} cannot be saved: {error}"))
}

impl Drop for Dropped {
    fn drop(&mut self) {
        // The system removes temporary files that cannot be removed here.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

fn below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        match entry.file_type() {
            Ok(kind) if kind.is_dir() => below(&entry.path(), found),
            Ok(kind) if kind.is_file() => found.push(entry.path()),
            _ => {}
        }
    }
}

/// Checks a relative path below a folder: its names have no special meaning on any system.
fn relative(name: &str) -> Result<PathBuf, Refusal> {
    const MOST: usize = 120;
    const DEEPEST: usize = 8;
    let refused = || {
        let shown: String = name.chars().take(MOST).collect();
        Refusal::new(StatusCode::BAD_REQUEST, format!("{shown:?} is not a valid file name here"))
            .hint("use letters, digits, spaces and - _ . ( ) + @, with / between folders")
    };
    let is_plain = |c: char| c.is_alphanumeric() || "-_.()+@ ".contains(c);
    let names: Vec<&str> = name.split('/').collect();
    let is_good = |part: &&str| {
        !part.is_empty()
            && part.chars().count() <= MOST
            && part.chars().all(is_plain)
            && !part.starts_with(['.', ' '])
            && !part.ends_with(['.', ' '])
            && !is_device(part)
    };
    if names.len() > DEEPEST || !names.iter().all(is_good) {
        return Err(refused());
    }
    Ok(names.iter().collect())
}

/// Returns true for names of devices on Windows.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim().to_ascii_uppercase();
    let numbered = |device: &str| stem.strip_prefix(device).is_some_and(|n| n.len() == 1);
    ["CON", "PRN", "AUX", "NUL"].contains(&stem.as_str()) || numbered("COM") || numbered("LPT")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn no_name_leads_out_of_the_folder() {
        for name in [
            "",
            ".",
            "..",
            "../a.stl",
            "a/../b",
            "/etc/passwd",
            "a//b",
            "C:\\a",
            "a\\b",
            "a\0b",
            "a\nb",
            ".hidden",
            "a/.b",
            "NUL",
            "nul.stl",
            "com1.txt",
            "a/b/c/d/e/f/g/h/i",
            "a:b",
            "a.",
            "~",
            "%2e%2e",
        ] {
            assert!(relative(name).is_err(), "{name:?}");
        }
        assert_eq!(relative("meshes/Größe (1).stl").unwrap(), Path::new("meshes").join("Größe (1).stl"));
    }

    #[test]
    fn what_breaks_off_leaves_nothing_and_what_was_there() {
        let dropped = Dropped::new().unwrap();
        for whole in [true, false] {
            let mut incoming = dropped.receive(1, "a.stl").unwrap();
            incoming.write(if whole { b"first" } else { b"secon" }).unwrap();
            if whole {
                incoming.end().unwrap();
            }
        }
        assert_eq!(fs::read(dropped.path(1, "a.stl").unwrap()).unwrap(), b"first");
        assert_eq!(fs::read_dir(&dropped.folder).unwrap().count(), 1);
    }

    #[test]
    fn the_folder_goes_with_the_session() {
        let dropped = Dropped::new().unwrap();
        let mut incoming = dropped.receive(3, "meshes/a.stl").unwrap();
        incoming.write(b"sol").unwrap();
        assert!(dropped.files(3).is_empty());
        incoming.write(b"id").unwrap();
        incoming.end().unwrap();
        let path = dropped.path(3, "meshes/a.stl").unwrap();
        assert_eq!(dropped.files(3), std::slice::from_ref(&path));
        assert_eq!(fs::read(path).unwrap(), b"solid");
        assert!(dropped.files(4).is_empty());
        let folder = dropped.folder.clone();
        assert!(folder.is_dir());
        drop(dropped);
        assert!(!folder.exists());
    }
}
