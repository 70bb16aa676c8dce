//! What keeps a sweep from being run or kept.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use polhode_source::{Failure, shown};

use crate::batch::BatchError;

/// What keeps a sweep from being run or kept.
#[derive(Debug)]
#[non_exhaustive]
pub enum SweepError {
    /// The folder is there already.
    Exists {
        /// The folder.
        folder: PathBuf,
    },
    /// Somebody else is writing to the folder.
    InUse {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder holds the results of another plan.
    Changed {
        /// The folder.
        folder: PathBuf,
        /// What differs.
        what: String,
    },
    /// The folder holds something else than a sweep.
    NotASweep {
        /// The folder.
        folder: PathBuf,
        /// What is found there, or is not.
        why: String,
    },
    /// A file of the sweep is not as it was written.
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: &'static str,
    },
    /// A file cannot be read.
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        error: io::Error,
    },
    /// A file cannot be written.
    Write {
        /// The file.
        path: PathBuf,
        /// Why not.
        error: io::Error,
    },
    /// A part is missing or damaged.
    Incomplete {
        /// The part.
        part: u64,
    },
    /// Rows that are not those of the part.
    Rows {
        /// The part.
        part: u64,
        /// What is wrong.
        why: String,
    },
    /// A plan has no times for which to compute.
    NoRun,
    /// Columns that are no table.
    Batch(BatchError),
}

/// There is no room.
const FULL: [io::ErrorKind; 3] =
    [io::ErrorKind::StorageFull, io::ErrorKind::QuotaExceeded, io::ErrorKind::FileTooLarge];

impl SweepError {
    /// What to do about it.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Exists { .. } => Some(
                "continue it with --resume, choose another folder with -o DIR, or replace it with --force",
            ),
            Self::InUse { .. } => Some("wait for it, or choose another folder with -o DIR"),
            Self::Changed { .. } => {
                Some("choose another folder with -o DIR, or throw the old results away with --force")
            }
            Self::Damaged { .. } => {
                Some("put the file back as it was, or throw the results away and begin anew with --force")
            }
            Self::NotASweep { .. } => Some("remove it by hand, or choose another folder with -o DIR"),
            Self::Write { error, .. } if FULL.contains(&error.kind()) => {
                Some("the parts that are written are good: make room, and continue with --resume")
            }
            Self::Incomplete { .. } => Some("continue with --resume"),
            Self::NoRun => Some("write [run] with duration = \"10 s\" and samples = 101"),
            Self::Read { .. } | Self::Write { .. } | Self::Rows { .. } | Self::Batch(_) => None,
        }
    }

    /// For `map_err`, about reading a file.
    pub(crate) fn reading(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |error| Self::Read { path: path.to_owned(), error }
    }

    /// For `map_err`, about writing a file.
    pub(crate) fn writing(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |error| Self::Write { path: path.to_owned(), error }
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exists { folder } => write!(f, "{} is there already", shown(folder)),
            Self::InUse { folder } => write!(f, "{} is in use: another sweep writes to it", shown(folder)),
            Self::Changed { folder, what } => {
                write!(f, "{} holds the results of another plan: {what}", shown(folder))
            }
            Self::NotASweep { folder, why } => {
                write!(f, "{} is not a folder of a sweep: {why}", shown(folder))
            }
            Self::Damaged { path, why } => write!(f, "{} is damaged: {why}", shown(path)),
            Self::Read { path, error } => write!(f, "cannot read {}: {error}", shown(path)),
            Self::Write { path, error } => write!(f, "cannot write {}: {error}", shown(path)),
            Self::Incomplete { part } => write!(f, "part {part} is missing or damaged"),
            Self::Rows { part, why } => write!(f, "these rows are not those of part {part}: {why}"),
            Self::NoRun => write!(f, "the plan has no [run] section, so there is no time to simulate"),
            Self::Batch(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SweepError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read { error, .. } | Self::Write { error, .. } => Some(error),
            Self::Batch(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BatchError> for SweepError {
    fn from(error: BatchError) -> Self {
        Self::Batch(error)
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        Self::usage(error.to_string(), error.hint().unwrap_or_default())
    }
}
