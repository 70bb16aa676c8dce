//! Results of requests.

use serde_json::Value;

use crate::Document;
use crate::layout::WIDTH;

/// Result of a request, as JSON and as a document.
pub trait Report {
    /// Returns the complete result as JSON. `polhode schema NAME` describes it.
    fn to_json(&self) -> Value;

    /// Returns the document for text, Markdown and HTML.
    fn to_document(&self) -> Document;

    /// Returns plain text for a terminal of `columns` columns; `None` is a pipe or a file.
    fn to_text(&self, columns: Option<usize>) -> String {
        self.to_document().to_text(columns.unwrap_or(WIDTH))
    }

    /// Returns true if a finding makes the command exit with status 1.
    fn has_failed(&self) -> bool {
        false
    }
}
