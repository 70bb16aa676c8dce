//! Files that a parts list may open.

use std::path::{Path, PathBuf};

use polhode_source::files::{Confined, Disk, Files};

/// Files that a parts list may open: it is data, and opens none outside its folder and the roots.
#[derive(Clone, Copy, Debug)]
pub struct Access<'a> {
    /// Place that they are taken from.
    pub files: &'a dyn Files,
    /// Folders that they may lie in, besides that of the list.
    pub roots: &'a [PathBuf],
}

impl<'a> Access<'a> {
    /// Files of this machine in the list's own folder.
    pub const BESIDE: Self = Self { files: &Disk, roots: &[] };

    /// Returns the files that a list may name.
    pub(crate) fn of(self, list: &Path) -> Confined<'a> {
        Confined::beside(self.files, list, self.roots)
    }
}
