//! Summary of the columns of a log.

use std::path::PathBuf;

use polhode_source::shown;

/// Log with its used and ignored columns.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadLog {
    /// Path of the log.
    pub path: PathBuf,
    /// Quantities with their columns: `"time, s: Time (s)"`.
    pub read: Vec<String>,
    /// Names of columns without use.
    pub ignored: Vec<String>,
}

impl ReadLog {
    /// Returns the summary, line by line.
    pub fn lines(&self) -> impl Iterator<Item = String> + use<> {
        let path = shown(&self.path);
        let read = format!("Columns of {path}: {}", self.read.join("; "));
        let ignored = (!self.ignored.is_empty())
            .then(|| format!("Ignored columns of {path}: {}", self.ignored.join(", ")));
        [Some(read), ignored].into_iter().flatten()
    }
}
