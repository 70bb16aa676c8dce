//! Results of a check request.

use std::path::{Path, PathBuf};

use polhode_document::json::pretty;
use polhode_document::{Document, Report};
use polhode_shape::failed;
use polhode_source::Failure;
use polhode_source::text::counted;
use serde_json::Value;

use crate::finding::{Finding, Severity};
use crate::policy::{Judged, Remark, baseline};
use crate::report::CheckReport;

/// Result of a [`Request`](crate::Request).
#[derive(Debug)]
pub struct Checked {
    /// Results of the files, in the order of the request.
    pub files: Vec<FileChecked>,
    /// Remarks on the configuration and the baseline.
    pub remarks: Vec<Remark>,
    /// Number of files that the configuration leaves out.
    pub excluded: usize,
    /// Lowest severity that fails.
    pub fail_on: Severity,
    /// Command in the reports: `polhode check`.
    pub(crate) command: &'static str,
    /// True if the request named exactly one file and no folder.
    pub(crate) is_one: bool,
}

/// Result for one file.
#[derive(Debug)]
pub struct FileChecked {
    /// Path of the model.
    pub path: PathBuf,
    /// Name in reports: relative to the working folder if the file is in it, with slashes.
    pub name: String,
    /// Findings, or the reason why the file could not be read.
    pub report: Result<CheckReport, Failure>,
}

/// Model with its fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fix<'a> {
    /// Path of the model.
    pub path: &'a Path,
    /// Text before the fix.
    pub old: &'a str,
    /// Fixed text; all other bytes are unchanged.
    pub new: &'a str,
}

/// Output format of results.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Format {
    /// Text for the terminal.
    #[default]
    Text,
    /// JSON, as with --json.
    Json,
    /// SARIF 2.1.0, for code scanning and editors.
    Sarif,
    /// JUnit XML, one suite per file.
    Junit,
    /// Workflow commands of GitHub Actions: annotations.
    Github,
    /// Code quality report of GitLab.
    Gitlab,
    /// Markdown table for a summary or a comment.
    Markdown,
    /// Self-contained HTML page.
    Html,
    /// Table with one line per link.
    #[cfg_attr(feature = "arguments", value(skip))]
    Table,
}

impl FileChecked {
    /// Returns the findings with the name of the file.
    pub(crate) fn judged(&self) -> Option<(&str, &Judged)> {
        Some((self.name.as_str(), &self.report.as_ref().ok()?.judged))
    }
}

impl Checked {
    /// Returns the reports of the files that could be read.
    pub fn reports(&self) -> impl Iterator<Item = &CheckReport> {
        self.files.iter().filter_map(|file| file.report.as_ref().ok())
    }

    /// Returns the models with their fixes, if fixes were requested.
    pub fn fixes(&self) -> impl Iterator<Item = Fix<'_>> {
        self.reports().filter_map(|report| {
            let new = &report.fixed.as_ref()?.repaired.text;
            Some(Fix { path: &report.model.path, old: &report.model.text, new })
        })
    }

    /// Sets the output path of the fixed model.
    #[must_use]
    pub fn with_fix_in(mut self, out: &Path) -> Self {
        for report in self.files.iter_mut().filter_map(|file| file.report.as_mut().ok()) {
            if let Some(fixed) = &mut report.fixed {
                fixed.out = Some(out.display().to_string());
            }
        }
        self
    }

    /// Returns the diff of all fixes.
    pub fn to_diff(&self) -> String {
        self.reports().filter_map(|report| report.fixed.as_ref()).map(|fixed| fixed.diff.as_str()).collect()
    }

    /// Returns the text of a baseline with all findings, and their number.
    pub fn to_baseline(&self) -> (String, usize) {
        baseline::text(self.files.iter().filter_map(FileChecked::judged))
    }

    /// Returns the results in an output format.
    pub fn to_form(&self, form: Format) -> String {
        match form {
            Format::Text => self.to_text(None),
            Format::Table => self.texts(CheckReport::to_table),
            Format::Json => pretty(&self.to_json()) + "\n",
            Format::Sarif => pretty(&self.to_sarif()) + "\n",
            Format::Junit => self.to_junit(),
            Format::Github => self.to_github(),
            Format::Gitlab => pretty(&self.to_gitlab()) + "\n",
            Format::Markdown => self.to_markdown(),
            Format::Html => self.to_document().to_html(),
        }
    }

    /// Returns messages that an output format cannot contain, as text lines.
    pub fn left_out_of(&self, form: Format) -> String {
        match form {
            Format::Json => self.about_policy().trim_start().to_owned(),
            // The GitLab report can contain only issues.
            Format::Gitlab => self.left_out().iter().map(|line| format!("{line}\n")).collect(),
            Format::Text
            | Format::Table
            | Format::Sarif
            | Format::Junit
            | Format::Github
            | Format::Markdown
            | Format::Html => String::new(),
        }
    }

    /// Concatenates a text for each report, and the remarks on the configuration and the baseline.
    fn texts(&self, text: fn(&CheckReport) -> String) -> String {
        self.reports().map(text).collect::<Vec<_>>().join("\n") + &self.about_policy()
    }

    /// Returns text lines on excluded files, unused allowances, and known findings that have
    /// disappeared.
    pub fn about_policy(&self) -> String {
        let excluded = counted(self.excluded, "file");
        let excluded =
            (self.excluded > 0).then(|| format!("excluded: {excluded}, by exclude in the configuration\n"));
        let remark = |Remark { file, place: (line, column), code, severity, message }: &Remark| {
            Some(format!("{}: {file}:{line}:{column} [{code}]: {message}\n", (*severity)?.name()))
        };
        let text: String = excluded.into_iter().chain(self.remarks.iter().filter_map(remark)).collect();
        if text.is_empty() || self.files.is_empty() { text } else { format!("\n{text}") }
    }
}

impl Report for Checked {
    /// Returns an object if one file was named, and a list otherwise. A file that cannot be read
    /// has an object with its error.
    fn to_json(&self) -> Value {
        let value = |file: &FileChecked| match &file.report {
            Ok(report) => report.to_json(),
            Err(failure) => failed(&file.path, failure),
        };
        match self.files.as_slice() {
            [file] if self.is_one => value(file),
            files => files.iter().map(value).collect(),
        }
    }

    fn to_document(&self) -> Document {
        self.page()
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        self.texts(CheckReport::to_text)
    }

    /// Returns true if a finding that counts reaches the failing severity. If fixes are written,
    /// the remaining findings decide.
    fn has_failed(&self) -> bool {
        let fails = |findings: &[Finding]| findings.iter().any(|finding| finding.severity >= self.fail_on);
        let remains = |report: &CheckReport| match &report.fixed {
            Some(fixed) if fixed.out.is_some() => fails(&fixed.remaining),
            _ => fails(report.findings()),
        };
        let mut remarks = self.remarks.iter().filter_map(|remark| remark.severity);
        remarks.any(|severity| severity >= self.fail_on) || self.reports().any(remains)
    }
}
