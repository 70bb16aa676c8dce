//! Grades for runs of the suite's cases.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use polhode::infer::judge::{AttitudeSense, DeclaredByName, DeclaredReading, OmegaAxes, SignedAxes};
use polhode_document::number::{counted, number};
use polhode_source::files::Files;
use polhode_source::{Failure, read_text_file, shown};
use polhode_table::log::{self, RunLog};

use crate::report::{Card, CardCase, CardRun};
use crate::runs::Judge;
use crate::suite::{CASES, SuiteCase};

/// Name of the file with reasons for cases without run, in the folder of the runs.
const NOT_RUN: &str = "not-run.txt";
/// File extensions of runs.
const ENDINGS: [&str; 4] = ["csv", "parquet", "jsonl", "ndjson"];

/// Path of a run, and the time step in its name, s.
type RunFile = (PathBuf, Option<f64>);

/// Grades the runs of the suite's cases in a folder.
///
/// # Errors
/// [`Failure`] if the folder cannot be listed, has no run of any case, or has a run of an unknown
/// case.
pub(crate) fn grade(folder: &Path, judge: Judge<'_>) -> Result<Card, Failure> {
    let runs = runs(folder, judge.files)?;
    let reasons = reasons(folder, judge.files)?;
    let case = |case: &SuiteCase| {
        let run = match runs.get(case.name) {
            Some(runs) => judged(case, runs, judge, reasons.get(case.name).map(String::as_str))?,
            None => CardRun::NotRun(
                reasons
                    .get(case.name)
                    .cloned()
                    .unwrap_or_else(|| "the folder has no run of this case".to_owned()),
            ),
        };
        let title = case.scenario()?.scenario.title().unwrap_or(case.name).to_owned();
        Ok(CardCase { name: case.name.to_owned(), title, run })
    };
    let cases = CASES.iter().map(case).collect::<Result<Vec<_>, Failure>>()?;
    let card = Card { name: shown(folder), cases, limit: judge.request.limit() };
    if card.was_run() {
        return Ok(card);
    }
    Err(Failure::usage(
        format!("{} has no run of any case of the suite", shown(folder)),
        format!(
            "a run is a file such as {}.csv; `polhode judge --write-suite DIR` writes the cases",
            CASES[0].name
        ),
    ))
}

/// Judges the runs of one case. A run that cannot be judged, or that ends too early, fails the case
/// with a reason.
fn judged(
    case: &SuiteCase,
    runs: &[RunFile],
    judge: Judge<'_>,
    reason: Option<&str>,
) -> Result<CardRun, Failure> {
    let scenario = case.scenario()?;
    let wanted = scenario.scenario.run().map(|run| run.times.as_slice()).unwrap_or_default();
    let columns = judge.request.read_as.columns.as_ref().map(|columns| &columns.value);
    let mut judged = Vec::new();
    for (path, step) in runs {
        let log = log::read(judge.files, path, columns).map_err(Failure::from);
        if let Some(short) = log.as_ref().ok().and_then(|log| too_short(log.log.times(), wanted)) {
            let reason = reason.map_or_else(String::new, |reason| format!(" ({reason})"));
            return Ok(CardRun::Unreadable(format!("{short}{reason}")));
        }
        if let Some(other) = log.as_ref().ok().and_then(|log| other_scenario(log, case.name)) {
            return Ok(CardRun::Unreadable(other));
        }
        let as_asked = |log: RunLog| RunLog { says: as_asked(&log.says), ..log };
        match log.and_then(|log| judge.judged(&scenario, path, as_asked(log), *step)) {
            Ok(run) => judged.push(run),
            Err(failure) => return Ok(CardRun::Unreadable(failure.message())),
        }
    }
    Ok(CardRun::Judged(judged))
}

/// Adds the suite's conventions where the columns do not specify others. A run that is one step
/// late, or that rotates the other way, is then wrong instead of differently interpreted.
fn as_asked(says: &DeclaredReading) -> DeclaredReading {
    let asked = DeclaredReading {
        sense: Some(AttitudeSense::BodyToSpace),
        omega_axes: Some(OmegaAxes::Body),
        axes: Some(SignedAxes::SAME),
        time_origin: Some(0.0),
        time_factor: Some(1.0),
        omega_factor: Some(1.0),
        ..DeclaredReading::default()
    };
    DeclaredReading { by_name: DeclaredByName::default(), ..says.or(&asked) }
}

/// Returns a message if a run names another scenario than this case.
fn other_scenario(log: &RunLog, case: &str) -> Option<String> {
    let said = log.scenario.as_ref()?;
    let is_case = said.file_stem().is_some_and(|stem| stem == case);
    (!is_case).then(|| format!("it names another scenario, {:?}", said.display()))
}

/// Returns a message if a run ends more than two rows before the end of its case, or has fewer than
/// ten rows.
fn too_short(times: &[f64], wanted: &[f64]) -> Option<String> {
    let span = |times: &[f64]| times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first);
    let row = |times: &[f64]| span(times) / times.len().saturating_sub(1).max(1) as f64;
    let (have, want) = (span(times), span(wanted));
    if have < want - 2.0 * row(wanted).max(row(times).min(want / 10.0)) {
        return Some(format!("it ends after {} s of {} s", number(have, 6), number(want, 6)));
    }
    (times.len() < 10).then(|| format!("it has {}; at least 10 are needed", counted(times.len(), "row")))
}

/// Returns the files of each case, with the step in their names.
fn runs(folder: &Path, files: &dyn Files) -> Result<BTreeMap<String, Vec<RunFile>>, Failure> {
    let unreadable = |error: io::Error| {
        Failure::usage(
            format!("{} cannot be listed: {error}", shown(folder)),
            "specify the folder with the runs",
        )
    };
    let mut found: BTreeMap<String, Vec<RunFile>> = BTreeMap::new();
    let entries = files.entries(folder).map_err(unreadable)?;
    let mut paths: Vec<PathBuf> = entries.into_iter().map(|(path, _)| path).collect();
    paths.sort();
    for path in paths {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if !ENDINGS.contains(&ending) {
            continue;
        }
        if !files.is_file(&path) {
            return Err(Failure::usage(
                format!("{} is not a file", shown(&path)),
                "a run must be a file: rename or remove it",
            ));
        }
        let (name, step) = match stem.split_once('@') {
            None => (stem, None),
            Some((name, step)) => {
                let number = step.parse::<f64>().ok().filter(|step| *step > 0.0 && step.is_finite());
                let wrong = || {
                    let message =
                        format!("{} has an invalid step: {step:?} is not a positive number", shown(&path));
                    Failure::usage(
                        message,
                        "write the step of the program in s after @, as in free-flips@0.001.csv",
                    )
                };
                (name, Some(number.ok_or_else(wrong)?))
            }
        };
        if CASES.iter().all(|case| case.name != name) {
            let nearest = polhode_source::nearest(name, CASES.iter().map(|case| case.name));
            let hint = nearest.map_or_else(
                || "`polhode judge --write-suite DIR` writes the cases".to_owned(),
                |name| format!("did you mean {name}?"),
            );
            return Err(Failure::usage(
                format!("{} does not belong to any case of the suite", shown(&path)),
                hint,
            ));
        }
        found.entry(name.to_owned()).or_default().push((path.clone(), step));
    }
    Ok(found)
}

/// Reads lines `NAME: reason`.
fn reasons(folder: &Path, files: &dyn Files) -> Result<BTreeMap<String, String>, Failure> {
    let path = folder.join(NOT_RUN);
    if files.look(&path).is_err_and(|error| error.kind() == io::ErrorKind::NotFound) {
        return Ok(BTreeMap::new());
    }
    let text = read_text_file(files, &path, |text| Ok(text.to_owned()))
        .map_err(|error| error.with_hint("it must be text with one line per case: NAME: reason"))?;
    let mut reasons = BTreeMap::new();
    for (k, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let named = line.split_once(':').map(|(name, why)| (name.trim(), why.trim()));
        match named.filter(|(name, _)| CASES.iter().any(|case| case.name == *name)) {
            Some((name, why)) => drop(reasons.insert(name.to_owned(), why.to_owned())),
            None => {
                let message = format!("{line:?} does not name a case of the suite");
                return Err(Failure::located(message, &path, [k + 1, 1], "write each line as NAME: reason"));
            }
        }
    }
    Ok(reasons)
}
