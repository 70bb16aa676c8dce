//! Comparison of paths, so that no input is overwritten.

use std::fs;
use std::path::{Path, PathBuf};

use crate::partial::parent;

/// Returns true if two paths refer to the same file, directly or through links. The file need not
/// exist.
pub(crate) fn is_same(one: &Path, other: &Path) -> bool {
    let agree = |of: fn(&Path) -> Option<PathBuf>| of(one).is_some_and(|path| Some(path) == of(other));
    one == other || agree(entry) || agree(|path| fs::canonicalize(path).ok())
}

/// Returns the file name, appended to the canonical path of its folder.
fn entry(path: &Path) -> Option<PathBuf> {
    Some(fs::canonicalize(parent(path)).ok()?.join(path.file_name()?))
}
