//! `polhode judge`

mod read_as;
mod suite;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::infer::judge::JudgeError;
use polhode_document::Document;
use polhode_document::json::pretty;
use polhode_judge::{JudgeReport, JudgedRun, judge_hint};
use polhode_scenario::read::{ScenarioFile, text_of};
use polhode_source::files::Disk;
use polhode_source::files::{Confined, Files as _, NotOpened, is_path_of};
use polhode_source::unit::Dimension;
use polhode_table::log as run_log;
use polhode_table::log::RunLog;
use serde_json::Value;

use crate::failure::Failure;
use crate::numbers::{positive, quantity};
use crate::stderr::shown;
use crate::stdout::{columns, print};
use read_as::ReadAs;

/// Check the motion that another program computed, and find the cause of its error.
///
/// The scenario says what the motion is, and RUN is the log of the program: times and attitudes,
/// and perhaps angular velocities, as CSV, Parquet or JSON lines. A log may name a scenario in its
/// own folder. The meaning of the numbers is found by the motion that they begin with: the order of
/// quaternions, their sense, the axes, the origin and unit of time, frame, components and unit of
/// ω. Each row is then compared with the exact motion. Several runs of one scenario with different
/// steps give the order of accuracy.
///
/// Exit status: 0 if the motion is right, 1 if a mistake was found or an error is above the limit,
/// 2 if the run cannot be judged.
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
    /// Folder that the scenario which a log names, and the files of that scenario, may lie in besides the log's own folder.
    #[arg(long = "root", value_name = "DIR")]
    roots: Vec<PathBuf>,
    /// Greatest error of an attitude, rad or with its unit, and of ω as a part of its largest:
    /// above it the exit status is 1, and a case of the suite has failed [default: 0.01 rad].
    #[arg(long, value_name = "ANGLE", value_parser = limit)]
    limit: Option<f64>,
    /// Grade the runs of the suite's cases in this folder: NAME.csv, or NAME@STEP.csv for several steps (also .parquet and .jsonl); cases
    /// that a program cannot run are lines `NAME: reason` of not-run.txt.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["files", "write_suite"])]
    suite: Option<PathBuf>,
    /// Write the suite into a new folder: suite.json, a scenario for each case, and its exact motion in exact/.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["files", "form", "limit", "roots", "step", "columns", "quaternion", "sense", "omega", "axes", "time_origin"])]
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

/// Default limit of an error, rad: what can just be seen.
const LIMIT: f64 = 0.01;

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
            let card = suite::grade(folder, &self, self.limit.unwrap_or(LIMIT))?;
            self.print(&card.to_json(), &card.to_document())?;
            card.has_failed()
        } else {
            let report = self.report()?;
            self.print(&report.to_json(), &report.to_document())?;
            report.is_beyond(self.limit.unwrap_or(LIMIT))
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
            document.to_text(columns().unwrap_or(polhode_document::layout::WIDTH))
        })
    }

    fn report(&self) -> Result<JudgeReport, Failure> {
        polhode_source::file::require_folders(&Disk, &self.roots)?;
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
            return Err(Failure::usage("no log to judge was given", hint));
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
            .map(|path| Ok((path.as_path(), run_log::read(&Disk, path, columns)?)))
            .collect::<Result<Vec<_>, Failure>>()?;
        let scenario = match scenarios.first() {
            Some(path) => {
                let file = ScenarioFile::read(&Disk, path)?;
                logs.iter().try_for_each(|(run, log)| self.require_of(&file, run, log))?;
                file
            }
            None => self.named(&logs)?,
        };
        let judged = logs.into_iter().map(|(path, log)| self.judged(&scenario, path, log, None));
        let mut judged = judged.collect::<Result<Vec<_>, _>>()?;
        let names: BTreeSet<String> = judged.iter().map(|run| run.name.clone()).collect();
        if names.len() < judged.len() {
            judged.iter_mut().for_each(|run| run.path.iter().for_each(|path| run.name.clone_from(path)));
        }
        Ok(JudgeReport::new(&scenario.scenario, judged))
    }

    /// The scenario that runs name, relative to them. A log is data: it opens no file outside its folder and the roots.
    fn named(&self, logs: &[(&Path, RunLog)]) -> Result<ScenarioFile, Failure> {
        let mut found: Option<(PathBuf, Confined<'_>)> = None;
        for (run, log) in logs {
            let path = shown(run);
            let Some(said) = &log.scenario else {
                let hint = "name the scenario before it, or in it: a line `# scenario = \"t-handle.toml\"` before the header";
                return Err(Failure::usage(
                    format!("{path} does not say of which scenario it is a run"),
                    hint,
                ));
            };
            let files = Confined::beside(&Disk, run, &self.roots);
            let scenario = files.named(folder(run), said).map_err(|why| {
                let message = format!("the scenario {:?} that it names is not opened: {why}", said.display());
                let hint = match why {
                    NotOpened::Outside => {
                        "name the scenario before the run: polhode judge SCENARIO.toml RUN; or allow its folder: --root DIR"
                    }
                    NotOpened::Missing | NotOpened::NotRegular | NotOpened::NotGiven => {
                        "name the scenario before the run: polhode judge SCENARIO.toml RUN"
                    }
                };
                Failure::usage(message, hint).about(run)
            })?;
            match &found {
                Some((other, _)) if *other != scenario => {
                    let message = format!(
                        "{path} is a run of {}, and the one before of {}",
                        shown(&scenario),
                        shown(other)
                    );
                    return Err(Failure::usage(message, "judge the runs of one scenario at a time"));
                }
                Some(_) => {}
                None => found = Some((scenario, files)),
            }
        }
        let (scenario, files) = found.ok_or_else(|| {
            Failure::usage("no log to judge was given", "name the log that a program wrote")
        })?;
        Ok(ScenarioFile::read(&files, &scenario)?)
    }

    /// Checks that the scenario that a run names is the given one: the same path, or a file with the same text.
    ///
    /// A file that may not be opened, or is missing, counts as a different one.
    fn require_of(&self, scenario: &ScenarioFile, run: &Path, log: &RunLog) -> Result<(), Failure> {
        let Some(said) = &log.scenario else { return Ok(()) };
        if is_path_of(&Disk, folder(run), said, &scenario.path) {
            return Ok(());
        }
        let named = match Confined::beside(&Disk, run, &self.roots).named(folder(run), said) {
            Ok(named) => named,
            Err(why) => {
                let message = format!(
                    "it names the scenario {:?}, which was not compared with {}: {why}",
                    said.display(),
                    shown(&scenario.path)
                );
                let hint = match why {
                    NotOpened::Outside => {
                        "allow the folder of the scenario that the log names: --root DIR; or remove the line `scenario = …` from the log"
                    }
                    NotOpened::Missing | NotOpened::NotRegular | NotOpened::NotGiven => {
                        "correct the line `scenario = …` of the log, or remove it"
                    }
                };
                return Err(Failure::usage(message, hint).about(run));
            }
        };
        let is_same = fs::canonicalize(&scenario.path).is_ok_and(|given| given == named)
            || text_of(&Disk, &named).is_ok_and(|text| text == scenario.text);
        if is_same {
            return Ok(());
        }
        let message = format!(
            "it says that it is a run of {:?}, and {} is given",
            said.display(),
            shown(&scenario.path)
        );
        let hint = "give the scenario that it is of, or remove the line `scenario = …` from the log";
        Err(Failure::usage(message, hint).about(run))
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

/// The folder of a file.
fn folder(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
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
