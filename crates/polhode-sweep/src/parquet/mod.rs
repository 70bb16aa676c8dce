//! Tables as Apache Parquet files, in both directions.
//!
//! The bytes depend on the rows and the metadata alone. The metadata contains a checksum of the
//! file.

mod read;
mod seal;
mod write;

use std::io;
use std::path::Path;

use crate::batch::Batch;

pub(crate) use write::write;

/// Key–value pairs of a file's metadata.
pub(crate) type Pairs = Vec<(String, String)>;

/// Prefix of keys in the metadata of polhode.
const PREFIX: &str = "polhode.";

/// Keys that [`write()`] adds itself.
const VERSION: &str = "polhode.version";
const CONVENTIONS: &str = "polhode.conventions";
const UNITS: &str = "polhode.units";
const DESCRIPTIONS: &str = "polhode.descriptions";
const CHECKSUM: &str = "polhode.checksum";
const OURS: [&str; 5] = [VERSION, CONVENTIONS, UNITS, DESCRIPTIONS, CHECKSUM];

/// Returns the rows of a file; `None` if it is missing, damaged or has other metadata.
///
/// # Errors
/// Errors of reading the file, except that it does not exist.
pub(crate) fn load(path: &Path, metadata: &Pairs) -> io::Result<Option<Batch>> {
    let rows = |bytes| read::read(bytes).ok();
    Ok(whole(path, metadata)?.and_then(rows))
}

/// Returns true if a file exists, is undamaged, and has this metadata, so that its rows can be
/// read.
///
/// # Errors
/// Same as [`load`].
pub(crate) fn is_whole(path: &Path, metadata: &Pairs) -> io::Result<bool> {
    Ok(whole(path, metadata)?.is_some())
}

/// Returns the bytes of a file; `None` if it is missing, damaged or has other metadata.
fn whole(path: &Path, metadata: &Pairs) -> io::Result<Option<Vec<u8>>> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(is_sound(&bytes, metadata).then_some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// Returns true if bytes have the right checksum and this metadata.
fn is_sound(bytes: &[u8], metadata: &Pairs) -> bool {
    seal::is_right(bytes) && read::metadata(bytes.to_vec()).is_ok_and(|found| found == *metadata)
}

#[cfg(test)]
mod tests;
