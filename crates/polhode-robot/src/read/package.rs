//! Names of packages.

use std::path::Path;

use polhode_source::files::Files;

/// Returns the name in a folder's `package.xml`.
pub(super) fn package_name(
    files: &dyn Files,
    folder: &Path,
    holds: impl Fn(&Path) -> bool,
) -> Option<String> {
    /// Maximum number of bytes to read. A package file is short, and its name is near the start.
    const MOST: u64 = 1 << 16;
    // The file may be a symbolic link to another folder.
    let file = files.canonical(&folder.join("package.xml")).ok()?;
    if !holds(&file) || !files.is_file(&file) {
        return None;
    }
    let mut text = String::new();
    let file = files.open(&file).ok()?;
    std::io::Read::read_to_string(&mut std::io::Read::take(file, MOST), &mut text).ok()?;
    let (_, rest) = text.split_once("<name>")?;
    Some(rest.split_once("</name>")?.0.trim().to_owned())
}
