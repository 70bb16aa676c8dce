//! The forms of results, and where they go.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use polhode_document::json::pretty;
use polhode_document::layout::printable_lines;
use polhode_robot::finding::Severity;
use polhode_robot::format::{FileResult, Run, Unreadable};
use polhode_robot::policy::Remark;
use polhode_robot::report::CheckReport;
use polhode_source::shown;
use serde_json::Value;

use super::files::name;
use crate::failure::Failure;
use crate::partial;
use crate::stderr::tell;
use crate::stdout::{print, print_exact};

/// Flags for the form of results.
#[derive(Debug, Args)]
pub(super) struct OutputFlags {
    /// The form: text, or what a program reads.
    #[arg(long, value_enum, value_name = "FORM", conflicts_with_all = ["json", "table"])]
    format: Option<Format>,
    /// Print JSON: one object for one file, an array for several or for a folder.
    #[arg(long)]
    json: bool,
    /// Print a table, a line a link: mass, centre, principal moments, equivalent box, density, verdict.
    #[arg(long, conflicts_with = "json")]
    table: bool,
    /// Write the results to FILE, whole or not at all, and print nothing.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A form of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people.
    Text,
    /// As --json.
    Json,
    /// SARIF 2.1.0, for code scanning and editors.
    Sarif,
    /// XML of JUnit: a suite for each file.
    Junit,
    /// Commands of GitHub's workflows: annotations.
    Github,
    /// GitLab's code quality report.
    Gitlab,
    /// A table for a summary or a comment.
    Markdown,
}

/// What came of a file.
#[derive(Debug)]
pub(super) struct Outcome {
    pub(super) path: PathBuf,
    pub(super) report: Result<CheckReport, Failure>,
}

/// What came of all files.
pub(super) struct Results<'a> {
    pub(super) outcomes: &'a [Outcome],
    /// One file was named, and no folder.
    pub(super) one: bool,
    /// How many files the configuration leaves out.
    pub(super) excluded: usize,
    pub(super) remarks: &'a [Remark],
    pub(super) fail_on: Severity,
}

impl OutputFlags {
    /// Refuses a form that has no place for repairs.
    pub(super) fn require_no_other_form(&self, fixes: bool) -> Result<(), Failure> {
        match self.format {
            Some(format) if fixes && !matches!(format, Format::Text | Format::Json) => {
                let message = "--fix says what it did as text, as a table or as JSON, and --format asks for another form";
                Err(Failure::usage(message, "check the repaired model then"))
            }
            _ => Ok(()),
        }
    }

    /// Refuses a table where a diff is all that there is.
    pub(super) fn require_no_table(&self, is_diff: bool) -> Result<(), Failure> {
        if !(is_diff && self.table) {
            return Ok(());
        }
        let message = "--fix without a file prints a diff, and --table asks for a table";
        Err(Failure::usage(message, "leave one of them out, or name the file after --fix"))
    }

    /// Is the answer for a program?
    pub(super) fn is_json(&self) -> bool {
        self.json || self.format == Some(Format::Json)
    }

    /// Writes the diffs of all models, byte by byte as programs apply them, and says on standard error what is not in them.
    pub(super) fn write_diff(&self, results: &Results<'_>) -> Result<(), Failure> {
        for Outcome { path, report } in results.outcomes {
            let Ok(report) = report else { continue };
            let left = report.not_repaired();
            if !left.is_empty() {
                tell(&format!("{}\n{left}", shown(path)));
            }
        }
        tell(about_policy(results).trim_start());
        let diff = diffs(results);
        match &self.output {
            Some(path) => partial::write(path, false, |file| file.write_all(diff.as_bytes())),
            None => print_exact(&diff),
        }
    }

    /// Prints the diff of what is about to be written, where people read it.
    pub(super) fn announce(&self, results: &Results<'_>) -> Result<(), Failure> {
        if self.is_json() || self.output.is_some() {
            return Ok(());
        }
        let diff = diffs(results);
        if diff.is_empty() { Ok(()) } else { print(&format!("{diff}\n")) }
    }

    /// The file that it goes to, if not to standard output.
    pub(super) fn file(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    pub(super) fn write(&self, results: &Results<'_>, force: bool) -> Result<(), Failure> {
        let text = self.text(results);
        match &self.output {
            Some(path) => {
                let diff = if self.is_json() { String::new() } else { diffs(results) };
                let gap = if diff.is_empty() { "" } else { "\n" };
                let text = printable_lines(&format!("{diff}{gap}{text}"));
                partial::write(path, force, |file| file.write_all(text.as_bytes()))
            }
            None => print(&text),
        }
    }

    fn text(&self, results: &Results<'_>) -> String {
        let reports = || results.outcomes.iter().filter_map(|outcome| outcome.report.as_ref().ok());
        let texts = |text: fn(&CheckReport) -> String| {
            let texts: Vec<String> = reports().map(text).collect();
            texts.join("\n") + &about_policy(results)
        };
        match self.format {
            Some(Format::Json) => json(results),
            None if self.json => json(results),
            None if self.table => texts(CheckReport::to_table),
            None | Some(Format::Text) => texts(CheckReport::to_text),
            Some(Format::Sarif) => pretty(&run(results).to_sarif()) + "\n",
            Some(Format::Junit) => run(results).to_junit(),
            Some(Format::Github) => run(results).to_github(),
            Some(Format::Gitlab) => {
                // its list has room for issues alone
                let run = run(results);
                run.left_out().iter().for_each(|line| tell(&format!("{line}\n")));
                pretty(&run.to_gitlab()) + "\n"
            }
            Some(Format::Markdown) => run(results).to_markdown(),
        }
    }
}

/// What the repairs of all models change.
fn diffs(results: &Results<'_>) -> String {
    let reports = results.outcomes.iter().filter_map(|outcome| outcome.report.as_ref().ok());
    reports.filter_map(|report| report.fixed.as_ref()).map(|fixed| fixed.diff.as_str()).collect()
}

/// An object for each file; what is said of the policy goes to standard error.
fn json(results: &Results<'_>) -> String {
    tell(about_policy(results).trim_start());
    let value = |outcome: &Outcome| match &outcome.report {
        Ok(report) => report.to_json(),
        Err(failure) => failure.to_json(&outcome.path),
    };
    let values: Vec<Value> = results.outcomes.iter().map(value).collect();
    match values.as_slice() {
        [value] if results.one => pretty(value) + "\n",
        _ => pretty(&Value::Array(values)) + "\n",
    }
}

/// Files that are left out, allowances that are of no use, and what a baseline knows and is not there.
fn about_policy(results: &Results<'_>) -> String {
    let mut text = String::new();
    if results.excluded > 0 {
        let noun = if results.excluded == 1 { "file" } else { "files" };
        let _ = writeln!(text, "left out: {} {noun}, by exclude of the configuration", results.excluded);
    }
    for Remark { file, place: (line, column), code, severity, message } in results.remarks {
        let Some(severity) = severity else { continue };
        let _ = writeln!(text, "{}: {file}:{line}:{column} [{code}]: {message}", severity.name());
    }
    if text.is_empty() || results.outcomes.is_empty() { text } else { format!("\n{text}") }
}

fn run<'a>(results: &Results<'a>) -> Run<'a> {
    let file = |outcome: &'a Outcome| FileResult {
        file: name(&outcome.path),
        outcome: outcome.report.as_ref().map_err(|failure| {
            let error = failure.to_json(&outcome.path);
            let number =
                |key: &str| error["error"][key].as_u64().and_then(|number| usize::try_from(number).ok());
            let message = error["error"]["message"].as_str().unwrap_or("cannot be read").to_owned();
            Unreadable { message, place: number("line").zip(number("column")) }
        }),
    };
    Run {
        files: results.outcomes.iter().map(file).collect(),
        excluded: results.excluded,
        remarks: results.remarks,
        fail_on: results.fail_on,
    }
}
