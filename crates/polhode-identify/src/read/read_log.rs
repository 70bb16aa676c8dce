//! What was read of a log.

use std::path::PathBuf;

use polhode_source::shown;

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

impl ReadLog {
    /// Returns what was read of it, line by line.
    pub fn lines(&self) -> impl Iterator<Item = String> + use<> {
        let path = shown(&self.path);
        let read = format!("{path}: {}", self.read.join("; "));
        let ignored =
            (!self.ignored.is_empty()).then(|| format!("Not read of {path}: {}", self.ignored.join(", ")));
        [Some(read), ignored].into_iter().flatten()
    }
}
