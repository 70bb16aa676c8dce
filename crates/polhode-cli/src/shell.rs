//! What shells and `man` want: both made from the same definitions as `--help`.

use std::io::{self, Write as _};

use clap::{Args, CommandFactory as _};

use crate::args::Polhode;
use crate::failure::Failure;

/// Print a completion script for a shell.
///
/// For bash: `polhode completions bash > ~/.local/share/bash-completion/completions/polhode`
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell.
    shell: clap_complete::Shell,
}

/// Print the man page.
///
/// To read it: `polhode man | man -l -`
#[derive(Debug, Args)]
pub(crate) struct Man;

impl Completions {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Polhode::command(), "polhode", &mut script);
        print(&script)
    }
}

impl Man {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut page = Vec::new();
        let rendered = clap_mangen::Man::new(Polhode::command()).render(&mut page);
        rendered.map_err(|error| Failure::Output { path: "the man page".to_owned(), error })?;
        print(&page)
    }
}

/// Writes data to standard output.
pub(crate) fn print(data: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(data).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::Output { path: "standard output".to_owned(), error },
    })
}
