//! Standard error: what people read of what went wrong, and how it goes.

use std::io::{self, Write as _};

use polhode_document::layout::printable_lines;

/// Writes lines for people to standard error: no name in it can steer the terminal. Where it is closed there is nobody left to tell.
pub(crate) fn tell(text: &str) {
    let _ = io::stderr().write_all(printable_lines(text).as_bytes());
}
