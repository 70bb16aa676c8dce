//! What Rust refuses, as Python's exceptions.

use polhode::body::BodyError;
use polhode::math::RotationError;
use polhode::motion::MotionError;
use polhode_formats::{FormatError, FormatErrorKind, Place};
use polhode_identify::IdentifyError;
use pyo3::PyErr;
use pyo3::exceptions::PyFileNotFoundError;

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

impl Raise for IdentifyError {
    fn raise(self) -> PyErr {
        refused(&self, self.hint())
    }
}

impl Raise for RotationError {
    fn raise(self) -> PyErr {
        refused(self, None)
    }
}

impl Raise for FormatError {
    /// A file that is not there is Python's own `FileNotFoundError`.
    fn raise(self) -> PyErr {
        if let FormatErrorKind::Io { kind: std::io::ErrorKind::NotFound, .. } = self.kind() {
            return PyFileNotFoundError::new_err(self.to_string());
        }
        let Place { line, column, .. } = match self.place() {
            Some(place) => place,
            None => return PolhodeError::new_err((self.to_string(), self.hint(), path(&self))),
        };
        PolhodeError::new_err((self.to_string(), self.hint(), path(&self), *line, *column))
    }
}

fn path(error: &FormatError) -> String {
    error.path().display().to_string()
}
