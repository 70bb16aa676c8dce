//! `polhode identify`

mod simple;

use std::path::{Path, PathBuf};

use clap::Args;
use polhode_formats::identify::{self, Measurement, PayloadPlan, Plan, ReadLog, TumblePlan};
use polhode_identify::IdentifyError;
use polhode_identify::payload::identify_payload;
use polhode_identify::swing::identify_swings;
use polhode_identify::tumble::identify_tumbles;
use polhode_report::{IdentifyReport, PayloadReport, SwingReport, TumbleReport, pretty};

use crate::failure::Failure;
use crate::stderr::shown;
use crate::stdout::{columns, print};
use simple::{Asked, Simple};

/// What a plan is called that is made of flags.
const FLAGS: &str = "the flags";

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
    /// Print the payload as a part of a scenario file.
    #[arg(long, group = "form")]
    body: bool,
    /// Exit with status 1 if what is left is more than noise.
    #[arg(long)]
    strict: bool,
}

impl Identify {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let (true, Some(flag)) = (self.strict, self.simple.swings_flag()) {
            let message = format!("--strict tests what is left, and of the one test of {flag} nothing is");
            return Err(Failure::usage(
                message,
                "leave --strict out, or write a plan with more than it takes",
            ));
        }
        let Plan { title, measurement, logs } = match self.simple.asked(&self.files)? {
            Asked::File(plan) => identify::read(&plan)?,
            Asked::Text(text) if self.simple.prints_plan() => return self.print_plan(&text),
            Asked::Text(text) => identify::from_text(Path::new(FLAGS), &text)?,
        };
        let report = match measurement {
            Measurement::Tumble(plan) => IdentifyReport::Tumble(self.tumble(title.as_deref(), &plan)?),
            Measurement::Payload(plan) => IdentifyReport::Payload(self.payload(title.as_deref(), &plan)?),
            Measurement::Swing(plan) => {
                let found = identify_swings(&plan).map_err(|error| self.refused(error))?;
                let sources = logs.iter().flat_map(said).collect();
                IdentifyReport::Swing(SwingReport::new(title.as_deref(), found).with_sources(sources))
            }
            _ => {
                return Err(Failure::usage(
                    "this plan is of a kind that is not known",
                    "use a newer polhode",
                ));
            }
        };
        print(&if self.body {
            self.scenario(&report)?
        } else if self.json {
            pretty(&report.to_json()) + "\n"
        } else if self.markdown {
            report.to_document().to_markdown()
        } else if self.html {
            report.to_document().to_html()
        } else {
            report.to_document().to_text(columns().unwrap_or(polhode_report::plain::WIDTH))
        })?;
        if self.strict && report.has_model_error() { Err(Failure::Findings) } else { Ok(()) }
    }

    fn print_plan(&self, text: &str) -> Result<(), Failure> {
        let forms = [("--json", self.json), ("--markdown", self.markdown), ("--html", self.html)];
        let others = [("--body", self.body), ("--strict", self.strict)];
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

    fn tumble(&self, title: Option<&str>, plan: &TumblePlan) -> Result<TumbleReport, Failure> {
        let tumble = identify_tumbles(&plan.flights, &plan.options).map_err(|error| self.refused(error))?;
        let mut sources: Vec<String> = plan.logs.iter().flat_map(said).collect();
        if plan.found {
            sources.push("Flights were found where the body turns fast and nothing turns it".to_owned());
        }
        sources.extend(plan.cut_off.iter().cloned());
        Ok(TumbleReport::new(title, sources, tumble))
    }

    fn payload(&self, title: Option<&str>, plan: &PayloadPlan) -> Result<PayloadReport, Failure> {
        let payload = identify_payload(&plan.log).map_err(|error| match error {
            IdentifyError::NoConvergence { .. } => Failure::usage(
                error.to_string(),
                "the motion may be hidden by its noise: turn faster, about more axes, or look at motion_noise",
            )
            .about(self.place()),
            error => self.refused(error),
        })?;
        let times = plan.log.rows().iter().map(|row| row.time).collect();
        Ok(PayloadReport::new(title, said(&plan.source), times, payload))
    }

    /// The body as a part of a scenario.
    fn scenario(&self, report: &IdentifyReport) -> Result<String, Failure> {
        let (reason, hint) = match report {
            IdentifyReport::Payload(payload) => match payload.to_scenario() {
                Some(text) => return Ok(text),
                None => (
                    "--body has no body to print: the motion does not determine all of it",
                    "leave --body out to see what is unknown",
                ),
            },
            IdentifyReport::Swing(_) => (
                "--body prints payloads, and these are swing tests",
                "take mass, centre and tensor from --json",
            ),
            _ => (
                "--body has no body to print: free motion does not show the mass",
                "leave --body out to see the moments, or weigh the body",
            ),
        };
        Err(Failure::usage(reason, hint).about(self.place()))
    }

    fn refused(&self, error: IdentifyError) -> Failure {
        let hint = error.hint().unwrap_or_default();
        match error {
            IdentifyError::Motion(error) => Failure::Motion { path: shown(self.place()), error },
            error => Failure::usage(error.to_string(), hint).about(self.place()),
        }
    }
}

/// What was read of a log.
fn said(log: &ReadLog) -> Vec<String> {
    let mut lines = vec![format!("{}: {}", shown(&log.path), log.read.join("; "))];
    if !log.ignored.is_empty() {
        lines.push(format!("Not read of {}: {}", shown(&log.path), log.ignored.join(", ")));
    }
    lines
}
