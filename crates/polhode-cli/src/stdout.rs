//! Standard output: data, and nothing else.

use std::io::{self, IsTerminal as _, Write as _};

use clap::builder::StyledStr;
use polhode_document::layout::printable_lines;

use crate::failure::Failure;

/// Writes text, JSON or a table to standard output. No name in it can steer the terminal, wherever it comes from.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_script(printable_lines(text).as_bytes())
}

/// Writes text that a program takes byte by byte; to a terminal as [`print`] does.
pub(crate) fn print_exact(text: &str) -> Result<(), Failure> {
    if io::stdout().is_terminal() { print(text) } else { print_script(text.as_bytes()) }
}

/// Writes piece by piece what has no names that could steer a terminal.
pub(crate) fn write(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    finished(write(&mut out).and_then(|()| out.flush()))
}

/// Writes what is made of our own words alone.
pub(crate) fn print_script(data: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    finished(out.write_all(data).and_then(|()| out.flush()))
}

fn finished(written: io::Result<()>) -> Result<(), Failure> {
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::Output { path: "standard output".to_owned(), error },
    })
}

/// Writes what clap says, with its colours where a terminal reads it and nobody has asked for none.
pub(crate) fn print_styled(text: &StyledStr) -> Result<(), Failure> {
    let plain =
        !io::stdout().is_terminal() || std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let text = if plain { text.to_string() } else { text.ansi().to_string() };
    print_script(text.as_bytes())
}

/// The columns of the terminal that reads standard output; `None` where it is a pipe or a file.
pub(crate) fn columns() -> Option<usize> {
    /// Those of a terminal that does not say.
    const USUAL: usize = 80;
    let told = || terminal_size::terminal_size().map_or(USUAL, |(width, _)| usize::from(width.0));
    io::stdout().is_terminal().then(told)
}
