//! Errors of STL files.

use std::error::Error;
use std::fmt;

use polhode_source::text::counted;

/// Length of the header of a binary file, bytes.
pub(crate) const HEADER: usize = 80;
/// Length of the header and the triangle count that precede the records, bytes.
pub(crate) const PREAMBLE: usize = HEADER + 4;
/// Length of the record of one triangle, bytes.
pub(crate) const RECORD: usize = 50;

/// Error of an STL file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StlError {
    /// The file is too short for a binary file, and does not start with `solid`.
    Unrecognized {
        /// Length of the file, bytes.
        length: usize,
    },
    /// The length of a binary file does not agree with its count.
    WrongCount {
        /// Number of triangles in the header.
        declared: u32,
        /// Length of the file, bytes.
        length: usize,
    },
    /// The ASCII text does not follow the grammar.
    Syntax {
        /// Start of the token.
        at: StlPlace,
        /// Keyword or kind of value that the grammar requires.
        expected: &'static str,
        /// Token found; empty at the end of the file.
        found: String,
    },
    /// A coordinate is infinite or NaN.
    NotFinite {
        /// Start of the coordinate.
        at: StlPlace,
        /// Text of the coordinate.
        found: String,
    },
    /// The file is well-formed but has no triangles.
    NoTriangles,
}

/// Position in an STL file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StlPlace {
    /// Position in an ASCII file.
    Text {
        /// Line, from 1.
        line: usize,
        /// Byte in the line, from 1.
        column: usize,
    },
    /// Position in a binary file.
    Record {
        /// Index of the triangle, from 0.
        index: usize,
        /// Offset in the file, bytes.
        offset: usize,
    },
}

impl StlError {
    /// Returns the position; `None` if the error is about the whole file.
    pub fn place(&self) -> Option<StlPlace> {
        match self {
            Self::Syntax { at, .. } | Self::NotFinite { at, .. } => Some(*at),
            Self::Unrecognized { .. } | Self::WrongCount { .. } | Self::NoTriangles => None,
        }
    }

    /// Returns the message without the position.
    pub fn message(&self) -> String {
        match self {
            Self::Unrecognized { length } => format!("{} that are not an STL file", counted(*length, "byte")),
            Self::WrongCount { declared, length } => format!(
                "the header of the binary STL file declares {}, but {} complete ones and {} \
                 follow ({} in the file)",
                counted(*declared as usize, "triangle"),
                whole_records(*length),
                counted(length.saturating_sub(PREAMBLE) % RECORD, "byte"),
                counted(*length, "byte"),
            ),
            Self::Syntax { expected, found, .. } if found.is_empty() => {
                format!("expected {expected}, found the end of the file")
            }
            Self::Syntax { expected, found, .. } => format!("expected {expected}, found {found:?}"),
            Self::NotFinite { found, .. } => format!("the coordinate {found} is not finite"),
            Self::NoTriangles => "the STL file has no triangles".to_owned(),
        }
    }

    /// Returns a hint, if there is one.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Unrecognized { .. } => {
                Some("an STL file starts with \"solid\" (ASCII) or has at least 84 bytes (binary)")
            }
            Self::WrongCount { declared, length } if whole_records(*length) < *declared as usize => {
                Some("the file is truncated, or it is not an STL file")
            }
            Self::WrongCount { .. } => Some("the file has bytes after the last triangle; export it again"),
            Self::Syntax { expected: "a number", found, .. } if found.contains(',') => {
                Some("use a decimal point")
            }
            Self::Syntax { expected: "endloop", found, .. } if found.eq_ignore_ascii_case("vertex") => {
                Some("a facet has three vertices; triangulate the faces before exporting")
            }
            Self::Syntax { found, .. } if found.is_empty() => Some("the file is truncated"),
            Self::NoTriangles => Some("export the solid body, not the empty document"),
            Self::Syntax { .. } => {
                Some("a facet is: facet normal, outer loop, three times vertex x y z, endloop, endfacet")
            }
            Self::NotFinite { .. } => Some(
                "the program that created the mesh wrote an invalid number: fix it there, and export it again",
            ),
        }
    }
}

impl fmt::Display for StlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place() {
            Some(at) => write!(f, "{at}: {}", self.message()),
            None => f.write_str(&self.message()),
        }
    }
}

impl Error for StlError {}

impl fmt::Display for StlPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text { line, column } => write!(f, "line {line}, column {column}"),
            Self::Record { index, offset } => write!(f, "triangle {index} (counted from 0), byte {offset}"),
        }
    }
}

/// Returns the number of complete records in a binary file of this length.
fn whole_records(length: usize) -> usize {
    length.saturating_sub(PREAMBLE) / RECORD
}
