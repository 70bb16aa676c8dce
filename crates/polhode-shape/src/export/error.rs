//! Errors of formats that cannot represent a body.

use std::fmt;

use polhode_document::layout::printable;
use polhode_document::number::exact;

use super::ExportFormat;

/// Error of an export: the quantity, its value and the rule that it violates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ExportError {
    /// The list of bodies is empty.
    Empty,
    /// Several bodies are given for a format with one body per file.
    Several {
        /// Requested format.
        format: ExportFormat,
        /// Number of bodies.
        bodies: usize,
    },
    /// The format does not allow a name.
    Name {
        /// Requested format.
        format: ExportFormat,
        /// Name of the body.
        name: String,
        /// Rule of the format.
        rule: &'static str,
    },
    /// The format cannot represent a number.
    Range {
        /// Requested format.
        format: ExportFormat,
        /// Name of the body.
        body: String,
        /// Name of the quantity.
        what: &'static str,
        /// Value, SI units.
        value: f64,
        /// Rule of the format.
        rule: &'static str,
    },
}

impl ExportError {
    /// Returns a hint.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Empty => "give at least one body",
            Self::Several { .. } => "write one file per body, or use sdf, mjcf, usd or csv",
            Self::Name { .. } => "rename the body",
            Self::Range { .. } => {
                "use a format with double precision that stores only the tensor: csv, sdf or urdf"
            }
        }
    }
}

impl fmt::Display for ExportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "no body to write"),
            Self::Several { format, bodies } => {
                write!(f, "{bodies} bodies in one {} file: its links would need joints", format.name())
            }
            Self::Name { format, name, rule } => {
                write!(f, "the name '{}' is not allowed in {}: {rule}", printable(name), format.name())
            }
            Self::Range { format, body, what, value, rule } => {
                let (body, value) = (printable(body), exact(*value));
                write!(f, "{what} of '{body}', {value}, is not allowed in {}: {rule}", format.name())
            }
        }
    }
}

impl std::error::Error for ExportError {}
