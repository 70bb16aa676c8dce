//! Atomic and durable files: complete or absent, even after a power failure.

use std::fs::{self, File};
use std::io;
use std::path::Path;

/// Suffix of incomplete files.
pub(super) const PARTIAL: &str = ".partial";

/// Writes a temporary file next to the path, waits until it is on disk, and renames it.
pub(super) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut name = path.as_os_str().to_owned();
    name.push(PARTIAL);
    let partial = Path::new(&name);
    let written = File::create(partial).and_then(|mut file| {
        io::Write::write_all(&mut file, bytes)?;
        file.sync_all()
    });
    if let Err(error) = written.and_then(|()| fs::rename(partial, path)) {
        let _ = fs::remove_file(partial);
        return Err(error);
    }
    path.parent().map_or(Ok(()), sync_folder)
}

/// Waits until the names in a folder are on disk.
#[cfg(unix)]
pub(super) fn sync_folder(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

/// Does nothing: other systems have no such operation for folders.
#[cfg(not(unix))]
pub(super) fn sync_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// Removes a file if it exists.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        other => other,
    }
}
