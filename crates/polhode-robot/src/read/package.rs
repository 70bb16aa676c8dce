//! Names of packages.

use std::fs;
use std::path::Path;

/// The name in a folder's `package.xml`.
pub(super) fn package_name(folder: &Path, holds: impl Fn(&Path) -> bool) -> Option<String> {
    /// A package file is some hundred bytes; its name stands near the start.
    const MOST: u64 = 1 << 16;
    // It may be a link to somewhere else.
    let file = fs::canonicalize(folder.join("package.xml")).ok()?;
    if !holds(&file) || !file.is_file() {
        return None;
    }
    let mut text = String::new();
    let file = fs::File::open(file).ok()?;
    std::io::Read::read_to_string(&mut std::io::Read::take(file, MOST), &mut text).ok()?;
    let (_, rest) = text.split_once("<name>")?;
    Some(rest.split_once("</name>")?.0.trim().to_owned())
}
