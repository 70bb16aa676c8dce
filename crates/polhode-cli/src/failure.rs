//! How the command fails: what it prints, and its exit status.

use std::fmt::Write as _;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use polhode::MotionError;
use polhode_formats::{FormatError, Place};
use polhode_sweep::SweepError;

/// Why the command failed.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Files that cannot be read.
    Input(Vec<FormatError>),
    /// A motion that cannot be computed.
    Motion { path: String, error: MotionError },
    /// A motion that is written as far as it could be computed.
    Incomplete { path: String, error: MotionError },
    /// A flag that makes no sense here.
    Usage { message: String, hint: Option<String> },
    /// A result that cannot be written.
    Output { path: String, error: io::Error },
    /// A sweep that cannot be run or kept.
    Sweep(SweepError),
    /// A sweep that was stopped with Ctrl-C: what is there, and how to go on.
    Stopped { done: String, hint: String },
    /// Another program that was run instead, and failed with this status.
    Status(u8),
    /// A model with findings; they are printed already.
    Findings,
    /// Nobody reads the output any more, as after `| head`.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Usage { message: message.into(), hint: Some(hint.into()) }
    }

    /// Prints the failure and gives the exit status.
    pub(crate) fn report(self) -> ExitCode {
        let code = match &self {
            Self::Motion { error, .. } if error.is_numerical() => 3,
            Self::Incomplete { .. } => 3,
            Self::ClosedPipe => return ExitCode::SUCCESS,
            Self::Findings => return ExitCode::from(1),
            Self::Stopped { .. } => 130,
            Self::Status(code) => return ExitCode::from(*code),
            _ => 2,
        };
        // Where standard error is closed there is nobody left to tell.
        let _ = io::Write::write_all(&mut io::stderr(), self.text().as_bytes());
        ExitCode::from(code)
    }

    fn text(&self) -> String {
        match self {
            Self::Input(errors) => errors.iter().map(input).collect::<Vec<_>>().join("\n"),
            Self::Motion { path, error } => {
                format!("error: {error}\n  --> {path}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Incomplete { path, error } => {
                let kept = "note: what comes before is written, and marked incomplete";
                format!("error: {error}\n  --> {path}\n{kept}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Usage { message, hint: advice } => format!("error: {message}\n{}", hint(advice.clone())),
            Self::Output { path, error } => format!("error: cannot write {path}: {error}\n"),
            Self::Sweep(error) => format!("error: {error}\n{}", hint(error.hint().map(str::to_owned))),
            Self::Stopped { done, hint: advice } => {
                format!("stopped: {done}\n{}", hint(Some(advice.clone())))
            }
            Self::Findings | Self::Status(_) | Self::ClosedPipe => String::new(),
        }
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::Input(vec![error])
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        Self::Sweep(error)
    }
}

fn input(error: &FormatError) -> String {
    let mut text = format!("error: {}\n", error.message());
    snippet(&mut text, error.path(), error.place(), "");
    if let Some((path, place)) = error.origin() {
        snippet(&mut text, path, Some(place), "named here: ");
    }
    text + &hint(error.hint())
}

/// The line of the file, and a mark under what is wrong with it.
fn snippet(text: &mut String, path: &Path, place: Option<&Place>, note: &str) {
    let path = path.display().to_string().escape_debug().to_string();
    let Some(Place { line, column, excerpt, marked, .. }) = place else {
        let _ = writeln!(text, "  --> {path}");
        return;
    };
    let margin = line.to_string().len();
    let (before, mark) = (" ".repeat(marked.start), "^".repeat(marked.len().max(1)));
    let _ = writeln!(text, "{:margin$}--> {note}{path}:{line}:{column}", "");
    let _ = writeln!(text, "{:margin$} |", "");
    let _ = writeln!(text, "{line} | {excerpt}");
    let _ = writeln!(text, "{:margin$} | {before}{mark}", "");
}

fn hint(hint: Option<String>) -> String {
    hint.map_or_else(String::new, |hint| format!("hint: {hint}\n"))
}
