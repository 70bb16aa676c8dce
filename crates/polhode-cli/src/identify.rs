//! `polhode identify`

use std::path::PathBuf;

use clap::Args;
use polhode_formats::identify::{self, Measurement, Plan, TumblePlan};
use polhode_identify::IdentifyError;
use polhode_identify::swing::identify_swings;
use polhode_identify::tumble::identify_tumbles;
use polhode_report::{IdentifyReport, SwingReport, TumbleReport, pretty};

use crate::failure::Failure;
use crate::stderr::shown;
use crate::stdout::{columns, print};

/// Find a body's mass properties from measurements of its motion.
///
/// PLAN says what was measured: the free motion of a thrown body by a gyro on it ([tumble]), or the periods of its swings on wires or about
/// an axis ([swing]). Every answer is a possible body; what the measurements do
/// not determine is said, and what is left is tested for being noise.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode identify examples/identify/racket-like.toml
  polhode identify examples/identify/racket-like.toml --json
  polhode identify examples/identify/racket-like.toml --html > racket.html
  polhode identify examples/identify/bifilar.toml")]
pub(crate) struct Identify {
    /// The plan: a TOML file.
    #[arg(value_name = "PLAN")]
    plan: PathBuf,
    /// Print JSON.
    #[arg(long, group = "form")]
    json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print one HTML page with plots, which needs nothing else.
    #[arg(long, group = "form")]
    html: bool,
    /// Exit with status 1 if what is left is more than noise.
    #[arg(long)]
    strict: bool,
}

impl Identify {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let Plan { title, measurement } = identify::read(&self.plan)?;
        let report = match measurement {
            Measurement::Tumble(plan) => IdentifyReport::Tumble(self.tumble(title.as_deref(), &plan)?),
            Measurement::Swing(plan) => {
                let found = identify_swings(&plan).map_err(|error| self.refused(error))?;
                IdentifyReport::Swing(SwingReport::new(title.as_deref(), found))
            }
            _ => {
                return Err(Failure::usage(
                    "this plan is of a kind that is not known",
                    "use a newer polhode",
                ));
            }
        };
        print(&if self.json {
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

    fn tumble(&self, title: Option<&str>, plan: &TumblePlan) -> Result<TumbleReport, Failure> {
        let tumble = identify_tumbles(&plan.flights, &plan.options).map_err(|error| self.refused(error))?;
        let mut sources: Vec<String> = Vec::new();
        for log in &plan.logs {
            sources.push(format!("{}: {}", shown(&log.path), log.read.join("; ")));
            if !log.ignored.is_empty() {
                sources.push(format!("Not read of {}: {}", shown(&log.path), log.ignored.join(", ")));
            }
        }
        if plan.found {
            sources.push("Flights were found where the body turns fast and nothing turns it".to_owned());
        }
        Ok(TumbleReport::new(title, sources, tumble))
    }

    fn refused(&self, error: IdentifyError) -> Failure {
        let hint = error.hint().unwrap_or_default();
        match error {
            IdentifyError::Motion(error) => Failure::Motion { path: shown(&self.plan), error },
            error => Failure::usage(error.to_string(), hint).about(&self.plan),
        }
    }
}
