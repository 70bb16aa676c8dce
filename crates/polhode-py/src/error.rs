//! Conversion of Rust errors to Python exceptions.

use std::io::ErrorKind;

use polhode::body::BodyError;
use polhode::math::RotationError;
use polhode::motion::MotionError;
use polhode_source::{Failure, FormatError, FormatErrorKind, Place};
use pyo3::PyErr;
use pyo3::exceptions::PyOSError;

pyo3::import_exception!(polhode._error, PolhodeError);

/// Error of the library, raised as `polhode.PolhodeError(message, hint, path, line, column)`.
pub(crate) trait Raise {
    /// Returns the Python exception.
    fn raise(self) -> PyErr;
}

/// Returns a `PolhodeError` without a place.
pub(crate) fn refused(message: impl ToString, hint: Option<&str>) -> PyErr {
    PolhodeError::new_err((message.to_string(), hint.map(str::to_owned)))
}

impl Raise for BodyError {
    fn raise(self) -> PyErr {
        refused(&self, self.hint())
    }
}

impl Raise for MotionError {
    fn raise(self) -> PyErr {
        refused(&self, self.hint())
    }
}

impl Raise for RotationError {
    fn raise(self) -> PyErr {
        refused(self, None)
    }
}

/// Returns the `errno` of an error that has its own Python class; these numbers are the same on all
/// systems.
pub(crate) const fn system_number(kind: ErrorKind) -> Option<i32> {
    match kind {
        ErrorKind::NotFound => Some(2),          // ENOENT
        ErrorKind::PermissionDenied => Some(13), // EACCES
        ErrorKind::IsADirectory => Some(21),     // EISDIR
        _ => None,
    }
}

impl Raise for FormatError {
    /// Returns `FileNotFoundError`, `PermissionError` or `IsADirectoryError` for a file that is
    /// missing, not readable, or a folder.
    fn raise(self) -> PyErr {
        if let FormatErrorKind::Io { file, kind, why } = self.kind()
            && let Some(number) = system_number(*kind)
        {
            // If another file names the file, the message contains the place in that file.
            let words = if self.place().is_some() { self.to_string() } else { why.clone() };
            return PyOSError::new_err((number, words, file.clone()));
        }
        raised_by("", self)
    }
}

impl Raise for Failure {
    fn raise(self) -> PyErr {
        match self {
            Self::Input(error) => error.raise(),
            Self::Motion { error, .. } => error.raise(),
            Self::Usage { message, hint, .. } => refused(message, hint.as_deref()),
        }
    }
}

/// Returns the exception for an error in a text; `what` is the start of its message.
pub(crate) fn raised_by(what: &str, error: FormatError) -> PyErr {
    let (words, hint, path) = (format!("{what}{error}"), error.hint(), error.path().display().to_string());
    match error.place() {
        None => PolhodeError::new_err((words, hint, path)),
        Some(Place { line, column, .. }) => PolhodeError::new_err((words, hint, path, *line, *column)),
    }
}
