//! Why the contents of a file are not what its format asks for.

use std::error::Error;
use std::fmt;
use std::ops::Range;

use polhode::body::BodyError;

use crate::text::cut;

/// Why the contents of a file are not what its format asks for: what is wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq)]
pub struct ContentError {
    /// What is wrong.
    pub kind: ContentErrorKind,
    /// Where.
    pub place: ContentPlace,
    /// What to do about it, where there is something to say.
    pub hint: Option<String>,
}

/// What is wrong with the contents of a file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContentErrorKind {
    /// Something else stands where the grammar has its place.
    Expected {
        /// What belongs there: `"a number"`.
        what: String,
        /// What stands there; empty at the end of the file.
        found: String,
    },
    /// A number that is infinite or not a number.
    NotFinite {
        /// What it is: `"the coordinate"`.
        what: String,
        /// The number as it is written.
        found: String,
    },
    /// An index of something that is not there.
    Index {
        /// What it counts: `"vertex"`.
        what: String,
        /// The index, as the file counts.
        index: i64,
        /// How many there are so far.
        count: usize,
    },
    /// A count, or a length, that the file does not fill or runs over.
    Count {
        /// What is counted: `"vertices"`, `"bytes"`.
        what: String,
        /// How many the file declares.
        declared: u64,
        /// How many are there.
        present: u64,
    },
    /// A value that breaks a rule.
    Value {
        /// What it is: `"the element"`.
        what: String,
        /// The value, as it is written.
        value: String,
        /// What it has to be.
        rule: String,
    },
    /// Something that the format needs and the file lacks.
    Missing {
        /// What: `"vertices"`.
        what: String,
    },
    /// Something that the format has and polhode does not read.
    Unsupported {
        /// What.
        what: String,
    },
    /// Something that can be read in more than one way; the hint says how to answer.
    Unclear {
        /// What the reader would have to guess, as a question.
        question: String,
        /// What the file says; may be empty.
        found: String,
    },
    /// Numbers that are not a body.
    Body(Box<BodyError>),
    /// Products of inertia whose sign cannot be proved: both residuals are small, or both are large.
    ProductSign {
        /// By what it was tried: `"parallel axes"`.
        by: &'static str,
        /// By how many times the printed rounding the report is off if they are −∫xy dm.
        negative: f64,
        /// By how many times the printed rounding it is off if they are +∫xy dm.
        positive: f64,
    },
}

/// Where in the contents of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ContentPlace {
    /// The file as a whole.
    Whole,
    /// Bytes of a text file; printed as line and column.
    Text(Range<usize>),
    /// A byte of a binary file.
    Byte {
        /// Which, from 0.
        offset: u64,
        /// What stands there: `"vertex 12"`; may be empty.
        what: String,
    },
    /// A part of the file that has no offset of its own: `"nodes[3].matrix"`, `"3D/3dmodel.model, line 12"`.
    Within(String),
}

impl ContentError {
    /// An error without a hint.
    pub fn new(kind: ContentErrorKind, place: ContentPlace) -> Self {
        Self { kind, place, hint: None }
    }

    /// Error about the file as a whole.
    pub fn of_file(kind: ContentErrorKind) -> Self {
        Self::new(kind, ContentPlace::Whole)
    }

    /// Error of something that the file lacks.
    pub fn missing(what: impl Into<String>) -> Self {
        Self::of_file(ContentErrorKind::Missing { what: what.into() })
    }

    /// Error of something that is not read.
    pub fn unsupported(what: impl Into<String>) -> Self {
        Self::of_file(ContentErrorKind::Unsupported { what: what.into() })
    }

    /// The same with a hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}

impl ContentErrorKind {
    /// Something else, `found`, stands where `what` belongs; empty at the end of the file.
    pub fn expected(what: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected { what: what.into(), found: found.into() }
    }

    /// A number, as it is written, that is infinite or not a number.
    pub fn not_finite(what: impl Into<String>, found: impl Into<String>) -> Self {
        Self::NotFinite { what: what.into(), found: found.into() }
    }

    /// An index of something of which there are `count`.
    pub fn index(what: impl Into<String>, index: i64, count: usize) -> Self {
        Self::Index { what: what.into(), index, count }
    }

    /// A count that the file does not fill or runs over.
    pub fn count(what: impl Into<String>, declared: u64, present: u64) -> Self {
        Self::Count { what: what.into(), declared, present }
    }

    /// A value that breaks a rule.
    pub fn value(what: impl Into<String>, value: impl Into<String>, rule: impl Into<String>) -> Self {
        Self::Value { what: what.into(), value: value.into(), rule: rule.into() }
    }

    /// Something that the file lacks.
    pub fn missing(what: impl Into<String>) -> Self {
        Self::Missing { what: what.into() }
    }

    /// Something that polhode does not read.
    pub fn unsupported(what: impl Into<String>) -> Self {
        Self::Unsupported { what: what.into() }
    }

    /// A question that the file leaves open.
    pub fn unclear(question: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Unclear { question: question.into(), found: found.into() }
    }

    /// Returns the error at bytes of a text.
    pub fn at(self, span: Range<usize>) -> ContentError {
        ContentError::new(self, ContentPlace::Text(span))
    }

    /// Returns the error of the file as a whole.
    pub fn of_whole(self) -> ContentError {
        ContentError::new(self, ContentPlace::Whole)
    }
}

/// Refuses a told unit, if there is one, that is not positive and finite.
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
            // As large as indices are read: the file's is larger.
            Self::Index { what, index: i64::MAX | -9_223_372_036_854_775_807, count } => {
                write!(f, "a {what} of 18 digits or more does not exist: there are {count}")
            }
            Self::Index { what, index, count } => {
                write!(f, "{what} {index} does not exist: there are {count}")
            }
            Self::Count { what, declared, present } => {
                write!(f, "{declared} {what} are declared, and {present} are there")
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
                "are the products of inertia −∫xy dm or +∫xy dm? By {by} the report is off by {negative:.2e} \
                 times its rounding with the one and {positive:.2e} times with the other, which proves neither"
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
