//! `polhode mcp`

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_source::file::require_folders;
use polhode_source::files::{Confined, Disk};
use polhode_source::shown;

use crate::failure::Failure;
use crate::stdout::finished;

/// Serve commands as tools for coding agents, by the Model Context Protocol.
///
/// An agent starts this command, writes requests to its standard input and reads answers from its
/// standard output. The tools are inertia, check, simulate, judge and explain, with the arguments of
/// these commands. A tool reads only files below one folder, or texts among its arguments, and
/// writes nothing. The command ends with its input.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode mcp
  polhode mcp --root robots

Configuration of an agent:
  {\"mcpServers\": {\"polhode\": {\"command\": \"polhode\", \"args\": [\"mcp\"]}}}")]
pub(crate) struct Mcp {
    /// The folder whose files the tools may read; paths are relative to it [default: the working
    /// directory].
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
}

impl Mcp {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(root) = self.root {
            require_folders(&Disk, std::slice::from_ref(&root))?;
            std::env::set_current_dir(&root).map_err(|error| {
                let message = format!("cannot enter {}: {error}", shown(&root));
                Failure::usage(message, "name a folder that you may enter")
            })?;
        }
        let files = Confined::within(&Disk, [Path::new(".").to_owned()]);
        finished(polhode_mcp::serve(io::stdin().lock(), io::stdout(), files))
    }
}
