//! Text of a TOML file, and its tree.

use std::path::Path;

use super::list_units;
use super::source::Source;
use super::tree::{self, Entries};
use crate::file;
use crate::files::Files;
use crate::text::is_utf16;
use crate::{FormatError, FormatErrorKind};

/// Largest accepted file, bytes. Meshes and tables belong in files of their own.
pub const LARGEST_FILE: u64 = 64 << 20;

/// Reads the text of a file, of up to 64 MiB.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, is larger, or is not UTF-8.
pub fn text_of(files: &dyn Files, path: &Path) -> Result<String, FormatError> {
    let fail = |kind| FormatError::new(path, None, kind);
    let bytes = file::bytes(files, path, &path.to_string_lossy(), LARGEST_FILE).map_err(fail)?;
    if is_utf16(&bytes) {
        return Err(fail(FormatErrorKind::Utf16));
    }
    String::from_utf8(bytes).map_err(|error| {
        let (bytes, error) = (error.as_bytes().to_vec(), error.utf8_error());
        FormatError::not_utf8(path, &bytes, error.valid_up_to())
    })
}

/// Parses a text into a tree and checks that the numbers of each list have units all or not at all.
///
/// # Errors
/// [`FormatError`] if the text is not TOML, or if only some numbers of a list have a unit.
pub fn document(source: Source<'_>) -> Result<Entries, FormatError> {
    let entries = tree::parse(source.text).map_err(|error| source.syntax(&error))?;
    list_units::check(source, &entries)?;
    Ok(entries)
}

/// Returns the names of the keys and tables at the root of a text, line by line. The text need not
/// be valid, so that a damaged file is still recognized.
pub fn root_names(text: &str) -> impl Iterator<Item = &str> {
    let mut is_root = true;
    text.lines().filter_map(move |line| {
        let line = line.trim_start_matches('\u{feff}').trim_start();
        let header = line.trim_start_matches('[').trim_start();
        is_root &= !line.starts_with('[');
        let end = header.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '-'))?;
        let (name, rest) = header.split_at(end);
        let is_key = is_root && rest.trim_start().starts_with(['=', '.']);
        (!name.is_empty() && (is_key || line.starts_with('['))).then_some(name)
    })
}

#[cfg(test)]
mod tests {
    use super::root_names;

    #[test]
    fn names_at_the_root_are_found_in_a_damaged_text() {
        let text = "\u{feff}parts = \"a.csv\"\n# note = 1\n about.x = 2\n[[limit]]\nof = [\n[ swing.numbers ]\nparts = 3\n";
        assert_eq!(root_names(text).collect::<Vec<_>>(), ["parts", "about", "limit", "swing"]);
    }
}
