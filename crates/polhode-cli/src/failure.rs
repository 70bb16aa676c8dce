//! How the command fails: what it prints, and its exit status.

use std::io;
use std::path::Path;

use polhode::motion::MotionError;
use polhode_source::{Failure as Request, FormatError};

use crate::stderr::tell;

/// Why the command failed.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A request that has no result.
    Request(Request),
    /// A motion that is written as far as it could be computed.
    Incomplete { path: String, error: MotionError },
    /// Some of several files failed; all have been tried.
    Several(Vec<Failure>),
    /// A result that cannot be written.
    Output { path: String, error: io::Error },
    /// A sweep that was stopped with Ctrl-C or SIGTERM: what is there, how to go on, and the exit status.
    Stopped { done: String, hint: String, status: u8 },
    /// Another program that was run instead, and failed with this status.
    Status(u8),
    /// A model with findings; they are printed already.
    Findings,
    /// Nobody reads the output any more, as after `| head`.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Request(Request::usage(message, hint))
    }

    /// A motion that cannot be computed, of a file or an argument.
    pub(crate) fn motion(path: impl Into<String>, error: MotionError) -> Self {
        Self::Request(Request::Motion { path: path.into(), error })
    }

    /// The failure of one of several files, which it names if it has not done so yet.
    pub(crate) fn about(self, file: &Path) -> Self {
        match self {
            Self::Request(request) => Self::Request(request.about(file)),
            other => other,
        }
    }

    /// What became of several files: nothing, or the failures of some of them.
    pub(crate) fn unless_empty(failures: Vec<Self>) -> Result<(), Self> {
        if failures.is_empty() { Ok(()) } else { Err(Self::Several(failures)) }
    }

    /// Prints the failure and gives the exit status.
    pub(crate) fn report(&self) -> u8 {
        tell(&self.text());
        self.status()
    }

    /// The exit status. Of several failures the worst: 2, what cannot be read or written, is worse than 3, what cannot be computed, and
    /// that than 1, what was found.
    fn status(&self) -> u8 {
        /// From the best to the worst.
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
                // What is printed already has no text.
                let texts = failures.iter().map(Self::text).filter(|text| !text.is_empty());
                texts.collect::<Vec<_>>().join("\n")
            }
            Self::Incomplete { path, error } => {
                let kept = "note: what comes before is written, and marked incomplete";
                format!("error: {error}\n  --> {path}\n{kept}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Output { path, error } => {
                let full =
                    [io::ErrorKind::StorageFull, io::ErrorKind::QuotaExceeded, io::ErrorKind::FileTooLarge];
                let room = "nothing is left half-written: make room, or write to another disk".to_owned();
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
