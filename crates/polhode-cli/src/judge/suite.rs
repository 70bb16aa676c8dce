//! The suite: written for programs, and their runs of it graded.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use polhode::infer::judge::{AttitudeSense, DeclaredByName, DeclaredReading, OmegaAxes, SignedAxes};
use polhode_document::json::pretty;
use polhode_document::number::ungrouped as number;
use polhode_judge::suite;
use polhode_judge::suite::{CASES, SuiteCase};
use polhode_judge::{Card, CardCase, CardRun};
use polhode_source::files::Disk;
use polhode_table::log as run_log;
use polhode_table::log::RunLog;
use polhode_table::output as table;
use polhode_table::output::Surroundings;

use super::Judge;
use crate::failure::Failure;
use crate::partial::{Partial, output};
use crate::stderr::shown;
use crate::stdout::print;

/// The folder of the exact motions, in that of the suite.
const EXACT: &str = "exact";
/// Why cases were not run, in the folder of the runs.
const NOT_RUN: &str = "not-run.txt";
/// What files of runs end in.
const ENDINGS: [&str; 4] = ["csv", "parquet", "jsonl", "ndjson"];

/// A run, and the step that its name says, s.
type RunFile = (PathBuf, Option<f64>);

/// Writes the suite into a new folder, whole or not at all.
pub(super) fn write(target: &Path) -> Result<(), Failure> {
    if fs::symlink_metadata(target).is_ok() {
        let message = format!("{} is there already", shown(target));
        return Err(Failure::usage(message, "name a new folder"));
    }
    let folder = Partial::folder(target, |path| fs::remove_dir_all(path))?;
    let put = |name: PathBuf, write: &dyn Fn(&mut Vec<u8>) -> io::Result<()>| {
        let mut bytes = Vec::new();
        write(&mut bytes)
            .and_then(|()| fs::write(folder.path().join(&name), &bytes))
            .map_err(|error| output(&target.join(&name), error))
    };
    fs::create_dir(folder.path().join(EXACT)).map_err(|error| output(target, error))?;
    let json = pretty(&suite::to_json()?) + "\n";
    put("suite.json".into(), &|out| out.write_all(json.as_bytes()))?;
    for case in CASES {
        put(format!("{}.toml", case.name).into(), &|out| out.write_all(case.text.as_bytes()))?;
        let file = case.scenario()?;
        let failed = |error| Failure::Motion { path: case.name.to_owned(), error };
        if let Some(motion) = file.scenario.simulate() {
            let motion = motion.map_err(failed)?;
            let surroundings = Surroundings::from(&file.scenario);
            put(Path::new(EXACT).join(format!("{}.csv", case.name)), &|out| {
                table::csv::write(&motion, &surroundings, out)
            })?;
        }
    }
    folder.publish(|partial| fs::rename(partial.path(), target)).map_err(|error| output(target, error))?;
    print(&format!(
        "wrote {}: {} cases; run them, write NAME.csv for each beside suite.json, then: polhode judge --suite {}\n",
        shown(target),
        CASES.len(),
        shown(target)
    ))
}

/// Grades the runs in a folder.
pub(super) fn grade(folder: &Path, judge: &Judge, limit: f64) -> Result<Card, Failure> {
    let runs = runs(folder)?;
    let reasons = reasons(folder)?;
    let case = |case: &SuiteCase| {
        let run = match runs.get(case.name) {
            Some(runs) => judged(case, runs, judge, reasons.get(case.name).map(String::as_str))?,
            None => CardRun::NotRun(
                reasons.get(case.name).cloned().unwrap_or_else(|| "there is no run of it".to_owned()),
            ),
        };
        let title = case.scenario()?.scenario.title().unwrap_or(case.name).to_owned();
        Ok(CardCase { name: case.name.to_owned(), title, run })
    };
    let cases = CASES.iter().map(case).collect::<Result<Vec<_>, Failure>>()?;
    let card = Card { name: shown(folder), cases, limit };
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

/// The runs of one case. One that cannot be judged, or ends too soon, fails the case, and says why.
fn judged(
    case: &SuiteCase,
    runs: &[RunFile],
    judge: &Judge,
    reason: Option<&str>,
) -> Result<CardRun, Failure> {
    let scenario = case.scenario()?;
    let wanted = scenario.scenario.run().map(|run| run.times.as_slice()).unwrap_or_default();
    let mut judged = Vec::new();
    for (path, step) in runs {
        let log = run_log::read(&Disk, path, judge.read_as.columns.as_ref()).map_err(Failure::from);
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
            Err(failure) => return Ok(CardRun::Unreadable(failure.line())),
        }
    }
    Ok(CardRun::Judged(judged))
}

/// What the suite asks for, unless the columns say something else: a program that is a step late, or turns the other way, has no other
/// meaning but is wrong.
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

/// Message about a run that names another scenario than this case.
fn other_scenario(log: &RunLog, case: &str) -> Option<String> {
    let said = log.scenario.as_ref()?;
    let is_case = said.file_stem().is_some_and(|stem| stem == case);
    (!is_case).then(|| format!("it says that it is a run of {:?}", said.display()))
}

/// What is missing of a run, where it does not reach the end of its case, to within two rows, or has fewer than ten rows.
fn too_short(times: &[f64], wanted: &[f64]) -> Option<String> {
    let span = |times: &[f64]| times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first);
    let row = |times: &[f64]| span(times) / times.len().saturating_sub(1).max(1) as f64;
    let (have, want) = (span(times), span(wanted));
    if have < want - 2.0 * row(wanted).max(row(times).min(want / 10.0)) {
        return Some(format!("it ends after {} s of {} s", number(have, 6), number(want, 6)));
    }
    (times.len() < 10).then(|| format!("it has {} rows, and ten at least are needed", times.len()))
}

/// Of each case its files, with the step that their names say.
fn runs(folder: &Path) -> Result<BTreeMap<String, Vec<RunFile>>, Failure> {
    let unreadable = |error: io::Error| {
        Failure::usage(format!("{} cannot be listed: {error}", shown(folder)), "name a folder of runs")
    };
    let mut found: BTreeMap<String, Vec<RunFile>> = BTreeMap::new();
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        paths.push(entry.map_err(unreadable)?.path());
    }
    paths.sort();
    for path in paths {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if !ENDINGS.contains(&ending) {
            continue;
        }
        if !fs::metadata(&path).is_ok_and(|metadata| metadata.is_file()) {
            return Err(Failure::usage(format!("{} is no file", shown(&path)), "a run is a file: remove it"));
        }
        let (name, step) = match stem.split_once('@') {
            None => (stem, None),
            Some((name, step)) => {
                let number = step.parse::<f64>().ok().filter(|step| *step > 0.0 && step.is_finite());
                let wrong = || {
                    let message = format!("{} names no step: {step:?} is no number of s", shown(&path));
                    Failure::usage(message, "after @ stands the program's step: free-flips@0.001.csv")
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
            return Err(Failure::usage(format!("{} is a run of no case of the suite", shown(&path)), hint));
        }
        found.entry(name.to_owned()).or_default().push((path.clone(), step));
    }
    Ok(found)
}

/// `NAME: reason`, line by line.
fn reasons(folder: &Path) -> Result<BTreeMap<String, String>, Failure> {
    let path = folder.join(NOT_RUN);
    let text = match fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(error) => {
            let message = format!("{} cannot be read: {error}", shown(&path));
            return Err(Failure::usage(message, "it is text, a line for each case: NAME: reason"));
        }
    };
    let mut reasons = BTreeMap::new();
    for (k, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let named = line.split_once(':').map(|(name, why)| (name.trim(), why.trim()));
        match named.filter(|(name, _)| CASES.iter().any(|case| case.name == *name)) {
            Some((name, why)) => drop(reasons.insert(name.to_owned(), why.to_owned())),
            None => {
                let message = format!("{line:?} names no case of the suite");
                return Err(Failure::located(message, &path, [k + 1, 1], "a line is NAME: reason"));
            }
        }
    }
    Ok(reasons)
}
