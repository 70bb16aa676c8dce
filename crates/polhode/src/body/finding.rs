//! Findings: remarks about the input or the result of a computation.

/// Remark about an input or a result, for people (`message`) and for programs (`code`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Stable name with dots, for example `mesh.inverted`.
    pub code: &'static str,
    /// Severity of the finding.
    pub severity: Severity,
    /// Message of one sentence.
    pub message: String,
    /// Part, file or triangle that the finding refers to.
    pub place: Option<String>,
}

/// Severity of a [`Finding`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Error: the result should not be used.
    Error,
    /// Warning: the result may differ from what the user intended.
    Warning,
    /// Information: a choice that the program made.
    Info,
}

impl Severity {
    /// Returns `error`, `warning` or `info`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Info => "info",
        }
    }
}
