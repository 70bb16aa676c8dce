//! What is wrong with an STL file.

use std::error::Error;
use std::fmt;

use polhode_source::text::counted;

/// Length of the header of a binary file, bytes.
pub(crate) const HEADER: usize = 80;
/// Length of the header and the triangle count that precede the records, bytes.
pub(crate) const PREAMBLE: usize = HEADER + 4;
/// Length of the record of one triangle, bytes.
pub(crate) const RECORD: usize = 50;

/// Why bytes are not an STL file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StlError {
    /// Too short for a binary file, and an ASCII file starts with `solid`.
    Unrecognized {
        /// Bytes in the file.
        length: usize,
    },
    /// A binary file whose length does not fit its count.
    WrongCount {
        /// Triangles according to the header.
        declared: u32,
        /// Bytes in the file.
        length: usize,
    },
    /// ASCII that does not follow the grammar.
    Syntax {
        /// Where the token starts.
        at: StlPlace,
        /// What belongs there.
        expected: &'static str,
        /// What stands there; empty at the end of the file.
        found: String,
    },
    /// A coordinate that is infinite or not a number.
    NotFinite {
        /// Where the coordinate starts.
        at: StlPlace,
        /// The coordinate.
        found: String,
    },
    /// A well-formed file with nothing in it.
    NoTriangles,
}

/// A place in an STL file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StlPlace {
    /// In ASCII.
    Text {
        /// Line, from 1.
        line: usize,
        /// Byte in the line, from 1.
        column: usize,
    },
    /// In binary.
    Record {
        /// Triangle, from 0.
        index: usize,
        /// Byte in the file, from 0.
        offset: usize,
    },
}

impl StlError {
    /// Where in the file; `None` if it is about the file as a whole.
    pub fn place(&self) -> Option<StlPlace> {
        match self {
            Self::Syntax { at, .. } | Self::NotFinite { at, .. } => Some(*at),
            Self::Unrecognized { .. } | Self::WrongCount { .. } | Self::NoTriangles => None,
        }
    }

    /// What is wrong, without the place.
    pub fn message(&self) -> String {
        match self {
            Self::Unrecognized { length } => format!("{} that are not an STL file", counted(*length, "byte")),
            Self::WrongCount { declared, length } => format!(
                "the header of the binary STL file declares {}, but {} whole ones and {} \
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

    /// What to do about it, when there is something to say.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Unrecognized { .. } => {
                Some("an STL file starts with \"solid\" (ASCII) or has at least 84 bytes (binary)")
            }
            Self::WrongCount { declared, length } if whole_records(*length) < *declared as usize => {
                Some("the file is cut short, or it is not an STL file")
            }
            Self::WrongCount { .. } => Some("the file has bytes that belong to no triangle; export it again"),
            Self::Syntax { expected: "a number", found, .. } if found.contains(',') => {
                Some("the decimal sign is a point")
            }
            Self::Syntax { expected: "endloop", found, .. } if found.eq_ignore_ascii_case("vertex") => {
                Some("a facet has three vertices; triangulate the faces before exporting")
            }
            Self::Syntax { found, .. } if found.is_empty() => Some("the file is cut short"),
            Self::NoTriangles => Some("export the solid body, not the empty document"),
            Self::Syntax { .. } => {
                Some("a facet is facet normal, outer loop, three times vertex x y z, endloop, endfacet")
            }
            Self::NotFinite { .. } => {
                Some("the tool that made the mesh wrote no number here: repair it there, and export it again")
            }
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

/// Records that a binary file of this length has.
fn whole_records(length: usize) -> usize {
    length.saturating_sub(PREAMBLE) / RECORD
}
