//! `polhode identify`

mod simple;

use std::path::{Path, PathBuf};

use clap::Args;
use polhode_document::json::pretty;
use polhode_identify::IdentifyError;
use polhode_identify::read as identify;
use polhode_identify::read::{Measurement, Plan};
use polhode_identify::report::{BodySize, IdentifyReport};
use polhode_source::files::Disk;
use polhode_source::given::{positive, quantity};
use polhode_source::shown;
use polhode_source::unit::Dimension;

use crate::failure::Failure;
use crate::stdout::{columns, print};
use simple::{Asked, Simple};

/// What a plan is called that is made of flags.
const FLAGS: &str = "the flags";

/// What is printed instead of a body: without naming them `requires` would let these pass.
const PRINTED: [&str; 3] = ["json", "markdown", "html"];

/// Find a body's mass properties from measurements of its motion.
///
/// A plan, a TOML file, says what was measured: the free motion of a thrown body by a gyro on it ([tumble]), the periods of its swings on wires or about an axis
/// ([swing]), or the wrenches of a force–torque sensor that moves with the body ([payload]). The log of a gyro, or counted swings about one axis, need no plan.
/// Every answer is a possible body; what the measurements do not determine is said, and what is left is tested for being noise.
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
    /// A plan; or logs of a gyro: CSV, Parquet or JSON lines.
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    simple: Simple,
    /// Print JSON.
    #[arg(long, group = "form")]
    json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print one HTML page with plots, which needs nothing else.
    #[arg(long, group = "form")]
    html: bool,
    /// Print the body as a part of a scenario file. Of a tumble also its first flight; what free motion does not show has to be said.
    #[arg(long, group = "form")]
    body: bool,
    /// The greatest principal moment of a body of which tumbles show only ratios, for --body.
    #[arg(long, value_name = "MOMENT", requires = "body", conflicts_with_all = PRINTED, value_parser = moment)]
    greatest_moment: Option<f64>,
    /// Exit with status 1 if what is left is more than noise.
    #[arg(long)]
    strict: bool,
}

impl Identify {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let (true, Some(flag)) = (self.strict, self.simple.swings_flag(self.body)) {
            let message = format!("--strict tests what is left, and of the one test of {flag} nothing is");
            return Err(Failure::usage(
                message,
                "leave --strict out, or write a plan with more than it takes",
            ));
        }
        let plan = match self.simple.asked(&self.files, self.body)? {
            Asked::File(plan) => identify::read(&Disk, &plan)?,
            Asked::Text(text) if self.simple.prints_plan() => return self.print_plan(&text),
            Asked::Text(text) => identify::from_text(&Disk, Path::new(FLAGS), &text)?,
        };
        let report = self.report(&plan)?;
        print(&if self.body {
            self.scenario(&report)?
        } else if self.json {
            pretty(&report.to_json()) + "\n"
        } else if self.markdown {
            report.to_document().to_markdown()
        } else if self.html {
            report.to_document().to_html()
        } else {
            report.to_document().to_text(columns().unwrap_or(polhode_document::layout::WIDTH))
        })?;
        if self.strict && report.has_model_error() { Err(Failure::Findings) } else { Ok(()) }
    }

    fn print_plan(&self, text: &str) -> Result<(), Failure> {
        let forms = [("--json", self.json), ("--markdown", self.markdown), ("--html", self.html)];
        let moment = ("--greatest-moment", self.greatest_moment.is_some());
        let others = [moment, ("--body", self.body), ("--strict", self.strict)];
        if let Some((other, _)) = forms.into_iter().chain(others).find(|(_, is_given)| *is_given) {
            let message =
                format!("--print-plan prints a plan and finds nothing: there is nothing for {other}");
            return Err(Failure::usage(message, "leave one of them out"));
        }
        print(text)
    }

    /// What failures name.
    fn place(&self) -> &Path {
        self.files.first().map_or(Path::new(FLAGS), PathBuf::as_path)
    }

    fn report(&self, plan: &Plan) -> Result<IdentifyReport, Failure> {
        let (title, sources) = (plan.title.as_deref(), plan.sources(&|path| shown(path)));
        let report = match &plan.measurement {
            Measurement::Tumble(plan) => {
                IdentifyReport::of_flights(title, sources, &plan.flights, &plan.options)
            }
            Measurement::Payload(plan) => IdentifyReport::of_payload(title, sources, &plan.log),
            Measurement::Swing(plan) => IdentifyReport::of_swings(title, sources, plan),
            _ => {
                return Err(Failure::usage(
                    "this plan is of a kind that is not known",
                    "use a newer polhode",
                ));
            }
        };
        report.map_err(|error| self.refused(error))
    }

    /// The body as a part of a scenario.
    fn scenario(&self, report: &IdentifyReport) -> Result<String, Failure> {
        // Without a file it is the mass of what was swung, which is found.
        let mass = if self.files.is_empty() { None } else { self.simple.thrown_mass()? };
        let size = BodySize { mass, greatest_moment: self.greatest_moment };
        report
            .to_scenario(&size)
            .map_err(|why| Failure::usage(why.to_string(), why.hint()).about(self.place()))
    }

    fn refused(&self, error: IdentifyError) -> Failure {
        let hint = error.hint().unwrap_or_default();
        match error {
            IdentifyError::Motion(error) => Failure::motion(shown(self.place()), error),
            error => Failure::usage(error.to_string(), hint).about(self.place()),
        }
    }
}

fn moment(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::INERTIA)?)
}
