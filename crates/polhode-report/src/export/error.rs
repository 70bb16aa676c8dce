//! Why a format cannot say something.

use std::fmt;

use polhode_document::layout::printable;
use polhode_document::number::exact;

use super::ExportFormat;

/// Why bodies cannot be written in a format: what, the value and the rule that it breaks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ExportError {
    /// There is no body to write.
    Empty,
    /// Several bodies in a format whose file is one body.
    Several {
        /// The format.
        format: ExportFormat,
        /// How many there are.
        bodies: usize,
    },
    /// A name that the format does not allow.
    Name {
        /// The format.
        format: ExportFormat,
        /// The name.
        name: String,
        /// What the format wants.
        rule: &'static str,
    },
    /// A number that the format cannot hold.
    Range {
        /// The format.
        format: ExportFormat,
        /// The body's name.
        body: String,
        /// What the number is.
        what: &'static str,
        /// The number, SI.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
}

impl ExportError {
    /// What to do about it.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::Empty => "give a body",
            Self::Several { .. } => "write a file for each, or use sdf, mjcf, usd or csv",
            Self::Name { .. } => "give the body another name",
            Self::Range { .. } => {
                "use a format that keeps double precision and the tensor alone: csv, sdf or urdf"
            }
        }
    }
}

impl fmt::Display for ExportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "no body to write"),
            Self::Several { format, bodies } => {
                write!(f, "{bodies} bodies for one file of {}: its links would need joints", format.name())
            }
            Self::Name { format, name, rule } => {
                write!(f, "the name '{}' cannot stand in {}: {rule}", printable(name), format.name())
            }
            Self::Range { format, body, what, value, rule } => {
                let (body, value) = (printable(body), exact(*value));
                write!(f, "{what} of '{body}', {value}, cannot stand in {}: {rule}", format.name())
            }
        }
    }
}

impl std::error::Error for ExportError {}
