//! `polhode explain`

use clap::Args;
use polhode_document::json::pretty;
use polhode_scenario::request::explain::{Request, run};
use polhode_source::files::Disk;

use crate::failure::Failure;
use crate::stdout::print;

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
  polhode explain examples/drag.toml --latex > drag.tex && pdflatex drag.tex")]
pub(crate) struct Explain {
    #[command(flatten)]
    request: Request,
    /// Print Markdown with typeset formulas, for GitHub, Jupyter and pandoc.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print a self-contained HTML page with typeset formulas and graphs.
    #[arg(long, group = "form")]
    html: bool,
    /// Print a LaTeX article.
    #[arg(long, group = "form")]
    latex: bool,
    /// Print JSON: sections, formulas and tables as data.
    #[arg(long, group = "form")]
    json: bool,
    /// Line width of the text, characters.
    #[arg(long, value_name = "N", default_value_t = 100, conflicts_with = "form", value_parser = clap::value_parser!(u16).range(40..=400))]
    width: u16,
}

impl Explain {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let document = run(&self.request, &Disk)?.0;
        let text = if self.json {
            pretty(&document.to_json()) + "\n"
        } else if self.markdown {
            document.to_markdown()
        } else if self.html {
            document.to_html()
        } else if self.latex {
            document.to_latex()
        } else {
            document.to_text(usize::from(self.width))
        };
        print(&text)
    }
}
