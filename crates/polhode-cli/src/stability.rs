//! `polhode stability`

use clap::Args;
use polhode_document::Report as _;
use polhode_document::json::pretty;
use polhode_scenario::request::stability::{Request, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::stdout::{columns, print};

/// Report which spins and rests of a scenario's body are stable.
///
/// Without torques these are the steady spins with the angular momentum of the start, with wheels
/// and with the effect of friction inside. With torques it is the start if it is an equilibrium, or
/// else a related one: at rest relative to a circular orbit, the steady precession of a top, or the
/// nearest one. Small oscillations about it are reported with period, growth rate and axis; for a
/// top also the sleeping-top threshold.
///
/// A [contact] asks for the steady motion on the ground nearest to the start: rolling upright,
/// spinning upright or on a point below the centre of mass, the end states of a tippe top. The
/// threshold of the spin is in closed form.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode stability examples/t-handle.toml
  polhode stability examples/gravity-gradient.toml
  polhode stability examples/heavy-top.toml --verbose
  polhode stability examples/heavy-top.toml --json | jq .small_oscillations.modes")]
pub(crate) struct Stability {
    #[command(flatten)]
    request: Request,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

impl Stability {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let report = run(&self.request, &Disk)?;
        print(&if self.json { pretty(&report.to_json()) + "\n" } else { report.to_text(columns()) })
    }
}
