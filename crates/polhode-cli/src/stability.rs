//! `polhode stability`

use clap::Args;
use polhode_document::Report as _;
use polhode_document::json::pretty;
use polhode_scenario::request::stability::{Request, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::stdout::{columns, print};

/// Say which steady motions of a scenario's body last: permanent rotations, and small oscillations about an equilibrium.
///
/// The permanent rotations are those of the body with its wheels, without torque, with the angular momentum of the start, and with
/// what friction inside makes of them. If torques act, the oscillations are those about the start if it is an equilibrium, else about
/// the one that is meant: at rest relative to a circular orbit, the steady precession of a top, the nearest one. Frequencies, damping
/// or growth, and the axes about which the body swings.
///
/// Of a body on the ground, with a [contact], it is the steady motion that the start is near to: rolling upright, spinning upright or on a
/// point below the centre of mass, the end states of a tippe top. Its rates, and the spin at which it becomes stable, in closed form.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode stability examples/t-handle.toml
  polhode stability examples/gravity-gradient.toml
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
