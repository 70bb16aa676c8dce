//! `polhode judge`

mod read_as;
mod suite;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::infer::judge::JudgeError;
use polhode_formats::run_log::{self, RunLog};
use polhode_formats::scenario::ScenarioFile;
use polhode_formats::unit::Dimension;
use polhode_report::{Document, JudgeReport, JudgedRun, judge_hint, pretty};
use serde_json::Value;

use crate::failure::Failure;
use crate::numbers::{positive, quantity};
use crate::stderr::shown;
use crate::stdout::{columns, print};

use read_as::ReadAs;

/// Say whether the motion that another program computed is right, and if not why.
///
/// The scenario says what the motion is, and RUN is the log of the program: times and attitudes, and perhaps angular velocities, as
/// CSV, Parquet or JSON lines. A log may name its scenario itself. What its numbers mean is found by the motion that they begin with:
/// the order of quaternions, which way they turn, along which axes ω is, when time begins; where the log does not tell, that is asked. Each
/// row is then compared with the exact motion. Several runs of one scenario with different steps give the order of accuracy.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode judge examples/judge/mujoco-rk4.csv
  polhode judge examples/judge/tumbling.toml examples/judge/mujoco-rk4.csv examples/judge/pybullet-default.csv
  polhode judge scenario.toml run.parquet --columns \"time=t, quaternion xyzw=qx qy qz qw, omega body=wx wy wz\"
  polhode judge --write-suite suite
  polhode judge --suite suite --limit 1e-3 --html > card.html")]
pub(crate) struct Judge {
    /// The scenario (a TOML file) and the runs of it; the runs alone where they name their scenario.
    #[arg(value_name = "SCENARIO|RUN", required_unless_present_any = ["suite", "write_suite"])]
    files: Vec<PathBuf>,
    #[command(flatten)]
    read_as: ReadAs,
    /// The program's time step, s or with its unit [default: what the run says, else the distance of its rows].
    #[arg(long, value_name = "T", value_parser = step)]
    step: Option<f64>,
    /// Exit with status 1 if an attitude is off by more than this, rad or with its unit, or ω by more than this part of its largest; a case of
    /// the suite is passed up to it [default, of the suite: 0.01 rad].
    #[arg(long, value_name = "ANGLE", value_parser = limit)]
    limit: Option<f64>,
    /// Grade the runs of the suite's cases in this folder: NAME.csv, or NAME@STEP.csv for several steps (also .parquet and .jsonl); cases
    /// that a program cannot run are lines `NAME: reason` of not-run.txt.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["files", "write_suite"])]
    suite: Option<PathBuf>,
    /// Write the suite into a new folder: suite.json, a scenario for each case, and its exact motion in exact/.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["files", "form", "limit", "step", "columns", "quaternion", "sense", "omega", "axes", "time_origin"])]
    write_suite: Option<PathBuf>,
    /// Print JSON.
    #[arg(long, group = "form")]
    json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print one HTML page with plots, which needs nothing else.
    #[arg(long, group = "form")]
    html: bool,
}

/// The limit of the suite's cases, rad: what can just be seen.
const SUITE_LIMIT: f64 = 0.01;

fn step(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::TIME)?)
}

fn limit(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::ANGLE)?)
}

impl Judge {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(target) = &self.write_suite {
            return suite::write(target);
        }
        let has_failed = if let Some(folder) = &self.suite {
            let card = suite::grade(folder, &self, self.limit.unwrap_or(SUITE_LIMIT))?;
            self.print(&card.to_json(), &card.to_document())?;
            card.has_failed()
        } else {
            let report = self.report()?;
            self.print(&report.to_json(), &report.to_document())?;
            self.limit.is_some_and(|limit| report.worst() > limit)
        };
        if has_failed { Err(Failure::Findings) } else { Ok(()) }
    }

    fn print(&self, json: &Value, document: &Document) -> Result<(), Failure> {
        print(&if self.json {
            pretty(json) + "\n"
        } else if self.markdown {
            document.to_markdown()
        } else if self.html {
            document.to_html()
        } else {
            document.to_text(columns().unwrap_or(polhode_report::plain::WIDTH))
        })
    }

    fn report(&self) -> Result<JudgeReport, Failure> {
        let is_scenario =
            |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
        let (scenarios, runs): (Vec<&PathBuf>, Vec<&PathBuf>) =
            self.files.iter().partition(|path| is_scenario(path));
        if let [_, second, ..] = scenarios[..] {
            let message = format!("{} is a second scenario", shown(second));
            return Err(Failure::usage(message, "judge the runs of one scenario at a time"));
        }
        if runs.is_empty() {
            let hint = "name the log that a program wrote: polhode judge SCENARIO.toml RUN.csv";
            return Err(Failure::usage("there is no run to judge", hint));
        }
        if let (Some(_), [_, second, ..]) = (self.step, &runs[..]) {
            let message = format!("--step is of one run, and {} is another", shown(second));
            return Err(Failure::usage(
                message,
                "write the step into each run: a line `# step = 0.001` before the header",
            ));
        }
        let columns = self.read_as.columns.as_ref();
        let logs = runs
            .iter()
            .map(|path| Ok((path.as_path(), run_log::read(path, columns)?)))
            .collect::<Result<Vec<_>, Failure>>()?;
        let scenario = match scenarios.first() {
            Some(path) => ScenarioFile::read(path)?,
            None => ScenarioFile::read(&self.named(&logs)?)?,
        };
        let judged = logs.into_iter().map(|(path, log)| self.judged(&scenario, path, log, None));
        let mut judged = judged.collect::<Result<Vec<_>, _>>()?;
        let names: BTreeSet<String> = judged.iter().map(|run| run.name.clone()).collect();
        if names.len() < judged.len() {
            judged.iter_mut().for_each(|run| run.path.iter().for_each(|path| run.name.clone_from(path)));
        }
        Ok(JudgeReport::new(&scenario.scenario, judged))
    }

    /// The scenario that runs name, relative to them.
    fn named(&self, logs: &[(&Path, RunLog)]) -> Result<PathBuf, Failure> {
        let of = |(path, log): &(&Path, RunLog)| {
            let said = log.scenario.as_ref()?;
            Some(path.parent().unwrap_or(Path::new("")).join(said))
        };
        let mut found: Option<PathBuf> = None;
        for named in logs {
            let path = shown(named.0);
            let Some(scenario) = of(named) else {
                let hint = "name the scenario before it, or in it: a line `# scenario = \"t-handle.toml\"` before the header";
                return Err(Failure::usage(
                    format!("{path} does not say of which scenario it is a run"),
                    hint,
                ));
            };
            match &found {
                Some(other) if *other != scenario => {
                    let message = format!(
                        "{path} is a run of {}, and the one before of {}",
                        shown(&scenario),
                        shown(other)
                    );
                    return Err(Failure::usage(message, "judge the runs of one scenario at a time"));
                }
                _ => found = Some(scenario),
            }
        }
        found.ok_or_else(|| Failure::usage("there is no run to judge", "name the log that a program wrote"))
    }

    /// A run with what there is to say of it. `step` is the step that its name says.
    fn judged(
        &self,
        file: &ScenarioFile,
        path: &Path,
        log: RunLog,
        step: Option<f64>,
    ) -> Result<JudgedRun, Failure> {
        let declared = self.read_as.declared(&log.says);
        let step = self.step.or(step).or(log.step);
        let judged = JudgedRun::of(Some(path), &file.scenario, &log.log, &declared, step)
            .map_err(|error| refused(file, path, error))?;
        Ok(JudgedRun { ignored: log.not_read(), engine: log.engine, ..judged })
    }
}

/// Why a run cannot be judged, and what helps: what is wrong with the scenario's own motion is not the run's fault.
fn refused(file: &ScenarioFile, path: &Path, error: JudgeError) -> Failure {
    match error {
        JudgeError::Motion(error) => match file.placed(&error) {
            Some(placed) => placed.into(),
            None => Failure::Motion { path: shown(&file.path), error },
        },
        JudgeError::NoMotion | JudgeError::Changing | JudgeError::OnGround | JudgeError::InGimbals => {
            Failure::usage(error.to_string(), judge_hint(&error).unwrap_or_default()).about(&file.path)
        }
        error => Failure::usage(error.to_string(), judge_hint(&error).unwrap_or_default()).about(path),
    }
}
