//! File access of parts lists.

use std::path::{Path, PathBuf};

use polhode_source::files::{Confined, Disk, Files};

/// File access of a parts list. A list is data: it opens no file outside its own folder and
/// `roots`.
#[derive(Clone, Copy, Debug)]
pub struct Access<'a> {
    /// Source of the files.
    pub files: &'a dyn Files,
    /// Folders that files may be in, besides the folder of the list.
    pub roots: &'a [PathBuf],
}

impl<'a> Access<'a> {
    /// Files of this machine in the list's own folder.
    pub const BESIDE: Self = Self { files: &Disk, roots: &[] };

    /// Returns the files that a list may open.
    pub(crate) fn of(self, list: &Path) -> Confined<'a> {
        Confined::to_folder_of(self.files, list, self.roots)
    }
}
