//! Computation of the answer to a request.

use std::io;
use std::path::{Path, PathBuf};

use polhode_document::layout::printable;
use polhode_document::{Document, Report};
use polhode_source::files::Files;
use polhode_source::{Failure, shown};
use serde_json::Value;

use crate::read::{Access, BudgetFile, OverTime, Questions, read_in};
use crate::report::{BudgetDiff, BudgetReport, Scope, history, workbook};
use crate::request::{MadeFile, Output, Request};

/// Computes the report of a parts list, or its changes since another list, and the files that the
/// request names.
///
/// # Errors
/// [`Failure`] if a list cannot be read, does not make a possible body, or lacks data for the
/// request.
pub fn run(request: &Request, files: &dyn Files) -> Result<Budgeted, Failure> {
    run_watched(request, files, &mut |_, _| ())
}

/// Computes as [`run`] does, and calls `reached` with the number of bodies drawn so far and the
/// total number.
///
/// # Errors
/// Same as [`run`].
pub fn run_watched(
    request: &Request,
    files: &dyn Files,
    reached: &mut dyn FnMut(usize, usize),
) -> Result<Budgeted, Failure> {
    request.check()?;
    let access = Access { files, roots: &request.roots };
    let mut read = Vec::new();
    let mut open = |list: &Path| -> Result<BudgetFile, Failure> {
        let file = read_in(access, list)?;
        read.push(list.to_owned());
        read.extend(file.read.iter().map(|parts| parts.path.clone()));
        Ok(file)
    };
    let list = &request.file;
    let file = open(list)?;
    let questions = request.questions(&file.questions);
    if matches!(request.output, Some(Output::Plan(_))) && questions.draws == Some(0) {
        return Err(Failure::usage("a plan needs members, but --draws is 0", "leave --draws out"));
    }
    let (answer, made) = match &request.diff {
        Some(other) => {
            let after = compared(request, list, file, false)?;
            let before = compared(request, other, open(other)?, true)?;
            (Answer::Diff(Box::new([before, after])), Vec::new())
        }
        None => {
            let (report, made) =
                answered(request, &questions, file, reached).map_err(|failure| failure.in_file(list))?;
            (Answer::List(Box::new(report)), made)
        }
    };
    Ok(Budgeted { answer, made, output: request.output.clone(), read, is_strict: request.strict })
}

/// Computes one side of a difference.
fn compared(
    request: &Request,
    list: &Path,
    file: BudgetFile,
    is_other: bool,
) -> Result<BudgetReport, Failure> {
    let questions = request.questions(&file.questions);
    // A list without configurations applies to every configuration.
    let is_in_each = is_other && file.configurations.iter().all(|one| one.name.is_none());
    let configuration = request.configuration.as_deref().filter(|_| !is_in_each);
    let report = BudgetReport::of_file(file, &questions, configuration, Scope::Diff, &mut |_, _| ());
    report.map_err(|failure| failure.in_file(list))
}

/// Computes the report of a list and the files made of it, except tables of all rows.
fn answered(
    request: &Request,
    questions: &Questions,
    file: BudgetFile,
    reached: &mut dyn FnMut(usize, usize),
) -> Result<(BudgetReport, Vec<MadeFile>), Failure> {
    if request.draws == Some(0) && !file.limits.is_empty() {
        let message = "the limits of the file need draws, but --draws is 0";
        return Err(Failure::usage(message, "leave --draws out"));
    }
    let configuration = request.configuration.as_deref();
    let over_time = file.prescribed.as_ref().and_then(|all| all.over_time.clone());
    let begun = over_time
        .as_ref()
        .filter(|all| configuration.is_none() || all.configuration == request.configuration);
    let mut made = Vec::new();
    if let Some(Output::Scenario(target)) = &request.output {
        made.extend(history::files(&file, questions.basis, target)?);
    }
    let scope = match &request.output {
        None => Scope::Full,
        Some(output) => Scope::Given {
            is_drawn: request.strict && !file.limits.is_empty(),
            has_states: matches!(output, Output::Time | Output::Fill | Output::Workbook(_)),
        },
    };
    let report = BudgetReport::of_file(file, questions, configuration, scope, reached)?;
    let changes = begun.is_some_and(OverTime::has_changes);
    let text = match &request.output {
        Some(Output::Plan(target)) => {
            let plan = report.to_plan(configuration, questions, begun)?;
            if changes {
                let message = "the list has [[burn]], [[drop]] or [[deploy]], but the bodies of a plan do not change over time";
                let hint = "--scenario writes the changes over time; without these sections the plan uses the initial body";
                return Err(Failure::usage(message, hint));
            }
            Some((target.as_path(), plan))
        }
        Some(Output::Body) => {
            let body = report.to_scenario(configuration)?;
            Some((Path::new("body.toml"), if changes { AT_FIRST.to_owned() + &body } else { body }))
        }
        Some(Output::Time) => {
            let table = report.to_time_csv().ok_or_else(|| nothing_happens(over_time.as_ref()));
            Some((Path::new("over-time.csv"), table?))
        }
        Some(Output::Fill) => {
            let none = || Failure::usage("the list has no tank", "add [[tank]] with its contents");
            Some((Path::new("by-fill.csv"), report.to_fill_csv().ok_or_else(none)?))
        }
        None | Some(Output::Parts | Output::Workbook(_) | Output::Scenario(_)) => None,
    };
    made.extend(text.map(|(name, text)| (name.to_owned(), text.into_bytes())));
    Ok((report, made))
}

/// First line of a body file, if the list changes over time.
const AT_FIRST: &str = "# Initial body: polhode budget --scenario writes its changes over time\n";

fn nothing_happens(over_time: Option<&OverTime>) -> Failure {
    match over_time.and_then(|all| all.configuration.as_ref()) {
        None => history::nothing(),
        Some(name) => Failure::usage(
            format!("this configuration has no sequence: the sequence begins in \"{}\"", printable(name)),
            "leave --configuration out",
        ),
    }
}

/// Result of a [`Request`].
#[derive(Debug)]
pub struct Budgeted {
    answer: Answer,
    made: Vec<MadeFile>,
    output: Option<Output>,
    read: Vec<PathBuf>,
    is_strict: bool,
}

#[derive(Debug)]
enum Answer {
    List(Box<BudgetReport>),
    /// Reports before and after the changes.
    Diff(Box<[BudgetReport; 2]>),
}

impl Budgeted {
    /// Returns the report of a list, or `None` for a difference.
    pub fn report(&self) -> Option<&BudgetReport> {
        match &self.answer {
            Answer::List(report) => Some(report),
            Answer::Diff(_) => None,
        }
    }

    /// Returns the paths of all files that were read. They must not be overwritten.
    pub fn read(&self) -> &[PathBuf] {
        &self.read
    }

    /// Returns the files of [`Request::output`], in the order in which they must be written.
    ///
    /// # Errors
    /// [`Failure`] if a file is too large.
    pub fn files(&self) -> Result<Vec<MadeFile>, Failure> {
        let mut bytes = Vec::new();
        let (name, written) = match (&self.output, self.report()) {
            (Some(Output::Parts), Some(report)) => (Path::new("parts.csv"), report.write_csv(&mut bytes)),
            (Some(Output::Workbook(name)), Some(report)) => {
                let written = report.to_sheets();
                (&**name, written.and_then(|sheets| workbook::write(&sheets, io::Cursor::new(&mut bytes))))
            }
            _ => return Ok(self.made.clone()),
        };
        let failed = |error| Failure::usage(format!("cannot write {}: {error}", shown(name)), "");
        written.map_err(failed)?;
        Ok(vec![(name.to_owned(), bytes)])
    }
}

impl Report for Budgeted {
    fn to_json(&self) -> Value {
        match &self.answer {
            Answer::List(report) => report.to_json(),
            Answer::Diff(reports) => BudgetDiff::new(&reports[0], &reports[1]).to_json(),
        }
    }

    fn to_document(&self) -> Document {
        match &self.answer {
            Answer::List(report) => report.to_document(),
            Answer::Diff(reports) => BudgetDiff::new(&reports[0], &reports[1]).to_document(),
        }
    }

    fn has_failed(&self) -> bool {
        self.is_strict && self.report().is_some_and(BudgetReport::is_beyond)
    }
}
