//! Folder of a sweep: its possible files, and exclusive access for one writer.
//!
//! A writer holds a lock on `sweep.lock`. The system releases it when the process ends for any
//! reason.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::durable::{self, PARTIAL};
use crate::error::SweepError;

/// File with the request; written last when a sweep begins.
pub(super) const MANIFEST: &str = "sweep.json";
/// Copy of the plan.
pub(super) const PLAN: &str = "plan.toml";
/// File with the summary; written last when a sweep ends.
pub(super) const SUMMARY: &str = "summary.json";
/// Figures of the results.
pub(super) const HISTOGRAMS: &str = "histograms.svg";
pub(super) const PAIRS: &str = "pairs.svg";
pub(super) const QUESTIONS: &str = "questions.svg";
const LOCK: &str = "sweep.lock";
/// Names of the folders with parts.
pub(super) const MEMBERS: &str = "members";
pub(super) const TRAJECTORIES: &str = "trajectories";

const FILES: [&str; 7] = [MANIFEST, PLAN, SUMMARY, HISTOGRAMS, PAIRS, QUESTIONS, LOCK];

/// Folder locked against other writers.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    _lock: File,
}

impl Folder {
    /// Creates a new folder.
    pub(super) fn create(path: &Path) -> Result<Self, SweepError> {
        if let Some(parent) = path.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            fs::create_dir_all(parent).map_err(SweepError::writing(parent))?;
        }
        fs::create_dir(path).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => Self::require_sweep(path)
                .map_or_else(|error| error, |()| SweepError::Exists { folder: path.to_owned() }),
            _ => SweepError::Write { path: path.to_owned(), error },
        })?;
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        durable::sync_folder(parent).map_err(SweepError::writing(parent))?;
        Self::lock(path)
    }

    /// Opens an existing folder that contains only a sweep, or the beginning of one.
    pub(super) fn open(path: &Path) -> Result<Self, SweepError> {
        Self::require_sweep(path)?;
        Self::lock(path)
    }

    /// Returns an error unless the path is a folder that contains only a sweep.
    fn require_sweep(path: &Path) -> Result<(), SweepError> {
        let strange = |why: String| SweepError::NotASweep { folder: path.to_owned(), why };
        if !fs::symlink_metadata(path).map_err(SweepError::reading(path))?.is_dir() {
            return Err(strange("it is not a folder".to_owned()));
        }
        match foreign_file(path).map_err(SweepError::reading(path))? {
            Some(name) => Err(strange(format!("it contains {name:?}"))),
            None => Ok(()),
        }
    }

    fn lock(path: &Path) -> Result<Self, SweepError> {
        let name = path.join(LOCK);
        let file = File::options().create(true).truncate(false).write(true).open(&name);
        let file = file.map_err(SweepError::writing(&name))?;
        match file.try_lock() {
            Ok(()) => Ok(Self { path: path.to_owned(), _lock: file }),
            Err(TryLockError::WouldBlock) => Err(SweepError::InUse { folder: path.to_owned() }),
            Err(TryLockError::Error(error)) => Err(SweepError::Write { path: name, error }),
        }
    }

    /// Returns the path of a file in the folder.
    pub(super) fn join(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Returns the path of the folder.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file durably.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), SweepError> {
        let path = self.join(name);
        durable::write(&path, bytes).map_err(SweepError::writing(&path))
    }

    /// Creates a subfolder durably.
    pub(super) fn make(&self, name: &str) -> Result<(), SweepError> {
        let path = self.join(name);
        let made = match fs::create_dir(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Ok(()),
            Err(error) => Err(error),
            Ok(()) => durable::sync_folder(&self.path),
        };
        made.map_err(SweepError::writing(&path))
    }

    /// Removes all files of a sweep except the lock. The manifest is removed first, because without
    /// it the other files are ignored.
    pub(super) fn clear(&self) -> Result<(), SweepError> {
        let remove = |path: &Path| durable::remove(path).map_err(SweepError::writing(path));
        for name in FILES.into_iter().filter(|name| *name != LOCK) {
            remove(&self.join(name))?;
            if name == MANIFEST {
                durable::sync_folder(&self.path).map_err(SweepError::writing(&self.path))?;
            }
        }
        self.sweep_out()?;
        for name in [MEMBERS, TRAJECTORIES] {
            let folder = self.join(name);
            for path in files(&folder).map_err(SweepError::reading(&folder))? {
                remove(&path)?;
            }
            match fs::remove_dir(&folder) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(SweepError::Write { path: folder, error });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Removes incomplete files of writers that were killed.
    pub(super) fn sweep_out(&self) -> Result<(), SweepError> {
        for folder in [self.path.clone(), self.join(MEMBERS), self.join(TRAJECTORIES)] {
            for path in files(&folder).map_err(SweepError::reading(&folder))? {
                if path.to_string_lossy().ends_with(PARTIAL) {
                    durable::remove(&path).map_err(SweepError::writing(&path))?;
                }
            }
        }
        Ok(())
    }
}

/// Returns the file name of a part.
pub(super) fn part_name(part: u64) -> String {
    format!("part-{part:05}.parquet")
}

/// Returns the number of a part from its file name.
fn part_number(name: &str) -> Option<u64> {
    let number = name.strip_prefix("part-")?.strip_suffix(".parquet")?.parse().ok()?;
    (part_name(number) == name).then_some(number)
}

/// Returns the files in a folder, sorted; empty if the folder does not exist.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        other => other?,
    };
    let mut paths = Vec::new();
    for entry in entries {
        let entry = entry?;
        if !entry.file_type()?.is_dir() {
            paths.push(entry.path());
        }
    }
    paths.sort();
    Ok(paths)
}

/// Returns an entry of a folder that does not belong to a sweep.
fn foreign_file(path: &Path) -> io::Result<Option<String>> {
    for entry in fs::read_dir(path)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.file_type()?.is_dir() {
            if ![MEMBERS, TRAJECTORIES].contains(&name.as_str()) {
                return Ok(Some(name));
            }
            for inner in fs::read_dir(entry.path())? {
                let inner = inner?;
                let inside = inner.file_name().to_string_lossy().into_owned();
                let is_part = part_number(inside.trim_end_matches(PARTIAL)).is_some();
                if inner.file_type()?.is_dir() || !is_part {
                    return Ok(Some(format!("{name}/{inside}")));
                }
            }
        } else if !FILES.contains(&name.trim_end_matches(PARTIAL)) {
            return Ok(Some(name));
        }
    }
    Ok(None)
}
