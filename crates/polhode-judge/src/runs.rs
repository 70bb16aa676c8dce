//! Runs of one scenario: reading of the logs, choice of the scenario, judgement.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use polhode::infer::judge::JudgeError;
use polhode_scenario::read::{ScenarioFile, text_of};
use polhode_source::file::require_folders;
use polhode_source::files::{Confined, Files, NotOpened, is_path_of};
use polhode_source::{Failure, shown};
use polhode_table::log::{self, RunLog};

use crate::against::Other;
use crate::free_body::FreeBody;
use crate::report::{ComparedRun, Comparison, JudgeReport, JudgedRun, judge_hint};
use crate::request::Request;

/// Request with its file system.
#[derive(Clone, Copy)]
pub(crate) struct Judge<'a> {
    pub request: &'a Request,
    pub files: &'a dyn Files,
}

/// Path of a log, and its contents.
type NamedLog<'a> = (&'a Path, RunLog);

impl<'a> Judge<'a> {
    pub(crate) fn report(self) -> Result<JudgeReport, Failure> {
        let (scenario, mut logs) = self.logs()?;
        let scenario = match scenario {
            Some(path) => {
                let file = ScenarioFile::read(self.files, path)?;
                logs.iter().try_for_each(|(run, log)| self.require_of(&file, run, log))?;
                file
            }
            None => match self.free_body()? {
                Some(body) => self.started(&body, &mut logs)?,
                None => self.named(&logs)?,
            },
        };
        let judged = logs.into_iter().map(|(path, log)| self.judged(&scenario, path, log, None));
        let mut judged = judged.collect::<Result<Vec<_>, _>>()?;
        let names: BTreeSet<String> = judged.iter().map(|run| run.name.clone()).collect();
        if names.len() < judged.len() {
            judged.iter_mut().for_each(|run| run.path.iter().for_each(|path| run.name.clone_from(path)));
        }
        Ok(JudgeReport::new(&scenario.scenario, judged))
    }

    /// Returns the scenario of the request, if it has one, and the logs of its runs.
    fn logs(self) -> Result<(Option<&'a Path>, Vec<NamedLog<'a>>), Failure> {
        require_folders(self.files, &self.request.roots)?;
        let (scenarios, runs): (Vec<&PathBuf>, Vec<&PathBuf>) =
            self.request.files.iter().partition(|path| is_scenario(path));
        if let [_, second, ..] = scenarios[..] {
            let message = format!("{} is a second scenario", shown(second));
            return Err(Failure::usage(message, "judge the runs of one scenario at a time"));
        }
        if runs.is_empty() {
            let hint = "add the log that a program wrote: polhode judge SCENARIO.toml RUN.csv";
            return Err(Failure::usage("no log to judge was given", hint));
        }
        if let (Some(_), [_, second, ..]) = (&self.request.step, &runs[..]) {
            let message = format!("--step applies to one run only, but {} is a second one", shown(second));
            return Err(Failure::usage(
                message,
                "leave out --step, and write the step into each run: a line `# step = 0.001` before the header",
            ));
        }
        let columns = self.request.read_as.columns.as_ref().map(|columns| &columns.value);
        let logs = runs
            .iter()
            .map(|path| Ok((path.as_path(), log::read(self.files, path, columns)?)))
            .collect::<Result<Vec<_>, Failure>>()?;
        Ok((scenarios.first().map(|path| path.as_path()), logs))
    }

    /// Compares the runs with another log.
    pub(crate) fn compared(self, other: &Path) -> Result<Comparison, Failure> {
        let moments = self.request.moments.as_ref().map(|moments| moments.value.0);
        let (_, logs) = self.logs()?;
        let reference = log::read(self.files, other, None)?;
        let against = Other::of(other, &reference, moments)?;
        let compared = |(path, log): (&Path, RunLog)| {
            require_same_scenario(path, &log, other, &reference)?;
            let declared = self.request.read_as.declared(&log.says);
            let found = against.differences(path, &log, &declared)?;
            Ok(ComparedRun {
                path: shown(path),
                step: self.request.step.as_ref().map(|step| step.value.0.into()).or(log.step),
                ignored: log.not_read(),
                is_single_precision: log.log.is_single_precision(),
                engine: log.engine,
                found,
            })
        };
        let runs = logs.into_iter().map(compared).collect::<Result<Vec<_>, Failure>>()?;
        Ok(Comparison::new(against, runs))
    }

    /// Checks that the options state one motion with which the runs are compared.
    pub(crate) fn require_one_reference(self) -> Result<(), Failure> {
        let Request { files, moments, start_omega, against, read_as, suite, .. } = self.request;
        let option = match (against, moments) {
            (Some(_), _) => "--against",
            (None, Some(_)) => "--moments",
            (None, None) if start_omega.is_none() => return Ok(()),
            (None, None) => {
                return Err(Failure::usage(
                    "--start-omega has no effect without --moments",
                    "add --moments A,B,C; a scenario states its ω in [start]",
                ));
            }
        };
        let refused = |message: String, hint: &str| Err(Failure::usage(message, hint));
        if let Some(scenario) = files.iter().find(|path| is_scenario(path)) {
            return refused(
                format!("{} and {option} both state the motion of the run", shown(scenario)),
                "remove one of them",
            );
        }
        if suite.is_some() {
            return refused(
                format!("{option} has no effect on the suite, whose cases have their own motions"),
                "remove one of them",
            );
        }
        if against.is_some() {
            return match start_omega {
                Some(_) => refused(
                    "--start-omega has no effect with --against: no motion is computed".to_owned(),
                    "remove one of them",
                ),
                None => Ok(()),
            };
        }
        if read_as.axes.is_some() {
            let message =
                "--axes has no effect with --moments: the moments are about the body axes of the run";
            return refused(
                message.to_owned(),
                "remove --axes, and give the moments in the order of the run's axes",
            );
        }
        if read_as.time_origin.is_some() {
            let message = "--time-origin has no effect with --moments: the motion starts at the first row";
            return refused(message.to_owned(), "remove --time-origin");
        }
        Ok(())
    }

    /// Returns the free body of the request, if it states one.
    fn free_body(self) -> Result<Option<FreeBody>, Failure> {
        let Request { moments, start_omega, .. } = self.request;
        let omega = start_omega.as_ref().map(|omega| omega.value.0);
        moments.as_ref().map(|moments| FreeBody::new(moments.value.0, omega)).transpose()
    }

    /// Returns the scenario of a free body that starts at the first row of the first log. The clock
    /// and the axes of this log become those of the scenario.
    fn started(self, body: &FreeBody, logs: &mut [(&Path, RunLog)]) -> Result<ScenarioFile, Failure> {
        if let Some((run, said)) = logs.iter().find_map(|(run, log)| Some((run, log.scenario.as_ref()?))) {
            let message =
                format!("the log names the scenario {:?}, but --moments states another body", said.display());
            let hint = "remove --moments, or remove the line `scenario = …` from the log";
            return Err(Failure::usage(message, hint).in_file(run));
        }
        let Some((run, log)) = logs.first_mut() else {
            return Err(Failure::usage("no log to judge was given", "add the log that a program wrote"));
        };
        let scenario = body.scenario(&log.log, &self.request.read_as.declared(&log.says));
        let scenario =
            scenario.map_err(|error| Failure::usage(error.to_string(), error.hint()).in_file(run))?;
        log.says = FreeBody::declared(&log.log, &log.says);
        Ok(scenario)
    }

    /// Returns the scenario that the runs name, relative to them. A log is data, so it opens no
    /// file outside its folder and the roots.
    fn named(self, logs: &[(&Path, RunLog)]) -> Result<ScenarioFile, Failure> {
        let mut found: Option<(PathBuf, Confined<'a>)> = None;
        for (run, log) in logs {
            let path = shown(run);
            let Some(said) = &log.scenario else {
                let hint = "add the scenario: polhode judge SCENARIO.toml RUN; or name it in the log: a line `# scenario = \"t-handle.toml\"` before the header; or, for a free body, add its principal moments: --moments A,B,C";
                return Err(Failure::usage(format!("{path} does not name its scenario"), hint));
            };
            let files = Confined::to_folder_of(self.files, run, &self.request.roots);
            let scenario = files.named(folder(run), said).map_err(|why| {
                let message = format!("the log names the scenario {:?}, which is not opened: {why}", said.display());
                let hint = match why {
                    NotOpened::Outside => {
                        "add the scenario before the run: polhode judge SCENARIO.toml RUN; or allow its folder: --root DIR"
                    }
                    NotOpened::Missing | NotOpened::NotRegular | NotOpened::NotGiven => {
                        "add the scenario before the run: polhode judge SCENARIO.toml RUN"
                    }
                };
                Failure::usage(message, hint).in_file(run)
            })?;
            match &found {
                Some((other, _)) if *other != scenario => {
                    let message = format!(
                        "{path} is a run of {}, but the previous log is a run of {}",
                        shown(&scenario),
                        shown(other)
                    );
                    return Err(Failure::usage(message, "judge the runs of one scenario at a time"));
                }
                Some(_) => {}
                None => found = Some((scenario, files)),
            }
        }
        let (scenario, files) = found
            .ok_or_else(|| Failure::usage("no log to judge was given", "add the log that a program wrote"))?;
        Ok(ScenarioFile::read(&files, &scenario)?)
    }

    /// Checks that the scenario that a run names is the given one: the same path, or a file with
    /// the same text.
    ///
    /// A file that must not be opened, or that is missing, counts as different.
    fn require_of(self, scenario: &ScenarioFile, run: &Path, log: &RunLog) -> Result<(), Failure> {
        let Some(said) = &log.scenario else { return Ok(()) };
        if is_path_of(self.files, folder(run), said, &scenario.path) {
            return Ok(());
        }
        let named = match Confined::to_folder_of(self.files, run, &self.request.roots)
            .named(folder(run), said)
        {
            Ok(named) => named,
            Err(why) => {
                let message = format!(
                    "the log names the scenario {:?}, which could not be compared with {}: {why}",
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
                return Err(Failure::usage(message, hint).in_file(run));
            }
        };
        let is_same = self.files.canonical(&scenario.path).is_ok_and(|given| given == named)
            || text_of(self.files, &named).is_ok_and(|text| text == scenario.text);
        if is_same {
            return Ok(());
        }
        let message = format!(
            "the log names the scenario {:?}, but {} was given",
            said.display(),
            shown(&scenario.path)
        );
        let hint = "use the scenario that the log names, or remove the line `scenario = …` from the log";
        Err(Failure::usage(message, hint).in_file(run))
    }

    /// Judges a run. `step` is the step in its name, s.
    pub(crate) fn judged(
        self,
        file: &ScenarioFile,
        path: &Path,
        log: RunLog,
        step: Option<f64>,
    ) -> Result<JudgedRun, Failure> {
        let declared = self.request.read_as.declared(&log.says);
        let step = self.request.step.as_ref().map(|step| step.value.0.into()).or(step).or(log.step);
        let judged = JudgedRun::of(Some(path), &file.scenario, &log.log, &declared, step)
            .map_err(|error| refused(file, path, error))?;
        Ok(JudgedRun { ignored: log.not_read(), engine: log.engine, ..judged })
    }
}

/// Returns true for the text of a log that may be judged: it has times and attitudes.
pub fn is_run(text: &[u8]) -> bool {
    log::named_quantities(text).attitude
}

/// Returns the scenario that a log names, as a path relative to the log.
pub fn scenario_named_by(text: &[u8]) -> Option<PathBuf> {
    log::named_quantities(text).scenario
}

/// Checks that two logs do not name scenarios with different file names.
fn require_same_scenario(run: &Path, log: &RunLog, other: &Path, reference: &RunLog) -> Result<(), Failure> {
    let (Some(one), Some(another)) = (&log.scenario, &reference.scenario) else { return Ok(()) };
    if one.file_name() == another.file_name() {
        return Ok(());
    }
    let message = format!(
        "the log names the scenario {:?}, but {} names {:?}",
        one.display(),
        shown(other),
        another.display()
    );
    let hint = "compare logs of one motion, or remove the line `scenario = …` from one of them";
    Err(Failure::usage(message, hint).in_file(run))
}

fn is_scenario(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
}

/// Returns the folder of a file.
fn folder(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
}

/// Returns the failure with a hint. It refers to the scenario if the scenario's own motion is the
/// cause.
fn refused(file: &ScenarioFile, path: &Path, error: JudgeError) -> Failure {
    match error {
        JudgeError::Motion(error) => match file.placed(&error) {
            Some(placed) => placed.into(),
            None => Failure::of_motion(&file.path, error),
        },
        JudgeError::NoMotion | JudgeError::Changing | JudgeError::OnGround | JudgeError::InGimbals => {
            Failure::usage(error.to_string(), judge_hint(&error).unwrap_or_default()).in_file(&file.path)
        }
        error => Failure::usage(error.to_string(), judge_hint(&error).unwrap_or_default()).in_file(path),
    }
}
