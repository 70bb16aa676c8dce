//! Findings about a file as a whole.

use polhode::body::{Finding, Severity};

/// Creates a finding of severity [`Severity::Info`].
pub(crate) fn info(code: &'static str, message: impl Into<String>) -> Finding {
    Finding { code, severity: Severity::Info, message: message.into(), place: None }
}

/// Creates a finding of severity [`Severity::Warning`].
pub(crate) fn warning(code: &'static str, message: impl Into<String>) -> Finding {
    Finding { code, severity: Severity::Warning, message: message.into(), place: None }
}
