//! Standard error: messages and progress for the user.

use std::io::{self, Write as _};

use polhode_document::layout::printable_lines;

/// Writes lines to standard error with control characters escaped. A closed standard error is
/// ignored.
pub(crate) fn tell(text: &str) {
    let _ = io::stderr().write_all(printable_lines(text).as_bytes());
}
