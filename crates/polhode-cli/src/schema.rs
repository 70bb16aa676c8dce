//! `polhode schema`

use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::stdout::print_script;

/// Print the JSON schema of input files, for editors.
///
/// With the schema in a file, an editor completes keys and marks wrong ones: `polhode schema scenario > scenario.schema.json`
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode schema scenario > scenario.schema.json")]
pub(crate) struct Schema {
    /// Kind of files.
    #[arg(value_enum)]
    name: Name,
}

/// Files that have a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Name {
    /// Scenario files: one body and one motion, as TOML.
    Scenario,
}

impl Schema {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let schema = match self.name {
            Name::Scenario => polhode_scenario::read::schema(),
        };
        print_script(format!("{schema:#}\n").as_bytes())
    }
}
