//! Files into values: the bytes of one, and where in it an error is.

use std::path::Path;

use crate::content::ContentError;
use crate::error::FormatError;
use crate::file;
use crate::files::Files;

/// Reads a file with a parser of bytes: an error in the contents gets its line.
///
/// ```
/// use polhode_source::{files::Disk, read_file};
/// let path = std::env::temp_dir().join(format!("polhode-read-{}.txt", std::process::id()));
/// std::fs::write(&path, "1.5 kg")?;
/// assert_eq!(read_file(&Disk, &path, |bytes| Ok(bytes.len()))?, 6);
/// # std::fs::remove_file(path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FormatError`] if the file cannot be read, or its contents are not what the parser takes.
pub fn read_file<T>(
    files: &dyn Files,
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, ContentError>,
) -> Result<T, FormatError> {
    let bytes = file::bytes(files, path, &path.to_string_lossy(), u64::MAX)
        .map_err(|kind| FormatError::new(path, None, kind))?;
    parse(&bytes).map_err(|error| FormatError::of_content(path, &bytes, error))
}

/// The same for a parser of text, which has to be UTF-8.
///
/// # Errors
/// As [`read_file`], and for text that is not UTF-8.
pub fn read_text_file<T>(
    files: &dyn Files,
    path: &Path,
    parse: impl FnOnce(&str) -> Result<T, ContentError>,
) -> Result<T, FormatError> {
    let bytes = file::bytes(files, path, &path.to_string_lossy(), u64::MAX)
        .map_err(|kind| FormatError::new(path, None, kind))?;
    let text =
        str::from_utf8(&bytes).map_err(|error| FormatError::not_utf8(path, &bytes, error.valid_up_to()))?;
    parse(text).map_err(|error| FormatError::of_content(path, &bytes, error))
}
