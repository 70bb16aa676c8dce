//! Bytes from files.
//!
//! A file is read, never mapped into memory. If another process shortens it meanwhile, that gives
//! an error instead of a fatal signal.

use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use crate::error::{FormatError, FormatErrorKind};
use crate::files::{Files, Kind, Look, OpenFile};

/// Largest accepted input from a pipe or device, bytes. Its length is unknown in advance and may be
/// infinite.
const LARGEST_STREAM: u64 = 1 << 30;

/// Start of what Git LFS stores in place of a large file.
const LFS_POINTER: &[u8] = b"version https://git-lfs.github.com/spec/";

const SHORTER: &str = "it became shorter while it was being read";

/// Reads all bytes of a file; `written` is the path as the user wrote it.
///
/// A folder gives an error, as does a file of more than `limit` bytes, before it fills the memory,
/// and a pointer of Git LFS.
/// Insufficient memory is an error and does not end the process. A file that changes while it is
/// read is an error.
pub fn bytes(files: &dyn Files, path: &Path, written: &str, limit: u64) -> Result<Vec<u8>, FormatErrorKind> {
    let failed = |error: io::Error| failed(written, &error);
    let look = files.look(path).map_err(failed)?;
    if look.is_folder() {
        return Err(failed(io::ErrorKind::IsADirectory.into()));
    }
    let limit = if look.is_file() { limit } else { limit.min(LARGEST_STREAM) };
    let too_large =
        || failed(io::Error::new(io::ErrorKind::FileTooLarge, format!("it has more than {limit} bytes")));
    let mut file = files.open(path).map_err(failed)?;
    // Metadata of the opened file; the path may point to another file by now.
    let before = file.look().map_err(failed)?;
    if before.is_file() && before.length > limit {
        return Err(too_large());
    }
    let bytes = all(&mut *file, limit.saturating_add(1), &before).map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(too_large());
    }
    if bytes.starts_with(LFS_POINTER) {
        let why = "it is a Git LFS pointer, not the file itself: run git lfs pull in its repository";
        return Err(failed(io::Error::new(io::ErrorKind::InvalidData, why)));
    }
    Ok(bytes)
}

/// Reads at most `most` bytes of an open file; `before` is its metadata at opening.
///
/// # Errors
/// I/O errors of the system; [`io::ErrorKind::OutOfMemory`]; and the errors of [`unchanged`].
pub fn all(file: &mut dyn OpenFile, most: u64, before: &Look) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let expected = if before.is_file() { before.length.min(most) } else { 0 };
    let reserved = usize::try_from(expected).is_ok_and(|expected| bytes.try_reserve_exact(expected).is_ok());
    if !reserved {
        let why = format!("out of memory: it has {expected} bytes");
        return Err(io::Error::new(io::ErrorKind::OutOfMemory, why));
    }
    (&mut *file).take(most).read_to_end(&mut bytes)?;
    // Virtual files, such as those in /proc, report a length of 0.
    if expected > 0 {
        if (bytes.len() as u64) < expected {
            return Err(io::Error::new(io::ErrorKind::UnexpectedEof, SHORTER));
        }
        unchanged(file.look()?, before)?;
    }
    Ok(bytes)
}

/// Checks that a file did not change while its bytes were read one after another.
///
/// # Errors
/// I/O errors of the system; [`io::ErrorKind::UnexpectedEof`] if the file is shorter now, another
/// kind if it changed otherwise.
pub fn unchanged(now: Look, before: &Look) -> io::Result<()> {
    if now.length < before.length {
        return Err(io::Error::new(io::ErrorKind::UnexpectedEof, SHORTER));
    }
    let is_later = before.changed.zip(now.changed).is_some_and(|(before, now)| before != now);
    if is_later || now.length != before.length {
        return Err(io::Error::other("it was changed while it was being read"));
    }
    Ok(())
}

/// Returns the error kind for a file; `written` is its path as the user wrote it.
pub fn failed(written: &str, error: &io::Error) -> FormatErrorKind {
    let why = match error.kind() {
        io::ErrorKind::NotFound => "the file does not exist".to_owned(),
        // Files of some folders only state which rule a path breaks.
        io::ErrorKind::PermissionDenied if error.get_ref().is_none() => "permission denied".to_owned(),
        io::ErrorKind::IsADirectory => "it is a directory".to_owned(),
        io::ErrorKind::UnexpectedEof => SHORTER.to_owned(),
        _ => error.to_string(),
    };
    FormatErrorKind::Io { file: written.to_owned(), kind: error.kind(), why }
}

/// Checks that the folders allowed by the user exist.
///
/// # Errors
/// [`FormatError`] for a root that does not exist or is not a folder.
pub fn require_folders(files: &dyn Files, roots: &[PathBuf]) -> Result<(), FormatError> {
    let require = |root: &PathBuf| match files.look(root)?.kind {
        Kind::Folder => Ok(()),
        Kind::File | Kind::Other => Err(io::Error::from(io::ErrorKind::NotADirectory)),
    };
    let failed = |root: &PathBuf, error| {
        FormatError::new(root, None, failed(&root.to_string_lossy(), &error))
            .with_hint("a root must be a folder: --root DIR")
    };
    roots.iter().try_for_each(|root| require(root).map_err(|error| failed(root, error)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use std::fs::{self, File};
    use std::io::{Seek as _, Write as _};

    use super::*;
    use crate::files::Disk;

    /// Returns the result of reading a file that changes after its length was determined.
    fn changed(name: &str, change: impl Fn(&File)) -> io::Result<Vec<u8>> {
        let path = std::env::temp_dir().join(format!("polhode-changed-{}-{name}", std::process::id()));
        fs::write(&path, [7; 1000]).unwrap();
        let mut file = File::options().read(true).write(true).open(&path).unwrap();
        let before = OpenFile::look(&file).unwrap();
        change(&file);
        let read = all(&mut file, u64::MAX, &before);
        fs::remove_file(path).unwrap();
        read
    }

    #[test]
    fn a_file_that_changes_while_it_is_read_is_refused() {
        assert_eq!(changed("not", |_| {}).unwrap(), [7; 1000]);
        let shorter = changed("shorter", |file| file.set_len(999).unwrap()).unwrap_err();
        assert_eq!(shorter.kind(), io::ErrorKind::UnexpectedEof);
        assert!(failed("a.stl", &shorter).to_string().contains("\"a.stl\": it became shorter while"));
        let longer = changed("longer", |file| file.set_len(1001).unwrap()).unwrap_err();
        assert!(longer.to_string().contains("it was changed while"));
        let rewritten = changed("rewritten", |mut file| {
            file.write_all(&[8; 1000]).unwrap();
            file.rewind().unwrap();
            file.set_modified(std::time::UNIX_EPOCH).unwrap();
        });
        assert!(rewritten.unwrap_err().to_string().contains("it was changed while"));
    }

    #[test]
    fn a_file_larger_than_the_memory_is_refused() {
        let path = std::env::temp_dir().join(format!("polhode-huge-{}", std::process::id()));
        let file = File::create(&path).unwrap();
        // A sparse file, larger than the address space of any machine.
        let huge =
            (0..63).rev().map(|bits| 1_u64 << bits).find(|&length| file.set_len(length).is_ok()).unwrap();
        assert!(huge >= 1 << 40);
        let error = bytes(&Disk, &path, "huge.stl", 1 << 30).unwrap_err();
        assert!(error.to_string().contains("more than 1073741824 bytes"));
        fs::remove_file(path).unwrap();
    }
}
