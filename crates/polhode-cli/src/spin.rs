//! `polhode spin`

mod curves;
mod files;
mod when;

use clap::Args;
use polhode_document::Report as _;
use polhode_document::json::pretty;
use polhode_scenario::request::spin::{Answer, Request, Spin as SpinMotion, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::page::{Page, Shown};
use crate::plot::{Drawn, PlotFlags};
use crate::stdout::{columns, print};
use files::FileFlags;
use when::TimeFlags;

/// Free motion in closed form: kind, periods, and the state at any time.
///
/// The body is that of a scenario (about its centre of mass, from its [start]; its [run] is not
/// used), or is defined by its moments of inertia about the body axes x, y, z, or by its inertia
/// tensor. The motion is exact: ω by Jacobi elliptic functions, the attitude by theta functions.
/// The cost does not depend on the time, even 10⁹ periods from the start.
///
/// A number without a unit is SI. A list has one unit for each number, or one for all: "(0, 0, 30)
/// deg/s". No files are written unless --duration, --curves, --html, -o or --plot is given.
#[derive(Debug, Args)]
#[command(
    after_help = "\
Examples:
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01
  polhode spin examples/t-handle.toml --at 0,10,1e9
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --at-file times.txt --json | jq .motion.states
  polhode spin examples/t-handle.toml --duration \"20 s\" --every \"10 ms\" --table csv --curves -o t-handle-free
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --html=spin.html
  polhode spin --inertia 3.1,4.2,5.3,0.4,-0.3,0.2 --omega 0.1,2,0.3 --at 0:10:0.5
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --plot polhodes=polhodes.svg --plot herpolhode=herpolhode.svg
  polhode spin --moments 3.0836,3.235,1 --periods \"7.40 d, 5.38 d\" --convention long",
    group = clap::ArgGroup::new("subject").required(true),
    group = clap::ArgGroup::new("folder").args(["duration", "curves", "output"]).multiple(true),
    group = clap::ArgGroup::new("written").args(["duration", "curves", "output", "html", "plot"]).multiple(true)
)]
pub(crate) struct Spin {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    times: TimeFlags,
    /// Print JSON: the same keys for every motion.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    files: FileFlags,
    #[command(flatten)]
    plots: PlotFlags,
}

impl Spin {
    pub(crate) fn run(mut self) -> Result<(), Failure> {
        self.request.at.extend(self.times.read()?);
        let answer = run(&self.request, &Disk)?;
        let json = || pretty(&answer.to_json()) + "\n";
        let written = match &answer {
            Answer::Motion(spin) => self.write(spin, &json())?,
            Answer::Spins(_) => String::new(),
        };
        print(&if self.json { json() } else { answer.to_text(columns()) + &written })
    }

    /// Writes the requested files; returns a summary of them.
    fn write(&self, spin: &SpinMotion, json: &str) -> Result<String, Failure> {
        let target = self.files.target(self.request.file.as_deref())?;
        self.files.check_html()?;
        self.plots.check(self.files.force(), None)?;
        let plots = self.plots(spin)?;
        let scenario = spin.scenario()?;
        let page = match &scenario {
            Some((scenario, text, file)) => Page {
                command: format!("spin {}", file.display()),
                shown: Shown::Scenario { scenario, text, file },
            },
            None => Page { command: "spin".to_owned(), shown: Shown::Moments(spin.motion.principal()) },
        };
        let mut written = self.files.write_html(&spin.motion, &page, &spin.times)?;
        if let Some(target) = target {
            written +=
                &self.files.write(&target, json, &spin.motion, &spin.metadata(), &page, &spin.times)?;
        }
        Ok(written + &plots.map_or_else(|| Ok(String::new()), Drawn::publish)?)
    }

    /// Returns the plots, if any are requested.
    fn plots(&self, spin: &SpinMotion) -> Result<Option<Drawn>, Failure> {
        if !self.plots.wanted() {
            return Ok(None);
        }
        let trajectory = self.files.sampling.to_be_drawn(&spin.motion)?;
        self.plots.draw(&spin.figures(&trajectory), self.files.force(), None).map(Some)
    }
}
