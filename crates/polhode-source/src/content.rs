//! Errors in the contents of a file that does not follow its format.

use std::error::Error;
use std::fmt;
use std::ops::Range;

use polhode::body::BodyError;

use crate::text::cut;

/// Error in the contents of a file: what is wrong, the place, and advice.
#[derive(Clone, Debug, PartialEq)]
pub struct ContentError {
    /// Error kind, with its details.
    pub kind: ContentErrorKind,
    /// Place in the file.
    pub place: ContentPlace,
    /// Advice for the user; `None` if there is none.
    pub hint: Option<String>,
}

/// Kind of error in the contents of a file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContentErrorKind {
    /// The grammar requires something else here.
    Expected {
        /// Expected content: `"a number"`.
        what: String,
        /// Text found instead; empty at the end of the file.
        found: String,
    },
    /// A number that is infinite or NaN.
    NotFinite {
        /// Description of the number: `"the coordinate"`.
        what: String,
        /// The number as written in the file.
        found: String,
    },
    /// An index out of range.
    Index {
        /// Kind of the indexed elements: `"vertex"`.
        what: String,
        /// The index, in the file's own numbering.
        index: i64,
        /// Number of elements read so far.
        count: usize,
    },
    /// A count or length that disagrees with the number of elements in the file.
    Count {
        /// Kind of the counted elements: `"vertices"`, `"bytes"`.
        what: String,
        /// Count declared in the file.
        declared: u64,
        /// Count found in the file.
        present: u64,
    },
    /// A value that breaks a rule.
    Value {
        /// Description of the value: `"the element"`.
        what: String,
        /// The value as written in the file.
        value: String,
        /// Rule that the value must satisfy.
        rule: String,
    },
    /// A required part that is missing.
    Missing {
        /// Name of the missing part: `"vertices"`.
        what: String,
    },
    /// A feature of the format that polhode does not support.
    Unsupported {
        /// Name of the feature.
        what: String,
    },
    /// An ambiguous statement; the hint says how to resolve it.
    Unclear {
        /// The open question.
        question: String,
        /// Text in the file; may be empty.
        found: String,
    },
    /// Numbers that do not describe a physical body.
    Body(Box<BodyError>),
    /// Products of inertia of unknown sign: both residuals are small, or both are large.
    ProductSign {
        /// Test that was applied: `"parallel axes"`.
        by: &'static str,
        /// Residual for the sign convention −∫xy dm, in units of the printed rounding.
        negative: f64,
        /// Residual for the sign convention +∫xy dm, in units of the printed rounding.
        positive: f64,
    },
}

/// Place in the contents of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ContentPlace {
    /// The whole file.
    Whole,
    /// Range of bytes of a text file; printed as line and column.
    Text(Range<usize>),
    /// Byte of a binary file.
    Byte {
        /// Offset from the start of the file, bytes.
        offset: u64,
        /// Description of the content at that byte: `"vertex 12"`; may be empty.
        what: String,
    },
    /// Part of the file without an offset of its own: `"nodes[3].matrix"`,
    /// `"3D/3dmodel.model, line 12"`.
    Within(String),
}

impl ContentError {
    /// Creates an error without a hint.
    pub fn new(kind: ContentErrorKind, place: ContentPlace) -> Self {
        Self { kind, place, hint: None }
    }

    /// Creates an error about the file as a whole.
    pub fn of_file(kind: ContentErrorKind) -> Self {
        Self::new(kind, ContentPlace::Whole)
    }

    /// Creates an error about a missing part.
    pub fn missing(what: impl Into<String>) -> Self {
        Self::of_file(ContentErrorKind::Missing { what: what.into() })
    }

    /// Creates an error about an unsupported feature.
    pub fn unsupported(what: impl Into<String>) -> Self {
        Self::of_file(ContentErrorKind::Unsupported { what: what.into() })
    }

    /// Returns the error with this hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}

impl ContentErrorKind {
    /// Creates an error for `found` in place of `what`; `found` is empty at the end of the file.
    pub fn expected(what: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected { what: what.into(), found: found.into() }
    }

    /// Creates an error for a number, as written, that is infinite or NaN.
    pub fn not_finite(what: impl Into<String>, found: impl Into<String>) -> Self {
        Self::NotFinite { what: what.into(), found: found.into() }
    }

    /// Creates an error for an index out of range, with `count` elements present.
    pub fn index(what: impl Into<String>, index: i64, count: usize) -> Self {
        Self::Index { what: what.into(), index, count }
    }

    /// Creates an error for a declared count that differs from the count in the file.
    pub fn count(what: impl Into<String>, declared: u64, present: u64) -> Self {
        Self::Count { what: what.into(), declared, present }
    }

    /// Creates an error for a value that breaks a rule.
    pub fn value(what: impl Into<String>, value: impl Into<String>, rule: impl Into<String>) -> Self {
        Self::Value { what: what.into(), value: value.into(), rule: rule.into() }
    }

    /// Creates an error for a missing part.
    pub fn missing(what: impl Into<String>) -> Self {
        Self::Missing { what: what.into() }
    }

    /// Creates an error for an unsupported feature.
    pub fn unsupported(what: impl Into<String>) -> Self {
        Self::Unsupported { what: what.into() }
    }

    /// Creates an error for an ambiguous statement.
    pub fn unclear(question: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Unclear { question: question.into(), found: found.into() }
    }

    /// Returns the error with a range of bytes of a text as its place.
    pub fn at(self, span: Range<usize>) -> ContentError {
        ContentError::new(self, ContentPlace::Text(span))
    }

    /// Returns the error with the whole file as its place.
    pub fn of_whole(self) -> ContentError {
        ContentError::new(self, ContentPlace::Whole)
    }
}

/// Checks that a unit stated by the caller, if any, is positive and finite.
pub fn told_unit(what: &str, unit: Option<f64>) -> Result<(), ContentError> {
    match unit {
        Some(unit) if !(unit > 0.0 && unit.is_finite()) => {
            let (what, rule) = (what.to_owned(), "positive and finite".to_owned());
            let kind = ContentErrorKind::Value { what, value: unit.to_string(), rule };
            Err(ContentError::new(kind, ContentPlace::Whole))
        }
        _ => Ok(()),
    }
}

impl fmt::Display for ContentErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Expected { what, found } if found.is_empty() => {
                write!(f, "expected {what}, found the end of the file")
            }
            Self::Expected { what, found } => write!(f, "expected {what}, found {:?}", cut(found)),
            Self::NotFinite { what, found } => write!(f, "{what} {} is not finite", cut(found)),
            // The parser clamps larger indices to these limits.
            Self::Index { what, index: i64::MAX | -9_223_372_036_854_775_807, count } => {
                write!(f, "there is no {what} with a number of 18 digits or more: the file has {count}")
            }
            Self::Index { what, index, count } => {
                write!(f, "{what} {index} does not exist: there are {count}")
            }
            Self::Count { what, declared, present } => {
                write!(f, "{declared} {what} are declared, but the file has {present}")
            }
            Self::Value { what, value, rule } => write!(f, "{what} = {} must be {rule}", cut(value)),
            Self::Missing { what } => write!(f, "the file has no {what}"),
            Self::Unsupported { what } => write!(f, "polhode does not read {what}"),
            Self::Unclear { question, found } if found.is_empty() => {
                write!(f, "{question} The file does not say")
            }
            Self::Unclear { question, found } => {
                write!(f, "{question} The file has only {}", cut(found))
            }
            Self::Body(error) => error.fmt(f),
            Self::ProductSign { by, negative, positive } => write!(
                f,
                "the sign convention of the products of inertia is unclear, −∫xy dm or +∫xy dm: according to {by}, the report deviates by {negative:.2e} times its rounding with the first and by {positive:.2e} times with the second"
            ),
        }
    }
}

impl fmt::Display for ContentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            ContentPlace::Whole => {}
            ContentPlace::Text(span) => write!(f, "byte {}: ", span.start)?,
            ContentPlace::Byte { offset, what } if what.is_empty() => write!(f, "byte {offset}: ")?,
            ContentPlace::Byte { offset, what } => write!(f, "{what}, byte {offset}: ")?,
            ContentPlace::Within(what) => write!(f, "{what}: ")?,
        }
        self.kind.fmt(f)
    }
}

impl Error for ContentError {}
