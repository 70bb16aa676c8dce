//! `polhode stability`

use std::path::PathBuf;

use clap::Args;
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_scenario::read as scenario;
use polhode_scenario::report::{GroundStabilityReport, StabilityReport};
use polhode_source::shown;

use crate::failure::Failure;
use crate::stdout::print;

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
    /// The scenario, a TOML file.
    file: PathBuf,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

impl Stability {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let scenario = scenario::read(&self.file)?;
        let path = shown(&self.file);
        if scenario.prescribed().is_some() {
            let hint = "leave out [prescribed], or ask polhode explain for the torque that the motion needs";
            return Err(Failure::usage(
                format!("the motion of {path} is prescribed: nothing can depart from it"),
                hint,
            ));
        }
        if scenario.history().is_some() {
            let hint = "polhode simulate computes its motion; leave out [mass_history] for the body as it is at the start";
            return Err(Failure::usage(
                format!("the mass properties of {path} change: no motion of it is steady"),
                hint,
            ));
        }
        if scenario.gimbals().is_some() {
            return Err(Failure::usage(
                format!(
                    "{path} hangs its body in gimbals: which of its steady motions last is not known here"
                ),
                "polhode simulate computes its motion: start a little off the steady one",
            ));
        }
        let title = scenario.title().unwrap_or("scenario");
        let source = SourceInfo::new(self.file.display().to_string(), "scenario").described(title);
        if let Some(ground) = scenario.ground() {
            let report = GroundStabilityReport::of_scenario(source, &scenario, ground)
                .map_err(|error| Failure::motion(path, error))?;
            let text = if self.json { pretty(&report.to_json()) + "\n" } else { report.to_text() };
            return print(&text);
        }
        let report = StabilityReport::of_scenario(source, &scenario);
        let text = if self.json { pretty(&report.to_json()) + "\n" } else { report.to_text() };
        print(&text)
    }
}
