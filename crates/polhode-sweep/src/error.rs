//! Errors of running or storing a sweep.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use polhode_source::{Failure, shown};

use crate::batch::BatchError;

/// Error of running or storing a sweep.
#[derive(Debug)]
#[non_exhaustive]
pub enum SweepError {
    /// Folder that exists already.
    Exists {
        /// Path of the folder.
        folder: PathBuf,
    },
    /// Folder that another process is writing to.
    InUse {
        /// Path of the folder.
        folder: PathBuf,
    },
    /// Folder with the results of another plan.
    Changed {
        /// Path of the folder.
        folder: PathBuf,
        /// Difference to this plan.
        what: String,
    },
    /// Folder with content other than a sweep.
    NotASweep {
        /// Path of the folder.
        folder: PathBuf,
        /// Unexpected or missing content.
        why: String,
    },
    /// File of the sweep that differs from what was written.
    Damaged {
        /// Path of the file.
        path: PathBuf,
        /// Description of the damage.
        why: &'static str,
    },
    /// File that cannot be read.
    Read {
        /// Path of the file.
        path: PathBuf,
        /// Error of the system.
        error: io::Error,
    },
    /// File that cannot be written.
    Write {
        /// Path of the file.
        path: PathBuf,
        /// Error of the system.
        error: io::Error,
    },
    /// Part that is missing or damaged.
    Incomplete {
        /// Number of the part.
        part: u64,
    },
    /// Rows that do not belong to the part.
    Rows {
        /// Number of the part.
        part: u64,
        /// Description of the mismatch.
        why: String,
    },
    /// Plan without times for the simulation.
    NoRun,
    /// Columns that do not form a table.
    Batch(BatchError),
}

/// Errors of the system that mean lack of space.
const FULL: [io::ErrorKind; 3] =
    [io::ErrorKind::StorageFull, io::ErrorKind::QuotaExceeded, io::ErrorKind::FileTooLarge];

impl SweepError {
    /// Returns a hint on how to fix the error, if there is one.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Exists { .. } => Some(
                "continue it with --resume, choose another folder with -o DIR, or replace it with --force",
            ),
            Self::InUse { .. } => Some("wait until it ends, or choose another folder with -o DIR"),
            Self::Changed { .. } => {
                Some("choose another folder with -o DIR, or delete the old results with --force")
            }
            Self::Damaged { .. } => {
                Some("restore the file, or delete the results and start again with --force")
            }
            Self::NotASweep { .. } => Some("delete it yourself, or choose another folder with -o DIR"),
            Self::Write { error, .. } if FULL.contains(&error.kind()) => {
                Some("the parts written so far are valid: free some space and continue with --resume")
            }
            Self::Incomplete { .. } => Some("continue with --resume"),
            Self::NoRun => Some("add [run] with duration = \"10 s\" and samples = 101"),
            Self::Read { .. } | Self::Write { .. } | Self::Rows { .. } | Self::Batch(_) => None,
        }
    }

    /// Returns a function for `map_err` that reports an error of reading a file.
    pub(crate) fn reading(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |error| Self::Read { path: path.to_owned(), error }
    }

    /// Returns a function for `map_err` that reports an error of writing a file.
    pub(crate) fn writing(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |error| Self::Write { path: path.to_owned(), error }
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exists { folder } => write!(f, "{} already exists", shown(folder)),
            Self::InUse { folder } => write!(f, "{} is in use by another sweep", shown(folder)),
            Self::Changed { folder, what } => {
                write!(f, "{} contains the results of another plan: {what}", shown(folder))
            }
            Self::NotASweep { folder, why } => {
                write!(f, "{} is not the folder of a sweep: {why}", shown(folder))
            }
            Self::Damaged { path, why } => write!(f, "{} is damaged: {why}", shown(path)),
            Self::Read { path, error } => write!(f, "cannot read {}: {error}", shown(path)),
            Self::Write { path, error } => write!(f, "cannot write {}: {error}", shown(path)),
            Self::Incomplete { part } => write!(f, "part {part} is missing or damaged"),
            Self::Rows { part, why } => write!(f, "the rows do not belong to part {part}: {why}"),
            Self::NoRun => write!(f, "the plan has no [run] section, which sets the simulated time"),
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
