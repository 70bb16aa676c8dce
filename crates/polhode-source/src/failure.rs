//! Failures of requests: what is wrong, where, and what to do.

use std::fmt::{self, Write as _};
use std::path::Path;

use polhode::motion::MotionError;
use serde_json::{Value, json};

use crate::error::{FormatError, Place};
use crate::text::escaped;

/// Reason why a request has no result.
///
/// Its text is what the command prints: the message, the place with the line of the file, and advice.
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
        /// What is about: the path of a file, or an argument.
        path: String,
        /// Why.
        error: MotionError,
    },
    /// A request that makes no sense, or a file that does not fit it.
    Usage {
        /// What is wrong.
        message: String,
        /// The file that it is about.
        file: Option<String>,
        /// The line and column in the file.
        place: Option<[usize; 2]>,
        /// Advice.
        hint: Option<String>,
    },
}

impl Failure {
    /// A request that makes no sense; no advice if `hint` is empty.
    pub fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        let hint = Some(hint.into()).filter(|hint: &String| !hint.is_empty());
        Self::Usage { message: message.into(), file: None, place: None, hint }
    }

    /// As [`Failure::usage`], at a line and column of a file.
    pub fn located(
        message: impl Into<String>,
        file: &Path,
        place: [usize; 2],
        hint: impl Into<String>,
    ) -> Self {
        let (message, file, hint) = (message.into(), Some(shown(file)), Some(hint.into()));
        Self::Usage { message, file, place: Some(place), hint }
    }

    /// A motion of a file that cannot be computed.
    pub fn of_motion(file: &Path, error: MotionError) -> Self {
        Self::Motion { path: shown(file), error }
    }

    /// The failure of one of several files, which it names if it has not done so yet.
    #[must_use]
    pub fn about(self, file: &Path) -> Self {
        match self {
            Self::Usage { message, file: None, place, hint } => {
                Self::Usage { message, file: Some(shown(file)), place, hint }
            }
            other => other,
        }
    }

    /// Returns true if the request was right and the computation could not reach its tolerance.
    pub fn is_numerical(&self) -> bool {
        matches!(self, Self::Motion { error, .. } if error.is_numerical())
    }

    /// Returns what is wrong, without place and advice.
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

    /// Returns `line` and `column` in the file, `message` and `hint`; `null` for what there is not.
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

/// A path within a message: on one line, whatever is in it.
pub fn shown(path: &Path) -> String {
    escaped(&path.to_string_lossy())
}

/// Where an error is, and where the file with the error is named.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_names_its_file_once() {
        let file = Path::new("a\u{1b}\nb.stl");
        let failure = Failure::usage("the mesh has no part", "name it").about(file).about(Path::new("c"));
        assert_eq!(
            failure.to_string(),
            "error: the mesh has no part\n  --> a\\u{1b}\\nb.stl\nhint: name it\n"
        );
    }
}
