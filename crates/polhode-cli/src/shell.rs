//! What shells and `man` want: both made from the same definitions as `--help`.

use clap::{Args, Command};

use crate::failure::Failure;
use crate::stdout::print_script;

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
    pub(crate) fn run(self, mut definitions: Command) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut definitions, "polhode", &mut script);
        print_script(&script)
    }
}

impl Man {
    pub(crate) fn run(self, definitions: Command) -> Result<(), Failure> {
        let mut page = Vec::new();
        let rendered = clap_mangen::Man::new(definitions).render(&mut page);
        rendered.map_err(|error| Failure::Output { path: "the man page".to_owned(), error })?;
        print_script(&page)
    }
}
