//! A lesson's file as written.

use std::path::Path;

use serde::Deserialize;
use toml::Spanned;

use super::error::LessonError;

/// A lesson as written. `book/lessons.md` describes the keys.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub(super) title: Spanned<String>,
    pub(super) summary: Spanned<String>,
    /// Name of a scenario file in the same folder.
    pub(super) scenario: Option<Spanned<String>>,
    /// Text of the scenario, instead of a file.
    pub(super) scenario_text: Option<Spanned<String>>,
    #[serde(default, rename = "step")]
    pub(super) steps: Vec<Spanned<Step>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Step {
    pub(super) text: Spanned<String>,
    pub(super) question: Option<Question>,
    #[serde(default)]
    pub(super) knobs: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) set: Vec<Spanned<Set>>,
    pub(super) working: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Question {
    pub(super) text: Spanned<String>,
    pub(super) answers: Spanned<Vec<Spanned<String>>>,
    /// Number of the right answer, from 1.
    pub(super) right: Spanned<usize>,
    pub(super) why: Spanned<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Set {
    pub(super) key: String,
    pub(super) value: Spanned<toml::Value>,
}

impl File {
    pub(super) fn read(path: &Path, text: &str) -> Result<Self, LessonError> {
        toml::from_str(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            LessonError::at(path, text, &span, error.message().replace('\n', " "))
                .hint("book/lessons.md lists the keys of a lesson and has an example")
        })
    }
}
