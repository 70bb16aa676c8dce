//! Rows as Apache Parquet, and back.
//!
//! The bytes depend on the rows and the metadata alone. A checksum of the file is among the metadata.

mod read;
mod seal;
mod write;

use std::io;
use std::path::Path;

use ::parquet::errors::ParquetError;

use crate::batch::Batch;
use read::read;

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
    match std::fs::read(path) {
        Ok(bytes) => Ok(open(bytes, metadata)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// As [`load`], of the bytes of a file.
fn open(bytes: Vec<u8>, metadata: &Pairs) -> Option<Batch> {
    if !seal::is_right(&bytes) {
        return None;
    }
    let (batch, found) = read(bytes).ok()?;
    (found == *metadata).then_some(batch)
}

/// The error of the reader or writer below, where that is what it was.
fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(io) => *io,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests;
