//! How the command fails: what it prints, and its exit status.

use std::fmt::Write as _;
use std::io;
use std::path::Path;

use polhode::motion::MotionError;
use polhode_document::VERSION;
use polhode_source::{FormatError, Place};
use serde_json::{Value, json};

use crate::stderr::{shown, tell};

/// Why the command failed.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file that cannot be read.
    Input(Box<FormatError>),
    /// A motion that cannot be computed.
    Motion { path: String, error: MotionError },
    /// A motion that is written as far as it could be computed.
    Incomplete { path: String, error: MotionError },
    /// A flag that makes no sense here, or a file that does not fit it.
    Usage { message: String, file: Option<String>, place: Option<[usize; 2]>, hint: Option<String> },
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
        let hint = Some(hint.into()).filter(|hint: &String| !hint.is_empty());
        Self::Usage { message: message.into(), file: None, place: None, hint }
    }

    /// As [`Failure::usage`], at a line and column of a file.
    pub(crate) fn located(
        message: impl Into<String>,
        file: &Path,
        place: [usize; 2],
        hint: impl Into<String>,
    ) -> Self {
        let (message, file, hint) = (message.into(), Some(shown(file)), Some(hint.into()));
        Self::Usage { message, file, place: Some(place), hint }
    }

    /// The failure of one of several files, which it names if it has not done so yet.
    pub(crate) fn about(self, file: &Path) -> Self {
        match self {
            Self::Usage { message, file: None, place, hint } => {
                Self::Usage { message, file: Some(shown(file)), place, hint }
            }
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
            Self::Motion { error, .. } if error.is_numerical() => 3,
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

    /// In the place of the file's object, among those of the files that are fine.
    pub(crate) fn to_json(&self, file: &Path) -> Value {
        let (message, place, hint) = match self {
            Self::Input(error) => {
                let place = error.place().filter(|_| error.path() == file);
                (error.message(), place.map(|place| [place.line, place.column]), error.hint())
            }
            Self::Motion { error, .. } | Self::Incomplete { error, .. } => {
                (error.to_string(), None, error.hint().map(str::to_owned))
            }
            Self::Usage { message, place, hint, .. } => (message.clone(), *place, hint.clone()),
            other => (other.text().trim_start_matches("error: ").trim_end().to_owned(), None, None),
        };
        let [line, column] = place.map_or([None; 2], |place| place.map(Some));
        let error = json!({ "line": line, "column": column, "message": message, "hint": hint });
        json!({ "polhode": VERSION, "file": file.to_string_lossy(), "error": error })
    }

    /// What is wrong, in one line.
    pub(crate) fn line(&self) -> String {
        let text = self.text();
        text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
    }

    fn text(&self) -> String {
        match self {
            Self::Input(error) => input(error),
            Self::Several(failures) => {
                // What is printed already has no text.
                let texts = failures.iter().map(Self::text).filter(|text| !text.is_empty());
                texts.collect::<Vec<_>>().join("\n")
            }
            Self::Motion { path, error } => {
                format!("error: {error}\n  --> {path}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Incomplete { path, error } => {
                let kept = "note: what comes before is written, and marked incomplete";
                format!("error: {error}\n  --> {path}\n{kept}\n{}", hint(error.hint().map(str::to_owned)))
            }
            Self::Usage { message, file, place, hint: advice } => {
                let at = place.map_or_else(String::new, |[line, column]| format!(":{line}:{column}"));
                let file = file.as_ref().map_or_else(String::new, |file| format!("  --> {file}{at}\n"));
                format!("error: {message}\n{file}{}", hint(advice.clone()))
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

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::Input(Box::new(error))
    }
}

fn input(error: &FormatError) -> String {
    let mut text = format!("error: {}\n", error.message());
    match error.cell() {
        Some(cell) => _ = writeln!(text, "  --> {}: {}", shown(error.path()), shown(Path::new(cell))),
        None => snippet(&mut text, error.path(), error.place(), ""),
    }
    if let Some((path, place)) = error.origin() {
        snippet(&mut text, path, Some(place), "named here: ");
    }
    if let Some((path, cell)) = error.origin_cell() {
        let _ = writeln!(text, "  --> named here: {}: {}", shown(path), shown(Path::new(cell)));
    }
    text + &hint(error.hint())
}

/// The line of the file, and a mark under what is wrong with it.
fn snippet(text: &mut String, path: &Path, place: Option<&Place>, note: &str) {
    let path = shown(path);
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

    #[test]
    fn a_failure_names_its_file_once() {
        let file = Path::new("a\u{1b}\nb.stl");
        let text = Failure::usage("the mesh has no part", "name it").about(file).about(Path::new("c")).text();
        assert_eq!(text, "error: the mesh has no part\n  --> a\\u{1b}\\nb.stl\nhint: name it\n");
        let value = Failure::usage("no", "yes").to_json(file);
        assert_eq!(value["file"], "a\u{1b}\nb.stl");
        assert_eq!(value["error"]["message"], "no");
    }
}
