//! Rows as Apache Parquet, and back.
//!
//! The bytes depend on the rows and the metadata alone. A checksum of the file is among the metadata.

mod read;
mod seal;
mod write;

use std::io;
use std::path::Path;

use crate::batch::Batch;

pub(crate) use write::write;

/// The text of a key of a file's metadata.
pub(crate) type Pairs = Vec<(String, String)>;

/// How the keys of our metadata begin.
const PREFIX: &str = "polhode.";

/// The keys that [`write()`] makes itself.
const VERSION: &str = "polhode.version";
const CONVENTIONS: &str = "polhode.conventions";
const UNITS: &str = "polhode.units";
const DESCRIPTIONS: &str = "polhode.descriptions";
const CHECKSUM: &str = "polhode.checksum";
const OURS: [&str; 5] = [VERSION, CONVENTIONS, UNITS, DESCRIPTIONS, CHECKSUM];

/// The rows of a file, if it is there, is whole, and has this metadata; `None` if it has to be made again.
///
/// # Errors
/// What keeps the file from being read, but that it is not there.
pub(crate) fn load(path: &Path, metadata: &Pairs) -> io::Result<Option<Batch>> {
    let rows = |bytes| read::read(bytes).ok();
    Ok(whole(path, metadata)?.and_then(rows))
}

/// True if a file is there, is whole, and has this metadata: its rows can be read.
///
/// # Errors
/// As [`load`].
pub(crate) fn is_whole(path: &Path, metadata: &Pairs) -> io::Result<bool> {
    Ok(whole(path, metadata)?.is_some())
}

/// The bytes of such a file.
fn whole(path: &Path, metadata: &Pairs) -> io::Result<Option<Vec<u8>>> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(is_sound(&bytes, metadata).then_some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// True of bytes with the right checksum and this metadata.
fn is_sound(bytes: &[u8], metadata: &Pairs) -> bool {
    seal::is_right(bytes) && read::metadata(bytes.to_vec()).is_ok_and(|found| found == *metadata)
}

#[cfg(test)]
mod tests;
