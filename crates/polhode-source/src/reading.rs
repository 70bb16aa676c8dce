//! Reading files into values, with errors located in the file.

use std::path::Path;

use crate::content::ContentError;
use crate::error::FormatError;
use crate::file;
use crate::files::Files;

/// Reads a file with a parser of bytes; an error in the contents gets its line.
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
/// [`FormatError`] if the file cannot be read, or if the parser refuses its contents.
pub fn read_file<T>(
    files: &dyn Files,
    path: &Path,
    parse: impl FnOnce(&[u8]) -> Result<T, ContentError>,
) -> Result<T, FormatError> {
    let bytes = file::bytes(files, path, &path.to_string_lossy(), u64::MAX)
        .map_err(|kind| FormatError::new(path, None, kind))?;
    parse(&bytes).map_err(|error| FormatError::of_content(path, &bytes, error))
}

/// Reads a file with a parser of UTF-8 text.
///
/// # Errors
/// Same as [`read_file`], and an error for text that is not UTF-8.
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
