//! What was read of a log.

use std::path::PathBuf;

/// A log that was read, and what of it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadLog {
    /// Where it is.
    pub path: PathBuf,
    /// Columns, and as what they were read: `"time, s: Time (s)"`.
    pub read: Vec<String>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
}
