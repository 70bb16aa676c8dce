//! `polhode exercise`

use clap::Args;
use polhode_course::exercise::{Request, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::written::Written;

/// Make an exercise on the rotation of rigid bodies, print its solution, or grade answers.
///
/// The topics are those of Thornton & Marion, chapter 11; without a topic they are listed. A topic
/// and a seed give the same exercise on every machine. The problem ends with a template of the
/// answer file; --answers grades it, and names the likely mistake of a wrong answer.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode exercise
  polhode exercise box-about-corner --seed 7
  polhode exercise box-about-corner --seed 7 --solution
  polhode exercise two-mass-pendulum --symbols --html > problem.html
  polhode exercise --answers mine.toml")]
pub(crate) struct Exercise {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    written: Written,
}

impl Exercise {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.written.print(&run(&self.request, &Disk)?)
    }
}
