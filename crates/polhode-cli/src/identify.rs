//! `polhode identify`

use clap::Args;
use polhode_document::Report as _;
use polhode_identify::{GivenPlan, Request};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::form::Form;
use crate::stdout::print;

/// Estimate a body's mass properties from measurements of its motion.
///
/// A plan (a TOML file) describes the measurement: the free motion of a thrown body with a gyro on
/// it ([tumble]), the periods of its swings on wires or about an axis ([swing]), or the wrenches of
/// a force–torque sensor that moves with the body ([payload]). A gyro log, or swings counted about
/// one axis, need no plan. Every estimate is a physical body. The report states what the
/// measurements do not determine, and tests whether the residuals are noise.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode identify examples/identify/racket-like.toml
  polhode identify examples/identify/racket-like.toml --json
  polhode identify examples/identify/racket-like.toml --html > racket.html
  polhode identify gyro.csv --drag quadratic
  polhode identify --bifilar --mass \"1.24 kg ± 1 g\" --distance \"30 cm\" --length \"1.2 m ± 1 mm\" \\
      --swings 20 --time \"31.4 s ± 0.1 s\" --amplitude \"12 deg, 9 deg ± 1 deg\"
  polhode identify --pendulum --mass \"742 g\" --distance \"8.2 cm ± 0.5 mm\" \\
      --swings 50 --time \"41.2 s +- 0.1 s\" --amplitude \"8 deg +- 1 deg\"
  polhode identify examples/identify/racket-like.toml --body --mass \"350 g\" --greatest-moment \"0.0166 kg m^2\" > racket.toml
  polhode identify examples/identify/bifilar.toml
  polhode identify examples/identify/payload.toml
  polhode identify examples/identify/payload.toml --body > payload-body.toml")]
pub(crate) struct Identify {
    #[command(flatten)]
    request: Request,
    /// Print the plan that the options are equivalent to, and estimate nothing.
    #[arg(long)]
    print_plan: bool,
    #[command(flatten)]
    form: Form,
}

impl Identify {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if self.print_plan {
            return self.print_plan();
        }
        let found = polhode_identify::run(&self.request, &Disk)?;
        match &found.body {
            None => self.form.print(&found),
            Some(body) => {
                print(body)?;
                if found.has_failed() { Err(Failure::Findings) } else { Ok(()) }
            }
        }
    }

    fn print_plan(&self) -> Result<(), Failure> {
        let text = match self.request.plan()? {
            GivenPlan::Text(text) => text,
            GivenPlan::File(plan) => {
                let message = "--print-plan prints the plan of the options, but this file is already a plan";
                return Err(Failure::usage(message, "remove --print-plan").in_file(&plan));
            }
        };
        let request = &self.request;
        let moment = ("--greatest-moment", request.greatest_moment.is_some());
        let others = [moment, ("--body", request.body), ("--strict", request.strict)];
        let other = others.into_iter().find_map(|(other, is_given)| is_given.then_some(other));
        match self.form.option().or(other) {
            Some(other) => Err(Failure::usage(
                format!("--print-plan only prints a plan, so {other} has no effect"),
                "remove one of them",
            )),
            None => print(&text),
        }
    }
}
