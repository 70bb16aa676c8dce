//! `polhode judge`

mod suite;

use std::path::PathBuf;

use clap::Args;
use polhode_judge::Request;
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::form::Form;

/// Compare the motion that another program computed with the exact motion, and find the cause of
/// its error.
///
/// The scenario defines the motion; for a free body, --moments does, and the first row of the log
/// is the start. RUN is the log of the program: times and attitudes, and optionally angular
/// velocities, as CSV, Parquet or JSON lines. A log may name a scenario in its own folder. The
/// conventions of the log are detected from the beginning of its motion: order and sense of
/// quaternions, axes, origin and unit of time; frame, components and unit of ω. Each row is then
/// compared with the exact motion, or with that of another log (--against). Several runs of one
/// scenario with different steps give the order of accuracy.
///
/// Exit status: 0 if the motion is correct, 1 if a mistake was found or an error is above the
/// limit, 2 if the run cannot be judged.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode judge run.csv --moments 1,2,3
  polhode judge new.csv --against old.csv
  polhode judge examples/judge/mujoco-rk4.csv
  polhode judge examples/judge/tumbling.toml examples/judge/mujoco-rk4.csv examples/judge/pybullet-default.csv
  polhode judge scenario.toml run.parquet --columns \"time=t, quaternion xyzw=qx qy qz qw, omega body=wx wy wz\"
  polhode judge --write-suite suite
  polhode judge --suite suite --limit 1e-3 --html > card.html")]
pub(crate) struct Judge {
    #[command(flatten)]
    request: Request,
    /// Write the suite into a new folder: suite.json, a scenario for each case, and its exact
    /// motion in exact/.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["files", "moments", "start_omega", "against", "form", "limit", "roots", "step", "columns", "quaternion", "sense", "omega", "axes", "time_origin"])]
    write_suite: Option<PathBuf>,
    #[command(flatten)]
    form: Form,
}

impl Judge {
    pub(crate) fn run(self) -> Result<(), Failure> {
        match &self.write_suite {
            Some(target) => suite::write(target),
            None => self.form.print(&polhode_judge::run(&self.request, &Disk)?),
        }
    }
}
