//! Failures of requests, with place and advice.

use std::fmt::{self, Write as _};
use std::path::Path;

use polhode::motion::MotionError;
use serde_json::{Value, json};

use crate::error::{FormatError, Place};
use crate::text::escaped;

/// Reason why a request has no result.
///
/// Displays as the command prints it: message, place with the line of the file, and advice.
///
/// ```
/// use polhode_source::Failure;
/// let failure = Failure::usage("no log to judge was given", "name the log that a program wrote");
/// assert_eq!(failure.to_string(), "error: no log to judge was given\nhint: name the log that a program wrote\n");
/// assert_eq!(failure.message(), "no log to judge was given");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// A file that cannot be read.
    Input(Box<FormatError>),
    /// A motion that cannot be computed.
    Motion {
        /// Subject of the error: the path of a file, or an argument.
        path: String,
        /// Reason of the failure.
        error: MotionError,
    },
    /// An invalid request, or a file that does not fit the request.
    Usage {
        /// Message without place and advice.
        message: String,
        /// Path of the file, if one is concerned.
        file: Option<String>,
        /// Line and column in the file, from 1.
        place: Option<[usize; 2]>,
        /// Advice for the user.
        hint: Option<String>,
    },
}

impl Failure {
    /// Creates a failure for an invalid request; an empty `hint` means no advice.
    pub fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        let hint = Some(hint.into()).filter(|hint: &String| !hint.is_empty());
        Self::Usage { message: message.into(), file: None, place: None, hint }
    }

    /// Creates a failure for an invalid request, as [`Failure::usage`] does, at a place in a file.
    pub fn located(
        message: impl Into<String>,
        file: &Path,
        place: [usize; 2],
        hint: impl Into<String>,
    ) -> Self {
        let (message, file, hint) = (message.into(), Some(shown(file)), Some(hint.into()));
        Self::Usage { message, file, place: Some(place), hint }
    }

    /// Creates a failure for the motion of a file that cannot be computed.
    pub fn of_motion(file: &Path, error: MotionError) -> Self {
        Self::Motion { path: shown(file), error }
    }

    /// Returns the failure with the path of its file, unless it has one already.
    #[must_use]
    pub fn in_file(self, file: &Path) -> Self {
        match self {
            Self::Usage { message, file: None, place, hint } => {
                Self::Usage { message, file: Some(shown(file)), place, hint }
            }
            other => other,
        }
    }

    /// Returns true if the request is valid but the computation does not reach its tolerance.
    pub fn is_numerical(&self) -> bool {
        matches!(self, Self::Motion { error, .. } if error.is_numerical())
    }

    /// Returns the message without place and advice.
    pub fn message(&self) -> String {
        match self {
            Self::Input(error) => error.message(),
            Self::Motion { error, .. } => error.to_string(),
            Self::Usage { message, .. } => message.clone(),
        }
    }

    /// Returns the advice, if there is one.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Input(error) => error.hint(),
            Self::Motion { error, .. } => error.hint().map(str::to_owned),
            Self::Usage { hint, .. } => hint.clone(),
        }
    }

    /// Returns the line and column in a file, if the failure is at a place of it.
    pub fn place_in(&self, file: &Path) -> Option<[usize; 2]> {
        match self {
            Self::Input(error) => {
                error.place().filter(|_| error.path() == file).map(|place| [place.line, place.column])
            }
            Self::Motion { .. } => None,
            Self::Usage { place, .. } => *place,
        }
    }

    /// Returns an object with `line` and `column` in the file, `message` and `hint`; missing ones
    /// are `null`.
    pub fn to_json(&self, file: &Path) -> Value {
        let [line, column] = self.place_in(file).map_or([None; 2], |place| place.map(Some));
        json!({ "line": line, "column": column, "message": self.message(), "hint": self.hint() })
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::Input(Box::new(error))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "error: {}", self.message())?;
        match self {
            Self::Input(error) => f.write_str(&places(error))?,
            Self::Motion { path, .. } => writeln!(f, "  --> {path}")?,
            Self::Usage { file, place, .. } => {
                let at = place.map_or_else(String::new, |[line, column]| format!(":{line}:{column}"));
                file.iter().try_for_each(|file| writeln!(f, "  --> {file}{at}"))?;
            }
        }
        self.hint().iter().try_for_each(|hint| writeln!(f, "hint: {hint}"))
    }
}

impl std::error::Error for Failure {}

/// Returns a path as messages print it: on one line, with control characters escaped.
pub fn shown(path: &Path) -> String {
    escaped(&path.to_string_lossy())
}

/// Returns the place of an error, and the place that names its file.
fn places(error: &FormatError) -> String {
    let mut text = String::new();
    match error.cell() {
        Some(cell) => _ = writeln!(text, "  --> {}: {}", shown(error.path()), escaped(cell)),
        None => snippet(&mut text, error.path(), error.place(), ""),
    }
    if let Some((path, place)) = error.origin() {
        snippet(&mut text, path, Some(place), "named here: ");
    }
    if let Some((path, cell)) = error.origin_cell() {
        let _ = writeln!(text, "  --> named here: {}: {}", shown(path), escaped(cell));
    }
    text
}

/// Appends the line of the file with a mark under the error.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_names_its_file_once() {
        let file = Path::new("a\u{1b}\nb.stl");
        let failure = Failure::usage("the mesh has no part", "name it").in_file(file).in_file(Path::new("c"));
        assert_eq!(
            failure.to_string(),
            "error: the mesh has no part\n  --> a\\u{1b}\\nb.stl\nhint: name it\n"
        );
    }
}
