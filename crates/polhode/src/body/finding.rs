//! What an answer says about its input.

/// A remark about an input or a result, for people (`message`) and for programs (`code`).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// A stable name, dotted: `mesh.inverted`.
    pub code: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// One sentence.
    pub message: String,
    /// Which part, file or triangle it is about.
    pub place: Option<String>,
}

/// How much a [`Finding`] matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The result should not be used.
    Error,
    /// The result may not be what was meant.
    Warning,
    /// Something that was decided on the way.
    Info,
}

impl Severity {
    /// `error`, `warning` or `info`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Info => "info",
        }
    }
}
