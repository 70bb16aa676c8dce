//! Reports of the slices on a table.

use std::path::Path;

use polhode_document::Report;
use polhode_document::json::pretty;
use polhode_source::Failure;
use polhode_source::files::Files;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use super::seen::Seen;
use super::{ReportAnswer, ReportError, ShownReport, TableKind};
use crate::protocol::TextError;

type Options = Map<String, Value>;

/// Runs the slice on a table at a path. `text` is the text of a plan, for the place of an error.
pub(crate) fn answer(
    kind: TableKind,
    (path, text): (&Path, Option<&str>),
    scenario: Option<&Path>,
    mut options: Options,
    seen: &Seen<'_>,
) -> ReportAnswer {
    let (key, value) = match kind {
        TableKind::Budget => ("file", json!(path)),
        _ => ("files", scenario.into_iter().chain([path]).map(|path| json!(path)).collect()),
    };
    options.insert(key.to_owned(), value);
    let report = match kind {
        TableKind::Budget => run(options, seen, polhode_budget::run),
        TableKind::Identify => run(options, seen, polhode_identify::run),
        TableKind::Judge => run(options, seen, polhode_judge::run),
        TableKind::Particles => {
            Err(Failure::usage("particles have no report", "open the file as particles: a body that turns"))
        }
    };
    match report {
        Ok(report) => {
            let document = report.to_document();
            let report = ShownReport {
                html: document.to_html(),
                json: pretty(&report.to_json()) + "\n",
                has_failed: report.has_failed(),
                title: document.title,
            };
            ReportAnswer { report: Some(report), error: None }
        }
        Err(failure) => {
            let error = TextError::of_failure(&failure, path, text);
            ReportAnswer { report: None, error: Some(ReportError { error, places: places(&failure) }) }
        }
    }
}

fn run<Q: DeserializeOwned, R: Report + 'static>(
    options: Options,
    files: &dyn Files,
    run: impl Fn(&Q, &dyn Files) -> Result<R, Failure>,
) -> Result<Box<dyn Report>, Failure> {
    // The options are read one by one, because the error of a value does not name its key.
    for (key, value) in &options {
        if let Err(error) = serde_json::from_value::<Q>(json!({ key: value })) {
            return Err(Failure::usage(format!("{key} is {value}: {error}"), ""));
        }
    }
    let request = serde_json::from_value(Value::Object(options));
    let request = request.map_err(|error| Failure::usage(error.to_string(), ""))?;
    Ok(Box::new(run(&request, files)?))
}

/// Returns the places in a failure, as the command prints them between message and advice.
fn places(failure: &Failure) -> String {
    let printed = failure.to_string();
    let (head, hint) =
        (format!("error: {}\n", failure.message()), failure.hint().map(|hint| format!("hint: {hint}\n")));
    let rest = printed.strip_prefix(&head).unwrap_or(&printed);
    hint.and_then(|hint| rest.strip_suffix(&hint)).unwrap_or(rest).to_owned()
}

/// Opens every file that a table or a plan names, without computing more than necessary.
pub(crate) fn open_named(kind: TableKind, path: &Path, files: &dyn Files) {
    match kind {
        TableKind::Budget => {
            let request =
                polhode_budget::Request { file: path.to_owned(), draws: Some(0), ..Default::default() };
            let _ = polhode_budget::run(&request, files);
        }
        TableKind::Identify => _ = polhode_identify::read::read(files, path),
        TableKind::Judge => {
            let request = polhode_judge::Request { files: vec![path.to_owned()], ..Default::default() };
            let _ = polhode_judge::run(&request, files);
        }
        TableKind::Particles => {}
    }
}
