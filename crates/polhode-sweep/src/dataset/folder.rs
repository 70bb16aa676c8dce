//! The folder of a sweep: which files it can hold, and who may write to it.
//!
//! A writer holds a lock on `sweep.lock` as long as it lives: the system lets go of it when the process ends, however it ends.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::durable::{self, PARTIAL};
use crate::error::SweepError;

/// What was asked for; made last when a sweep begins.
pub(super) const MANIFEST: &str = "sweep.json";
/// A copy of the plan.
pub(super) const PLAN: &str = "plan.toml";
/// What was found, made last when a sweep ends.
pub(super) const SUMMARY: &str = "summary.json";
/// Pictures of what was found.
pub(super) const HISTOGRAMS: &str = "histograms.svg";
pub(super) const PAIRS: &str = "pairs.svg";
pub(super) const QUESTIONS: &str = "questions.svg";
const LOCK: &str = "sweep.lock";
/// Folders of parts.
pub(super) const MEMBERS: &str = "members";
pub(super) const TRAJECTORIES: &str = "trajectories";

const FILES: [&str; 7] = [MANIFEST, PLAN, SUMMARY, HISTOGRAMS, PAIRS, QUESTIONS, LOCK];

/// A folder that no other sweep writes to while this lives.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    _lock: File,
}

impl Folder {
    /// A new folder.
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

    /// A folder that is there, if it holds nothing but a sweep, or the beginning of one.
    pub(super) fn open(path: &Path) -> Result<Self, SweepError> {
        Self::require_sweep(path)?;
        Self::lock(path)
    }

    /// Refuses what is no folder, or holds something else than a sweep.
    fn require_sweep(path: &Path) -> Result<(), SweepError> {
        let strange = |why: String| SweepError::NotASweep { folder: path.to_owned(), why };
        if !fs::symlink_metadata(path).map_err(SweepError::reading(path))?.is_dir() {
            return Err(strange("it is no folder".to_owned()));
        }
        match foreign_file(path).map_err(SweepError::reading(path))? {
            Some(name) => Err(strange(format!("it holds {name:?}"))),
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

    /// The place of a file.
    pub(super) fn join(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Where it is.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file, durably.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), SweepError> {
        let path = self.join(name);
        durable::write(&path, bytes).map_err(SweepError::writing(&path))
    }

    /// Makes a folder inside, durably.
    pub(super) fn make(&self, name: &str) -> Result<(), SweepError> {
        let path = self.join(name);
        let made = match fs::create_dir(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Ok(()),
            Err(error) => Err(error),
            Ok(()) => durable::sync_folder(&self.path),
        };
        made.map_err(SweepError::writing(&path))
    }

    /// Removes everything of a sweep but the lock, the manifest first: without it the rest counts for nothing.
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

    /// Removes what writers that were killed left half made.
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

/// The name of a part's file.
pub(super) fn part_name(part: u64) -> String {
    format!("part-{part:05}.parquet")
}

/// The number of a part, from the name of its file.
fn part_number(name: &str) -> Option<u64> {
    let number = name.strip_prefix("part-")?.strip_suffix(".parquet")?.parse().ok()?;
    (part_name(number) == name).then_some(number)
}

/// The files in a folder, in order; none if it is not there.
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

/// Something in a folder that no sweep makes.
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
