//! Errors of reading a file, with their places.

use std::error::Error;
use std::fmt;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use polhode::body::BodyError;
use polhode::math::RotationError;
use polhode::motion::MotionError;

use crate::content::{ContentError, ContentPlace};
use crate::expression::ExpressionError;
use crate::suggestion::nearest;
use crate::text::{cut, escaped, is_utf16, visible};
use crate::unit::UnitError;

/// Error of reading a file: path, place, content found there, broken rule, and advice.
///
/// Prints as `path:line:column: message`. [`FormatError::place`] returns the line for a snippet.
#[derive(Clone, Debug, PartialEq)]
pub struct FormatError(Box<Report>);

#[derive(Clone, Debug, PartialEq)]
struct Report {
    path: PathBuf,
    place: Option<Spot>,
    kind: FormatErrorKind,
    hint: Option<String>,
    named_in: Option<(PathBuf, Spot)>,
}

/// A place in a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Spot {
    /// Place in a text file.
    Text(Place),
    /// Cell of a workbook, in spreadsheet notation: `parts!F12`.
    Cell(String),
}

/// Kind of error in a file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FormatErrorKind {
    /// The file cannot be opened or read.
    Io {
        /// Path as the user wrote it.
        file: String,
        /// Kind of the I/O error.
        kind: io::ErrorKind,
        /// Description of the failure.
        why: String,
    },
    /// A text file that is not UTF-8.
    NotUtf8 {
        /// First invalid byte.
        byte: u8,
    },
    /// UTF-16 text; only UTF-8 is read.
    Utf16,
    /// Text that violates the grammar of TOML.
    Toml {
        /// Message of the parser.
        message: String,
    },
    /// An unknown key.
    UnknownKey {
        /// The unknown key.
        key: String,
        /// Name of the table that contains the key.
        table: String,
        /// Closest known key, if one is close.
        suggestion: Option<&'static str>,
        /// All known keys of this table.
        known: Vec<&'static str>,
    },
    /// A required key that is missing.
    MissingKey {
        /// The missing key.
        key: &'static str,
        /// Name of the table without the key.
        table: String,
        /// Example of a valid line.
        example: &'static str,
    },
    /// Two keys that exclude each other.
    Conflict {
        /// The two keys, in the order of the file.
        keys: [&'static str; 2],
        /// Reason for the conflict.
        rule: &'static str,
    },
    /// A value of the wrong type, or an array of the wrong length.
    WrongType {
        /// Key of the value.
        key: String,
        /// Expected type.
        expected: String,
        /// Type found.
        found: String,
    },
    /// A value that breaks a rule.
    Value {
        /// Key of the value.
        key: String,
        /// The value as written in the file.
        value: String,
        /// Rule that the value must satisfy.
        rule: String,
    },
    /// Text that is not a quantity of the required dimension.
    Unit(UnitError),
    /// Text that is not a valid formula.
    Formula(ExpressionError),
    /// Numbers that do not describe a physical body.
    Body(BodyError),
    /// Triangles that do not bound a solid.
    Mesh {
        /// Name of the part of the file, if it has one.
        part: Option<String>,
        /// Violated condition.
        error: BodyError,
    },
    /// Numbers that do not describe a valid motion.
    Motion(MotionError),
    /// Numbers that do not describe a rotation.
    Rotation(RotationError),
    /// Numbers that break a rule of the subject: of a budget, a measurement, or a mesh.
    Subject {
        /// Rule in words, with the values.
        message: String,
        /// Advice for the user.
        hint: Option<String>,
    },
    /// Contents that do not follow the format.
    Content(ContentError),
}

/// A place in a text file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Character in the line, from 1.
    pub column: usize,
    /// Range of bytes in the file.
    pub span: Range<usize>,
    /// Text of the line with control characters made visible. A very long line is cut around the
    /// place.
    pub excerpt: String,
    /// Range of characters of the excerpt to mark.
    pub marked: Range<usize>,
}

impl FormatError {
    /// Creates an error in a file, at a place in its text if `place` is given.
    pub fn new(path: &Path, place: Option<Place>, kind: FormatErrorKind) -> Self {
        Self::at(path, place.map(Spot::Text), kind)
    }

    /// Creates an error in a file, at a place in its text or at a cell.
    pub fn at(path: &Path, place: Option<Spot>, kind: FormatErrorKind) -> Self {
        Self(Box::new(Report { path: path.to_owned(), place, kind, hint: None, named_in: None }))
    }

    /// Returns the error with its places in the text of `path` mapped by `spot`. The text was
    /// generated from a workbook, and the places become cells.
    pub fn moved(mut self, path: &Path, spot: impl Fn(&Place) -> Option<Spot>) -> Self {
        let moved = |place: Spot| match place {
            Spot::Text(place) => spot(&place),
            cell @ Spot::Cell(_) => Some(cell),
        };
        if self.0.path == path {
            self.0.place = self.0.place.and_then(moved);
        } else if let Some((named_in, place)) = self.0.named_in.take() {
            self.0.named_in = moved(place).map(|place| (named_in, place));
        }
        self
    }

    /// Creates an error from a content error; a place in text gets its line.
    pub fn of_content(path: &Path, bytes: &[u8], error: ContentError) -> Self {
        if is_utf16(bytes) {
            return Self::new(path, None, FormatErrorKind::Utf16);
        }
        let place = match &error.place {
            ContentPlace::Text(span) => Some(Place::in_bytes(bytes, span.clone())),
            _ => None,
        };
        Self::new(path, place, FormatErrorKind::Content(error))
    }

    /// Creates an error for text that is not valid UTF-8 after the first `valid` bytes.
    pub fn not_utf8(path: &Path, bytes: &[u8], valid: usize) -> Self {
        if is_utf16(bytes) {
            return Self::new(path, None, FormatErrorKind::Utf16);
        }
        let byte = bytes.get(valid).copied().unwrap_or_default();
        // The valid bytes before the place locate it.
        let place = Place::in_text(&String::from_utf8_lossy(bytes), valid..valid);
        Self::new(path, Some(place), FormatErrorKind::NotUtf8 { byte })
    }

    /// Returns the error with another kind at the same place.
    pub fn replaced(mut self, kind: FormatErrorKind) -> Self {
        (self.0.kind, self.0.hint) = (kind, None);
        self
    }

    /// Returns the error with this hint instead of the hint of its kind.
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.0.hint = Some(hint.into());
        self
    }

    /// Returns the error with this hint, if there is one.
    pub fn with_hint_of(self, hint: Option<impl Into<String>>) -> Self {
        match hint {
            Some(hint) => self.with_hint(hint),
            None => self,
        }
    }

    /// Returns the error with the hint "did you mean …?" if one of the names is close to the word.
    pub fn suggesting<'a>(self, word: &str, names: impl IntoIterator<Item = &'a str>) -> Self {
        self.with_hint_of(nearest(word, names).map(|near| format!("did you mean \"{near}\"?")))
    }

    /// Returns the error with the place in another file that names this file.
    pub fn named_in(self, path: &Path, place: Place) -> Self {
        self.named_at(path, Spot::Text(place))
    }

    /// Returns the error with the place or cell in another file that names this file.
    pub fn named_at(mut self, path: &Path, place: Spot) -> Self {
        self.0.named_in = Some((path.to_owned(), place));
        self
    }

    /// Returns the path of the file.
    pub fn path(&self) -> &Path {
        &self.0.path
    }

    /// Returns the place in the file; `None` if the error concerns the whole file or a binary file.
    pub fn place(&self) -> Option<&Place> {
        match &self.0.place {
            Some(Spot::Text(place)) => Some(place),
            _ => None,
        }
    }

    /// Returns the cell of a workbook in spreadsheet notation, such as `parts!F12`.
    pub fn cell(&self) -> Option<&str> {
        match &self.0.place {
            Some(Spot::Cell(cell)) => Some(cell),
            _ => None,
        }
    }

    /// Returns the kind of error.
    pub fn kind(&self) -> &FormatErrorKind {
        &self.0.kind
    }

    /// Returns the message, one sentence without the place.
    pub fn message(&self) -> String {
        self.0.kind.to_string()
    }

    /// Returns the advice for the user, if there is any.
    pub fn hint(&self) -> Option<String> {
        self.0.hint.clone().or_else(|| self.0.kind.hint())
    }

    /// Returns the file and place that name the file of this error, such as `file = "part.stl"` in
    /// a scenario.
    pub fn origin(&self) -> Option<(&Path, &Place)> {
        match &self.0.named_in {
            Some((path, Spot::Text(place))) => Some((path, place)),
            _ => None,
        }
    }

    /// Returns the workbook and cell that name the file of this error.
    pub fn origin_cell(&self) -> Option<(&Path, &str)> {
        match &self.0.named_in {
            Some((path, Spot::Cell(cell))) => Some((path, cell)),
            _ => None,
        }
    }
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = |f: &mut fmt::Formatter<'_>, path: &Path, place: Option<&Spot>| match place {
            Some(Spot::Text(place)) => write!(f, "{}:{}:{}", shown(path), place.line, place.column),
            Some(Spot::Cell(cell)) => write!(f, "{}: {}", shown(path), escaped(cell)),
            None => f.write_str(&shown(path)),
        };
        place(f, self.path(), self.0.place.as_ref())?;
        write!(f, ": {}", self.0.kind)?;
        if let Some((path, at)) = &self.0.named_in {
            f.write_str(" (named in ")?;
            place(f, path, Some(at))?;
            f.write_str(")")?;
        }
        Ok(())
    }
}

impl Error for FormatError {}

impl fmt::Display for FormatErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io { file, why, .. } => write!(f, "cannot read {file:?}: {why}"),
            Self::NotUtf8 { byte } => {
                write!(f, "the file is not valid UTF-8 text: invalid byte 0x{byte:02X}")
            }
            Self::Utf16 => f.write_str("the file is text in UTF-16; polhode reads UTF-8"),
            Self::Toml { message } => f.write_str(message),
            Self::UnknownKey { key, table, .. } => write!(f, "unknown key {:?} in {table}", cut(key)),
            Self::MissingKey { key, table, .. } => write!(f, "the key {key} is missing in {table}"),
            Self::Conflict { keys: [a, b], rule } => write!(f, "{a} and {b} are both given: {rule}"),
            Self::WrongType { key, expected, found } => write!(f, "{key} must be {expected}, not {found}"),
            Self::Value { key, value, rule } => write!(f, "{key} = {value} must be {rule}"),
            Self::Unit(e) => e.fmt(f),
            // The message has its own column.
            Self::Formula(e) => e.kind.fmt(f),
            Self::Body(e) | Self::Mesh { part: None, error: e } => e.fmt(f),
            Self::Mesh { part: Some(part), error } => write!(f, "part {part:?}: {error}"),
            Self::Motion(e) => e.fmt(f),
            Self::Rotation(e) => e.fmt(f),
            Self::Subject { message, .. } => f.write_str(message),
            Self::Content(e) if matches!(e.place, ContentPlace::Text(_)) => e.kind.fmt(f),
            Self::Content(e) => e.fmt(f),
        }
    }
}

impl From<ContentError> for FormatErrorKind {
    fn from(error: ContentError) -> Self {
        Self::Content(error)
    }
}

impl FormatErrorKind {
    /// Creates an error of a subject, with advice.
    pub fn subject(error: &impl fmt::Display, hint: Option<&str>) -> Self {
        Self::Subject { message: error.to_string(), hint: hint.map(str::to_owned) }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Io { kind: io::ErrorKind::NotFound, .. } => {
                Some("check the spelling; a relative path starts at the current folder".to_owned())
            }
            Self::Io { kind: io::ErrorKind::IsADirectory, .. } => Some("name a file in it".to_owned()),
            Self::Io { kind: io::ErrorKind::UnexpectedEof, .. } => {
                Some("wait until the program that writes it has finished".to_owned())
            }
            Self::Toml { .. } => {
                Some("a line is key = value, [table] or [[table]]; text is in quotes".to_owned())
            }
            Self::Io { .. } | Self::WrongType { .. } | Self::Value { .. } => None,
            Self::NotUtf8 { .. } => Some("save the file as UTF-8".to_owned()),
            Self::Utf16 => Some("save the file as UTF-8, or iconv -f UTF-16 -t UTF-8 FILE > NEW".to_owned()),
            Self::UnknownKey { suggestion, known, .. } => {
                let meant = suggestion.map_or(String::new(), |key| format!("did you mean {key}? "));
                Some(format!("{meant}the known keys are {}", known.join(", ")))
            }
            Self::MissingKey { example, .. } => Some(format!("write {example}")),
            Self::Conflict { .. } => Some("leave one of them out".to_owned()),
            Self::Unit(e) => e.hint(),
            Self::Formula(e) => e.hint(),
            Self::Mesh { error: BodyError::OpenMesh { .. } | BodyError::Unorientable { .. }, .. } => Some(
                "close the surface in the tool that made it (vertices that only nearly coincide count as different); or `polhode inertia` with --hull uses its convex hull, with --shell a sheet along it"
                    .to_owned(),
            ),
            Self::Mesh { error: BodyError::OverlappingMesh { .. }, .. } => Some(
                "unite the solids in the tool that made the mesh (boolean union); or `polhode inertia` with --hull uses the convex hull of the whole mesh"
                    .to_owned(),
            ),
            Self::Body(e) | Self::Mesh { error: e, .. } => {
                Some(e.hint().unwrap_or_else(|| body_hint(e)).to_owned())
            }
            Self::Motion(e) => e.hint().map(str::to_owned),
            Self::Rotation(e) => Some(rotation_hint(e).to_owned()),
            Self::Subject { hint, .. } => hint.clone(),
            Self::Content(e) => e.hint.clone(),
        }
    }
}

/// Returns advice to the author of a file about a body error for which `polhode` itself has none.
fn body_hint(error: &BodyError) -> &'static str {
    match error {
        BodyError::Parameter { what: "the torus's tube radius", .. } => {
            "ring_radius is the radius of the tube's centre line: a tube wider than its ring overlaps itself"
        }
        BodyError::Parameter { what: "the tetrahedron's volume", .. } => {
            "the four vertices are in one plane: move one of them out of it"
        }
        BodyError::Parameter {
            what: "the cylinder's inner radius" | "the sphere's inner radius", ..
        } => {
            "inner_radius is the radius of the cavity: the wall thickness is radius − inner_radius; for a thin wall use cylinder_shell or sphere_shell"
        }
        BodyError::Parameter {
            what: "the triangular plate's area" | "the triangular prism's area", ..
        } => "the three vertices are on one line: move one of them off it",
        BodyError::Parameter {
            what: "the larger radius of the cone" | "the larger radius of the conical shell",
            ..
        } => "a cone has at most one tip: make radius or top_radius positive",
        BodyError::Parameter { what: "the mesh's unit", .. } => "it is in metres: 0.001 for millimetres",
        BodyError::Parameter { value, .. } if !value.is_finite() => {
            "it is larger than the largest double, 1.8e308: check the units and the exponents"
        }
        BodyError::Parameter { value, .. } if value.abs() < f64::MIN_POSITIVE => {
            "it is smaller than the smallest double, 2.2e-308: check the units and the exponents"
        }
        BodyError::Empty { what: "particles" } => {
            "give at least one: particles = [{ mass = \"1 kg\", position = [0, 0, \"0.5 m\"] }]"
        }
        BodyError::FlatMesh { .. } => {
            "a solid has a thickness: export the solid body, not a sheet, and with enough digits for its unit"
        }
        BodyError::FlatPoints { .. } => "a hull needs four points that do not lie in one plane",
        BodyError::Vertex { .. } => "export the mesh again, in a unit in which its coordinates are finite",
        BodyError::Empty { .. } => "export the solid body, not the empty document",
        _ => "check its sign and its unit",
    }
}

fn rotation_hint(error: &RotationError) -> &'static str {
    match error {
        RotationError::Quaternion { .. } => {
            "the identity is quaternion = [1, 0, 0, 0]: the scalar comes first"
        }
        RotationError::Axis { .. } => "the z axis is [0, 0, 1]; its length does not matter",
        RotationError::Matrix { .. } => {
            "its columns are the rotated axes: length 1, perpendicular, right-handed, with eight digits or more"
        }
        _ => "an angle is finite",
    }
}

impl Place {
    /// Returns the place of the bytes `span` of a text that need not be valid UTF-8. Line ends are
    /// \n, \r\n or \r.
    pub fn in_bytes(bytes: &[u8], span: Range<usize>) -> Self {
        let start = span.start.min(bytes.len());
        let end = span.end.clamp(start, bytes.len());
        let is_break =
            |i: &usize| bytes[*i] == b'\n' || bytes[*i] == b'\r' && bytes.get(i + 1) != Some(&b'\n');
        let line = 1 + (0..start).filter(is_break).count();
        let line_start = (0..start).rev().find(is_break).map_or(0, |i| i + 1);
        let rest = &bytes[line_start..];
        let length = rest.iter().position(|b| b"\r\n".contains(b)).unwrap_or(rest.len());
        let (before, after) = rest[..length].split_at((start - line_start).min(length));
        let marked = (end - start).min(after.len());
        let before = String::from_utf8_lossy(before);
        let marked = String::from_utf8_lossy(&after[..marked]).len();
        let text = format!("{before}{}", String::from_utf8_lossy(after));
        let local = Self::in_text(&text, before.len()..before.len() + marked);
        Self { line, span: start..end, ..local }
    }

    /// Returns the place of the bytes `span` of a text.
    pub fn in_text(text: &str, span: Range<usize>) -> Self {
        /// Largest number of characters of a line that are printed.
        const SHOWN: usize = 160;
        let start = text.floor_char_boundary(span.start.min(text.len()));
        let end = text.floor_char_boundary(span.end.clamp(start, text.len()));
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        // The byte order mark does not count as a character of the first line.
        let first = if line_start == 0 && text.starts_with('\u{feff}') { 3.min(start) } else { line_start };
        let before = text[first..start].chars().count();
        let width = text[start..end.min(line_end).max(start)].trim_end().chars().count().max(1);
        let skipped = before.saturating_sub(SHOWN / 2);
        let excerpt: String = text[first..line_end]
            .trim_end_matches('\r')
            .chars()
            .skip(skipped)
            .take(SHOWN)
            .map(visible)
            .collect();
        let from = before - skipped;
        Self {
            line: 1 + text[..start].matches('\n').count(),
            column: 1 + before,
            span: start..end,
            excerpt,
            marked: from..(from + width).min(SHOWN.max(from + 1)),
        }
    }
}

/// Returns a path as messages print it.
fn shown(path: &Path) -> String {
    escaped(&path.to_string_lossy())
}
