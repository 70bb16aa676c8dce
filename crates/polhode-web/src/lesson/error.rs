//! Errors of lessons, with their place in the file.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Error of a lesson: the file, the place, a description, and advice for a fix.
///
/// Prints as `path:line:column: message`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonError {
    /// Lesson, or a file to which it refers.
    pub path: PathBuf,
    /// Line and character, from 1; `None` for the whole file.
    pub place: Option<[usize; 2]>,
    /// Description of the error, and the rule.
    pub message: String,
    /// Advice for a fix, if there is any.
    pub hint: Option<String>,
}

impl LessonError {
    /// Makes an error of the whole file.
    pub(super) fn whole(path: &Path, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), place: None, message: message.into(), hint: None }
    }

    /// Makes an error at a byte range of the text.
    pub(super) fn at(path: &Path, text: &str, span: &Range<usize>, message: impl Into<String>) -> Self {
        let before = &text[..text.floor_char_boundary(span.start.min(text.len()))];
        let line = 1 + before.matches('\n').count();
        let column = 1 + before.rsplit('\n').next().unwrap_or_default().chars().count();
        Self { place: Some([line, column]), ..Self::whole(path, message) }
    }

    pub(super) fn hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }
}

impl fmt::Display for LessonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some([line, column]) = self.place {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}", self.message)
    }
}

impl std::error::Error for LessonError {}
