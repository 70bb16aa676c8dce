//! Standard output, used for data only.

use std::io::{self, IsTerminal as _, Write as _};

use clap::builder::StyledStr;
use polhode_document::layout::printable_lines;

use crate::failure::Failure;

/// Writes text, JSON or a table to standard output with control characters escaped.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_script(printable_lines(text).as_bytes())
}

/// Writes text unchanged for a program; to a terminal as [`print`] does.
pub(crate) fn print_exact(text: &str) -> Result<(), Failure> {
    if io::stdout().is_terminal() { print(text) } else { print_script(text.as_bytes()) }
}

/// Writes data in pieces; the data must not contain control characters.
pub(crate) fn write(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    finished(write(&mut out).and_then(|()| out.flush()))
}

/// Writes data without escaping; they must not contain text from files.
pub(crate) fn print_script(data: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    finished(out.write_all(data).and_then(|()| out.flush()))
}

/// Returns the failure of writing to standard output; a closed pipe is not an error.
pub(crate) fn finished(written: io::Result<()>) -> Result<(), Failure> {
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::Output { path: "standard output".to_owned(), error },
    })
}

/// Writes a message of clap. Colours are used only on a terminal, and not if `NO_COLOR` is set.
pub(crate) fn print_styled(text: &StyledStr) -> Result<(), Failure> {
    let plain =
        !io::stdout().is_terminal() || std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let text = if plain { text.to_string() } else { text.ansi().to_string() };
    print_script(text.as_bytes())
}

/// Returns the width of the terminal on standard output, columns; `None` for a pipe or a file.
pub(crate) fn columns() -> Option<usize> {
    /// Width of a terminal that does not report it.
    const USUAL: usize = 80;
    let told = || terminal_size::terminal_size().map_or(USUAL, |(width, _)| usize::from(width.0));
    io::stdout().is_terminal().then(told)
}
