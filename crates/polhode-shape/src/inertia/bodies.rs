//! Bodies of files, and their output formats.

use std::path::{Path, PathBuf};

use polhode::body::Finding;
use polhode_document::layout::printable;
use polhode_document::{Document, Report, VERSION};
use polhode_source::{Failure, shown};
use serde_json::{Value, json};

use super::written::MeshFile;
use crate::export::{ExportBody, ExportFormat, export};
use crate::report::InertiaReport;

/// Result of a [`Request`](crate::Request).
#[derive(Debug)]
pub struct Bodies {
    /// Results of the files, in the order of the request.
    pub files: Vec<FileBodies>,
    /// Mesh to be written, if the request names a file for it.
    pub mesh: Option<MeshFile>,
}

/// Result for one file.
#[derive(Debug)]
pub struct FileBodies {
    /// Path of the file.
    pub path: PathBuf,
    /// Report for each body of the file, or the error.
    pub reports: Result<Vec<InertiaReport>, Failure>,
}

impl Bodies {
    fn reports(&self) -> impl Iterator<Item = (&Path, &InertiaReport)> {
        self.files.iter().flat_map(|FileBodies { path, reports }| {
            reports.iter().flatten().map(|report| (path.as_path(), report))
        })
    }

    /// Returns the bodies in the format of another program.
    ///
    /// # Errors
    /// [`Failure`] if the format cannot represent one of them.
    pub fn to_format(&self, format: ExportFormat) -> Result<String, Failure> {
        let reports: Vec<_> = self.reports().collect();
        if reports.is_empty() {
            return Ok(String::new());
        }
        let body = |(file, report): &(&Path, &InertiaReport)| {
            ExportBody::of_report(name(file, report, &reports), report)
        };
        let bodies: Vec<_> = reports.iter().map(body).collect();
        export(format, &bodies).map_err(|error| Failure::usage(error.to_string(), error.hint()))
    }

    /// Returns text lines with the notes and findings, which [`Bodies::to_format`] cannot contain.
    pub fn noticed(&self) -> String {
        let mut text = String::new();
        for (file, report) in self.reports() {
            let source = &report.source;
            // The text shows assumptions and joint values only in its heading.
            if ["unit_assumed", "joints"].iter().any(|key| source.fields.contains_key(*key)) {
                text += &format!("info: {}: {}\n", shown(file), printable(&source.description));
            }
            text.extend(report.findings.iter().map(|finding| noticed(file, finding)));
        }
        text
    }
}

impl Report for Bodies {
    /// Returns an object for one body, and a list for several. A file that failed has an object
    /// with its error.
    fn to_json(&self) -> Value {
        let of = |FileBodies { path, reports }: &FileBodies| match reports {
            Ok(reports) => reports.iter().map(InertiaReport::to_json).collect(),
            Err(failure) => vec![failed(path, failure)],
        };
        let mut values: Vec<Value> = self.files.iter().flat_map(of).collect();
        if values.len() == 1 { values.remove(0) } else { Value::Array(values) }
    }

    fn to_document(&self) -> Document {
        Document::of_text("Mass properties", &self.to_text(None))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        self.reports().map(|(_, report)| report.to_text()).collect::<Vec<_>>().join("\n")
    }
}

/// Returns the JSON object for a file without a report.
pub fn failed(file: &Path, failure: &Failure) -> Value {
    json!({ "polhode": VERSION, "file": file.to_string_lossy(), "error": failure.to_json(file) })
}

/// Returns a text line for a finding about a file.
pub fn noticed(file: &Path, Finding { severity, message, code, .. }: &Finding) -> String {
    format!("{}: {}: {} [{code}]\n", severity.name(), shown(file), printable(message))
}

/// Returns the name of a body: its link in a robot, otherwise the file name without extension. If
/// two files share the name, it is the path.
fn name(file: &Path, report: &InertiaReport, all: &[(&Path, &InertiaReport)]) -> String {
    if let Some(Value::String(link)) = report.source.fields.get("link") {
        return link.clone();
    }
    let stem =
        |file: &Path| file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let own = stem(file);
    if all.iter().filter(|(other, _)| stem(other) == own).count() > 1 {
        return file.display().to_string();
    }
    own
}
