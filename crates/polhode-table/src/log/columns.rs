//! Notation in which a user states the meaning of columns:
//! `time ms = t, quaternion xyzw = q0 q1 q2 q3, omega space deg/s = wx wy wz`.

use std::error::Error;
use std::fmt;
use std::str::FromStr;

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};
use polhode_source::nearest;
use polhode_source::text::{counted, cut};
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::euler::Sequence;
use super::name::spelt_unit;

/// Meaning of columns, as stated by a user. Names of columns are used for everything that is not
/// stated.
///
/// ```
/// use polhode_table::log::Columns;
/// assert!(Columns::parse("t = time, q xyzw = q0 q1 q2 q3, w body deg/s = gx gy gz").is_ok());
/// assert!(Columns::parse("euler 3-2-1 deg = psi theta phi, omega = none").is_ok());
/// let error = Columns::parse("quaternion wzyx = q0 q1 q2 q3").unwrap_err();
/// assert_eq!(error.to_string(), "unknown word \"wzyx\" for quaternion");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    pub(crate) time: Option<Said>,
    pub(crate) attitude: Option<Said>,
    /// Without columns, no angular velocity is read.
    pub(crate) omega: Option<Said>,
}

/// Statement about some columns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Said {
    pub key: Key,
    /// Names in the order of their meaning: that of the words, row by row, or that of the
    /// rotations.
    pub columns: Vec<String>,
    pub order: Option<QuaternionOrder>,
    pub sense: Option<AttitudeSense>,
    pub axes: Option<OmegaAxes>,
    pub sequence: Option<Sequence>,
    pub unit: Option<String>,
}

/// Possible meaning of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Key {
    Time,
    Quaternion,
    Matrix,
    Euler,
    Omega,
}

/// Error of a text in the notation for columns.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ColumnsError {
    /// A part has no `=`, or nothing after it.
    Form {
        /// Text of the part.
        part: String,
    },
    /// A quote is not closed.
    Quote,
    /// The word before the `=` is not a possible meaning of columns.
    Key {
        key: String,
        /// Most similar known word.
        suggestion: Option<&'static str>,
    },
    /// A word does not apply to columns with this meaning.
    Word {
        /// Meaning of the columns.
        key: &'static str,
        word: String,
        /// Words that apply.
        known: &'static str,
    },
    /// The number of columns is wrong.
    Count {
        /// Meaning of the columns.
        key: &'static str,
        /// Required number of columns.
        expected: usize,
        /// Number of columns that are named.
        found: usize,
    },
    /// Two parts are about the same quantity.
    Twice {
        /// Name of the quantity.
        what: &'static str,
    },
}

impl Key {
    const ALL: [Self; 5] = [Self::Time, Self::Quaternion, Self::Matrix, Self::Euler, Self::Omega];

    /// Returns the full and the short name.
    const fn names(self) -> [&'static str; 2] {
        match self {
            Self::Time => ["time", "t"],
            Self::Quaternion => ["quaternion", "q"],
            Self::Matrix => ["matrix", "R"],
            Self::Euler => ["euler", "e"],
            Self::Omega => ["omega", "w"],
        }
    }

    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Time => 1,
            Self::Quaternion => 4,
            Self::Matrix => 9,
            Self::Euler | Self::Omega => 3,
        }
    }

    pub(crate) const fn dimension(self) -> Dimension {
        match self {
            Self::Time => Dimension::TIME,
            Self::Quaternion | Self::Matrix => Dimension::NONE,
            Self::Euler => Dimension::ANGLE,
            Self::Omega => Dimension::ANGULAR_VELOCITY,
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Time => "a unit, such as ms",
            Self::Quaternion => "wxyz, xyzw, body-to-space and space-to-body",
            Self::Matrix => "body-to-space and space-to-body",
            Self::Euler => "a sequence such as 3-2-1, extrinsic, deg, rad, body-to-space and space-to-body",
            Self::Omega => "body, space and a unit, such as deg/s",
        }
    }
}

impl Columns {
    /// Parses the notation: parts separated by commas or semicolons, each of the form
    /// `KEY WORDS… = COLUMNS…`. [`super`] lists the keys and words.
    ///
    /// # Errors
    /// [`ColumnsError`] that names the invalid part.
    pub fn parse(text: &str) -> Result<Self, ColumnsError> {
        let mut columns = Self::default();
        for part in split(text, &[',', ';'])? {
            if part.trim().is_empty() {
                continue;
            }
            let said = Said::parse(part.trim())?;
            let (slot, what) = match said.key {
                Key::Time => (&mut columns.time, "the time"),
                Key::Omega => (&mut columns.omega, "the angular velocity"),
                _ => (&mut columns.attitude, "the attitude"),
            };
            if slot.replace(said).is_some() {
                return Err(ColumnsError::Twice { what });
            }
        }
        Ok(columns)
    }
}

impl Said {
    fn parse(part: &str) -> Result<Self, ColumnsError> {
        let form = || ColumnsError::Form { part: part.to_owned() };
        let (before, after) = part.split_once('=').ok_or_else(form)?;
        let mut words = before.split_whitespace();
        let key = words.next().ok_or_else(form)?;
        let known = Key::ALL.into_iter().find(|k| k.names().contains(&key));
        let key = known.ok_or_else(|| {
            let suggestion = nearest(key, Key::ALL.iter().map(|k| k.names()[0]));
            ColumnsError::Key { key: key.to_owned(), suggestion }
        })?;
        let mut said = Self {
            key,
            columns: Vec::new(),
            order: None,
            sense: None,
            axes: None,
            sequence: None,
            unit: None,
        };
        let mut extrinsic = false;
        for word in words {
            if key == Key::Euler && matches!(word, "intrinsic" | "extrinsic") {
                extrinsic = word == "extrinsic";
            } else if !said.word(word) {
                let (key, known) = (key.names()[0], key.words());
                return Err(ColumnsError::Word { key, word: word.to_owned(), known });
            }
        }
        said.sequence = said.sequence.map(|sequence| Sequence { extrinsic, ..sequence });
        let names =
            split(after.trim(), &[' ', '\t'])?.into_iter().map(|name| unquoted(name.trim()).to_owned());
        said.columns = names.filter(|name| !name.is_empty()).collect();
        match said.columns.as_slice() {
            [] => return Err(form()),
            [none] if key == Key::Omega && none == "none" => said.columns.clear(),
            // A single name may stand for several columns: an array of JSON, or a range.
            [_] if key != Key::Time => {}
            all if all.len() == key.count() => {}
            all => {
                let (expected, found) = (key.count(), all.len());
                return Err(ColumnsError::Count { key: key.names()[0], expected, found });
            }
        }
        Ok(said)
    }

    /// Applies a word to the columns. Returns false if it does not apply to them.
    fn word(&mut self, word: &str) -> bool {
        let is_attitude = matches!(self.key, Key::Quaternion | Key::Matrix | Key::Euler);
        match (self.key, word) {
            (Key::Quaternion, "wxyz") => self.order = Some(QuaternionOrder::ScalarFirst),
            (Key::Quaternion, "xyzw") => self.order = Some(QuaternionOrder::ScalarLast),
            (Key::Omega, "body") => self.axes = Some(OmegaAxes::Body),
            (Key::Omega, "space") => self.axes = Some(OmegaAxes::Space),
            (_, "body-to-space") if is_attitude => self.sense = Some(AttitudeSense::BodyToSpace),
            (_, "space-to-body") if is_attitude => self.sense = Some(AttitudeSense::SpaceToBody),
            (Key::Quaternion | Key::Matrix, _) => return false,
            _ => {
                let sequence = Sequence::parse(word).filter(|_| self.key == Key::Euler);
                let unit = spelt_unit(word);
                match (sequence, unit::factor(&unit, self.key.dimension())) {
                    (Some(sequence), _) => self.sequence = Some(sequence),
                    (None, Ok(_)) => self.unit = Some(unit),
                    (None, Err(_)) => return false,
                }
            }
        }
        true
    }
}

/// Splits a text at separators that are not in quotes.
fn split<'a>(text: &'a str, separators: &[char]) -> Result<Vec<&'a str>, ColumnsError> {
    let (mut parts, mut start, mut quote) = (Vec::new(), 0, None);
    for (at, c) in text.char_indices() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => quote = Some(c),
            None if separators.contains(&c) => {
                parts.push(&text[start..at]);
                start = at + c.len_utf8();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    if quote.is_some() { Err(ColumnsError::Quote) } else { Ok(parts) }
}

/// Returns a text without the quotes around it.
pub(crate) fn unquoted(text: &str) -> &str {
    let within = |quote: char| text.strip_prefix(quote)?.strip_suffix(quote);
    within('"').or_else(|| within('\'')).unwrap_or(text)
}

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::parse(text).map_err(|error| format!("{error} (hint: {})", error.hint()))
    }
}

impl fmt::Display for ColumnsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form { part } => write!(f, "{:?} does not have the form QUANTITY = NAMES", cut(part)),
            Self::Quote => f.write_str("a quote is not closed"),
            Self::Key { key, .. } => write!(f, "unknown quantity {:?}", cut(key)),
            Self::Word { key, word, .. } => write!(f, "unknown word {:?} for {key}", cut(word)),
            Self::Count { key, expected, found } => {
                write!(f, "{key} has {}, not {found}", counted(*expected, "column"))
            }
            Self::Twice { what } => write!(f, "{what} is named twice"),
        }
    }
}

impl ColumnsError {
    /// Returns advice on the correct notation.
    pub fn hint(&self) -> String {
        match self {
            Self::Form { .. } => {
                "write the quantity, = and the names of its columns: quaternion xyzw = q0 q1 q2 q3".to_owned()
            }
            Self::Quote => "put a name with spaces or commas in quotes: t = \"time, s\"".to_owned(),
            Self::Key { suggestion, .. } => {
                let meant = suggestion.map_or(String::new(), |key| format!("did you mean {key}? "));
                format!(
                    "{meant}the quantities are time, quaternion, matrix, euler and omega, in short t, q, R, e and w"
                )
            }
            Self::Word { known, .. } => format!("choose from {known}"),
            Self::Count { key: "time", .. } => "name one column".to_owned(),
            Self::Count { .. } => {
                "separate the names by spaces, or write a range of neighbours: q0..q3".to_owned()
            }
            Self::Twice { .. } => "name it once".to_owned(),
        }
    }
}

impl Error for ColumnsError {}
