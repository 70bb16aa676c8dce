//! Refusals of requests.

use serde::Serialize;

/// Refusal of a request: its kind, the reason, and advice for a fix.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// Kind, for programs.
    pub kind: RefusalKind,
    /// Reason, and the rule.
    pub message: String,
    /// Advice for a fix, if there is any.
    pub hint: Option<String>,
}

/// Kind of refusal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum RefusalKind {
    /// The request is invalid, or does not suit its document.
    BadRequest,
    /// The document or lesson does not exist.
    NotFound,
    /// A file cannot be read, or a lesson is invalid.
    Unprocessable,
    /// The session has as many documents as it may have.
    Full,
    /// The computation was cancelled.
    Ended,
    /// The answer cannot be written as JSON.
    Internal,
}

impl Refusal {
    pub(crate) fn new(kind: RefusalKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into(), hint: None }
    }

    pub(crate) fn hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }
}
