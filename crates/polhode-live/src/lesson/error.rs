//! Why a lesson cannot be used, and where in its file.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Why a lesson cannot be used: the file, the place, what is wrong, and what to do about it.
///
/// Prints as `path:line:column: message`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonError {
    /// The lesson, or a file that it names.
    pub path: PathBuf,
    /// Line and character, from 1; `None` of the file as a whole.
    pub place: Option<[usize; 2]>,
    /// What is wrong, and the rule.
    pub message: String,
    /// What to do about it, where there is something to say.
    pub hint: Option<String>,
}

impl LessonError {
    /// An error of the file as a whole.
    pub(super) fn whole(path: &Path, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), place: None, message: message.into(), hint: None }
    }

    /// An error at some bytes of its text.
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
