//! What Rust refuses, as Python's exceptions.

use std::io::ErrorKind;

use polhode::body::BodyError;
use polhode::math::RotationError;
use polhode::motion::MotionError;
use polhode_source::{FormatError, FormatErrorKind, Place};
use pyo3::PyErr;
use pyo3::exceptions::PyOSError;

pyo3::import_exception!(polhode._error, PolhodeError);

/// An error of the library as `polhode.PolhodeError(message, hint, path, line, column)`.
pub(crate) trait Raise {
    /// The exception.
    fn raise(self) -> PyErr;
}

/// `PolhodeError` with no place.
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

/// The number of an error of the system of which Python has a class of its own: it is the same everywhere.
pub(crate) const fn system_number(kind: ErrorKind) -> Option<i32> {
    match kind {
        ErrorKind::NotFound => Some(2),          // ENOENT
        ErrorKind::PermissionDenied => Some(13), // EACCES
        ErrorKind::IsADirectory => Some(21),     // EISDIR
        _ => None,
    }
}

impl Raise for FormatError {
    /// A file that is not there, may not be read, or is a folder, is Python's own `FileNotFoundError`, `PermissionError` or `IsADirectoryError`.
    fn raise(self) -> PyErr {
        if let FormatErrorKind::Io { file, kind, why } = self.kind()
            && let Some(number) = system_number(*kind)
        {
            // A file that another one names is said with its place there.
            let words = if self.place().is_some() { self.to_string() } else { why.clone() };
            return PyOSError::new_err((number, words, file.clone()));
        }
        raised_by("", self)
    }
}

/// An error of a text, with what its message begins with.
pub(crate) fn raised_by(what: &str, error: FormatError) -> PyErr {
    let (words, hint, path) = (format!("{what}{error}"), error.hint(), error.path().display().to_string());
    match error.place() {
        None => PolhodeError::new_err((words, hint, path)),
        Some(Place { line, column, .. }) => PolhodeError::new_err((words, hint, path, *line, *column)),
    }
}
