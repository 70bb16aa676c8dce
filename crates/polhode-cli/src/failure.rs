//! Failures of the command: messages and exit status.

use std::io;
use std::path::Path;

use polhode::motion::MotionError;
use polhode_source::{Failure as Request, FormatError};

use crate::stderr::tell;

/// Reason of a failure.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Request without a result.
    Request(Request),
    /// Motion that is written up to the last time that could be computed.
    Incomplete { path: String, error: MotionError },
    /// Failures of some of several files; all files were tried.
    Several(Vec<Failure>),
    /// Result that cannot be written.
    Output { path: String, error: io::Error },
    /// Sweep stopped by Ctrl-C or SIGTERM: its progress, how to continue, and the exit status.
    Stopped { done: String, hint: String, status: u8 },
    /// Exit status of another program that was run instead.
    Status(u8),
    /// Model with findings, which are printed already.
    Findings,
    /// Closed output pipe, as after `| head`.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Request(Request::usage(message, hint))
    }

    /// Creates the failure for a motion that cannot be computed; `path` is its file or argument.
    pub(crate) fn motion(path: impl Into<String>, error: MotionError) -> Self {
        Self::Request(Request::Motion { path: path.into(), error })
    }

    /// Returns the failure with the path of its file, unless it has one already.
    pub(crate) fn in_file(self, file: &Path) -> Self {
        match self {
            Self::Request(request) => Self::Request(request.in_file(file)),
            other => other,
        }
    }

    /// Returns `Ok` for an empty list, else [`Self::Several`].
    pub(crate) fn unless_empty(failures: Vec<Self>) -> Result<(), Self> {
        if failures.is_empty() { Ok(()) } else { Err(Self::Several(failures)) }
    }

    /// Prints the failure and returns the exit status.
    pub(crate) fn report(&self) -> u8 {
        tell(&self.text());
        self.status()
    }

    /// Returns the exit status. Of several failures the worst counts: 2 (cannot read or write),
    /// then 3 (cannot compute), then 1 (findings).
    fn status(&self) -> u8 {
        /// Exit statuses from best to worst.
        const ORDER: [u8; 4] = [0, 1, 3, 2];
        match self {
            Self::Request(request) if request.is_numerical() => 3,
            Self::Incomplete { .. } => 3,
            Self::ClosedPipe => 0,
            Self::Findings => 1,
            Self::Stopped { status, .. } | Self::Status(status) => *status,
            Self::Several(failures) => {
                let rank = |failure: &Self| ORDER.iter().position(|status| *status == failure.status());
                failures.iter().filter_map(rank).max().and_then(|k| ORDER.get(k)).copied().unwrap_or(2)
            }
            _ => 2,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Request(request) => request.to_string(),
            Self::Several(failures) => {
                // Failures that are printed already have no text.
                let texts = failures.iter().map(Self::text).filter(|text| !text.is_empty());
                texts.collect::<Vec<_>>().join("\n")
            }
            Self::Incomplete { path, error } => {
                let kept = "note: the motion up to this time is written and marked incomplete";
                format!("error: {error}\n  --> {path}\n{kept}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Output { path, error } => {
                let full =
                    [io::ErrorKind::StorageFull, io::ErrorKind::QuotaExceeded, io::ErrorKind::FileTooLarge];
                let room = "no incomplete file is left; free disk space, or write to another disk".to_owned();
                let room = full.contains(&error.kind()).then_some(room);
                format!("error: cannot write {path}: {error}\n{}", hint(room))
            }
            Self::Stopped { done, hint: advice, .. } => {
                format!("stopped: {done}\n{}", hint(Some(advice.clone())))
            }
            Self::Findings | Self::Status(_) | Self::ClosedPipe => String::new(),
        }
    }
}

impl From<Request> for Failure {
    fn from(request: Request) -> Self {
        Self::Request(request)
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::Request(error.into())
    }
}

fn hint(hint: Option<String>) -> String {
    hint.map_or_else(String::new, |hint| format!("hint: {hint}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_several_failures_the_worst_counts() {
        let path = || "a.toml".to_owned();
        let numerical = || MotionError::NotFinite { time: 1.0 };
        let incomplete = || Failure::Incomplete { path: path(), error: numerical() };
        let several = |failures: Vec<Failure>| Failure::Several(failures).status();
        assert_eq!(several(vec![Failure::Findings, Failure::Findings]), 1);
        assert_eq!(several(vec![incomplete(), Failure::Findings]), 3);
        assert_eq!(several(vec![Failure::Findings, Failure::usage("no", "hint"), incomplete()]), 2);
        assert_eq!(several(vec![Failure::ClosedPipe, Failure::Findings]), 1);
    }
}
