//! `polhode explain`

use clap::Args;
use polhode_course::derivation::{self, Derivation};
use polhode_document::Document;
use polhode_scenario::request::explain::{Request, Solution, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::written::Written;

/// Show the worked solution of a scenario, with every formula and number.
///
/// The steps: the body; 1 the axes; 2 ω and N at the start; 3 the inertia tensor and its principal
/// axes; 4 Euler's equations; 5 ω(t); 6 the attitude. For a prescribed motion, the solution gives
/// the required torque and the forces on the particles; for a pendulum, the frequency and the exact
/// period.
///
/// The steps with --lagrangian or --hamiltonian: coordinates, T and U, equations of motion,
/// conserved quantities, small oscillations, values, and the verification along the run. They exist
/// for pendulums, heavy and free tops, and bodies that roll along a line.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode explain examples/notes/11-10-dumbbell.toml
  polhode explain examples/notes/11-04-pendulum.toml --lagrangian
  polhode explain examples/t-handle.toml --markdown > t-handle.md
  polhode explain examples/heavy-top.toml --html > heavy-top.html
  polhode explain examples/drag.toml --latex > drag.tex && pdflatex drag.tex
  polhode explain --derive
  polhode explain --derive euler-equations")]
pub(crate) struct Explain {
    #[command(flatten)]
    request: Option<Request>,
    /// Print a derivation of the lecture notes, such as euler-equations; without a name, list them.
    #[arg(long, value_name = "NAME", num_args = 0..=1, default_missing_value = "", conflicts_with_all = ["file", "lagrangian", "hamiltonian"])]
    derive: Option<String>,
    #[command(flatten)]
    written: Written,
}

impl Explain {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let solution = match (&self.derive, &self.request) {
            (Some(name), _) => Solution(derived(name)?),
            (None, Some(request)) => run(request, &Disk)?,
            (None, None) => return Err(Failure::usage("no scenario", "polhode explain SCENARIO.toml")),
        };
        self.written.print(&solution)
    }
}

/// Returns a derivation, or the list of them for an empty name.
fn derived(name: &str) -> Result<Document, Failure> {
    if name.is_empty() {
        return Ok(derivation::list());
    }
    let found: &Derivation = name.parse::<&'static Derivation>().map_err(|error| {
        Failure::usage(error.to_string(), "polhode explain --derive lists the derivations")
    })?;
    Ok(found.document())
}
