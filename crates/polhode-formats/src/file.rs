//! Bytes from files.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use crate::error::FormatErrorKind;

/// A pipe or a device can be endless, and has no length to know it by.
const LARGEST_STREAM: u64 = 1 << 30;

/// All bytes of a file; `written` is the path as its user wrote it.
///
/// A directory is refused in words, and a file of more than `limit` bytes before it fills the memory.
pub(crate) fn bytes(path: &Path, written: &str, limit: u64) -> Result<Vec<u8>, FormatErrorKind> {
    let failed = |error: &io::Error| {
        let why = match error.kind() {
            io::ErrorKind::NotFound => "there is no such file".to_owned(),
            io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
            io::ErrorKind::IsADirectory => "it is a directory".to_owned(),
            _ => error.to_string(),
        };
        FormatErrorKind::Io { file: written.to_owned(), kind: error.kind(), why }
    };
    let metadata = fs::metadata(path).map_err(|e| failed(&e))?;
    if metadata.is_dir() {
        return Err(failed(&io::ErrorKind::IsADirectory.into()));
    }
    let limit = if metadata.is_file() { limit } else { limit.min(LARGEST_STREAM) };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|e| failed(&e))?;
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(|e| failed(&e))?;
    if bytes.len() as u64 > limit {
        let why = format!("it has more than {limit} bytes");
        return Err(FormatErrorKind::Io { file: written.to_owned(), kind: io::ErrorKind::FileTooLarge, why });
    }
    Ok(bytes)
}
