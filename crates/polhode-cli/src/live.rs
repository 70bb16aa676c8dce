//! `polhode live`

use std::path::PathBuf;

use clap::Args;
use polhode_live::{Live as Server, LiveError, LiveOptions};

use crate::browser;
use crate::failure::Failure;
use crate::stdout::print;

/// Change a body and its motion on a page, and see at once what becomes of it.
///
/// The page is served on this machine's own address, 127.0.0.1, for whoever has the address that is printed, and for no other site. It shows
/// scenarios, and any file of a body: meshes, robots, molecules, particles; more can be dropped on it. Nothing is written to the
/// disk: what is worth keeping is saved from the page. Ctrl-C ends it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode live
  polhode live examples/t-handle.toml
  polhode live part.stl robot.urdf
  polhode live examples/heavy-top.toml --no-open --port 8000")]
pub(crate) struct Live {
    /// Scenarios, meshes, robots, molecules or particles [default: a scenario to begin with].
    files: Vec<PathBuf>,
    /// Do not open the browser.
    #[arg(long)]
    no_open: bool,
    /// The port [default: a free one].
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    port: u16,
}

impl Live {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let options = LiveOptions { port: self.port, files: self.files };
        let live = Server::bind(&options).map_err(|error| failed(&error))?;
        print(&format!("{}\n", live.address()))?;
        if !self.no_open {
            browser::open(live.address().as_ref());
        }
        live.run().map_err(|error| failed(&error))
    }
}

fn failed(error: &LiveError) -> Failure {
    let hint = error.hint().map(str::to_owned);
    Failure::Usage { message: error.to_string(), file: None, place: None, hint }
}
