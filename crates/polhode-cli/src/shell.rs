//! Completion scripts and the man page, generated from the definitions of `--help`.

use clap::{Args, Command};
use polhode_document::VERSION;

use crate::failure::Failure;
use crate::stdout::print_script;

/// Print a completion script for a shell.
///
/// Example for bash: `polhode completions bash > ~/.local/share/bash-completion/completions/polhode`
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell.
    shell: clap_complete::Shell,
}

/// Print the man page of polhode or of a subcommand.
///
/// Example: `polhode man spin | man -l -`
#[derive(Debug, Args)]
pub(crate) struct Man {
    /// The subcommand.
    subcommand: Option<String>,
}

impl Completions {
    pub(crate) fn run(self, mut definitions: Command) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut definitions, "polhode", &mut script);
        print_script(&script)
    }
}

impl Man {
    pub(crate) fn run(self, definitions: Command) -> Result<(), Failure> {
        // The subcommand `help` needs no page.
        let mut definitions = definitions.disable_help_subcommand(true);
        definitions.build();
        let of = match &self.subcommand {
            None => &definitions,
            Some(name) => definitions.find_subcommand(name).ok_or_else(|| {
                Failure::usage(
                    format!("unknown subcommand {name:?}"),
                    "`polhode --help` lists the subcommands",
                )
            })?,
        };
        let mut page = Vec::new();
        let rendered =
            clap_mangen::Man::new(of.clone()).source(format!("polhode {VERSION}")).render(&mut page);
        rendered.map_err(|error| Failure::Output { path: "the man page".to_owned(), error })?;
        print_script(&page)
    }
}
