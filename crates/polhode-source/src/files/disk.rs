//! Files of this machine.

use std::fs::{self, File, FileType, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use super::{Files, Kind, Look, NotOpened, OpenFile};

/// All files of this machine that the user may read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Disk;

impl Files for Disk {
    fn open(&self, path: &Path) -> io::Result<Box<dyn OpenFile>> {
        Ok(Box::new(File::open(path)?))
    }

    fn look(&self, path: &Path) -> io::Result<Look> {
        fs::metadata(path).map(|metadata| look(&metadata))
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        fs::canonicalize(path)
    }

    fn entries(&self, folder: &Path) -> io::Result<Vec<(PathBuf, Kind)>> {
        let of = |entry: io::Result<fs::DirEntry>| {
            let entry = entry?;
            Ok((entry.path(), kind(entry.file_type()?)))
        };
        fs::read_dir(folder)?.map(of).collect()
    }

    fn named(&self, folder: &Path, name: &Path) -> Result<PathBuf, NotOpened> {
        Ok(folder.join(name))
    }
}

impl OpenFile for File {
    fn look(&self) -> io::Result<Look> {
        self.metadata().map(|metadata| look(&metadata))
    }
}

fn look(metadata: &Metadata) -> Look {
    Look { kind: kind(metadata.file_type()), length: metadata.len(), changed: metadata.modified().ok() }
}

fn kind(of: FileType) -> Kind {
    match (of.is_file(), of.is_dir()) {
        (true, _) => Kind::File,
        (_, true) => Kind::Folder,
        _ => Kind::Other,
    }
}
