//! Results of requests.

use serde_json::Value;

use crate::Document;
use crate::layout::WIDTH;

/// Result of a request, for people and for programs.
pub trait Report {
    /// Returns all that was found, as data. `polhode schema NAME` describes it.
    fn to_json(&self) -> Value;

    /// Returns what a person reads, for text, Markdown and HTML.
    fn to_document(&self) -> Document;

    /// Returns plain text for a terminal of so many columns; `None` is a pipe or a file.
    fn to_text(&self, columns: Option<usize>) -> String {
        self.to_document().to_text(columns.unwrap_or(WIDTH))
    }

    /// Returns true if something was found that the command's exit status 1 says.
    fn has_failed(&self) -> bool {
        false
    }
}
