//! Results of requests.

use serde_json::Value;

use crate::Document;

/// Result of a request, for people and for programs.
pub trait Report {
    /// Returns all that was found, as data. `polhode schema NAME` describes it.
    fn to_json(&self) -> Value;

    /// Returns what a person reads, for text, Markdown and HTML.
    fn to_document(&self) -> Document;

    /// Returns true if something was found that the command's exit status 1 says.
    fn has_failed(&self) -> bool {
        false
    }
}
