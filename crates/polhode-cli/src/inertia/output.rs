//! In which form the answers are printed.

use std::path::Path;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser as _};
use polhode::body::Finding;
use polhode_document::json::pretty;
use polhode_document::layout::printable;
use polhode_shape::export;
use polhode_shape::report::InertiaReport;
use polhode_shape::{ExportBody, ExportFormat};
use polhode_source::shown;
use serde_json::Value;

use crate::failure::Failure;
use crate::stderr::tell;

/// Flags for the form of the answer.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub(super) struct OutputFlags {
    /// Print JSON: one object for one file, an array for several; a file that fails has an object with its error.
    #[arg(long)]
    pub(super) json: bool,
    /// Print a table, one line a file.
    #[arg(long)]
    pub(super) csv: bool,
    /// Print it as another program reads it; frame, point and sign are stated beside the numbers.
    #[arg(long = "as", visible_alias = "write", value_name = "FORMAT", value_parser = formats())]
    as_format: Option<ExportFormat>,
}

fn formats() -> impl clap::builder::TypedValueParser<Value = ExportFormat> {
    let names = ExportFormat::ALL.iter().map(|format| format.name());
    PossibleValuesParser::new(names).map(|name| ExportFormat::named(&name).unwrap_or(ExportFormat::Csv))
}

impl OutputFlags {
    /// Says on standard error what was noticed, where the answer's form has no room for it.
    pub(super) fn warn(&self, answers: &[Answer<'_>]) {
        if !self.csv && self.as_format.is_none() {
            return;
        }
        let reports = answers.iter().flat_map(|(file, answer)| answer.iter().flatten().map(|r| (*file, r)));
        for (file, report) in reports {
            let source = &report.source;
            // What was assumed or joined stands in the heading of the text.
            if ["unit_assumed", "joints"].iter().any(|key| source.fields.contains_key(*key)) {
                tell(&format!("info: {}: {}\n", shown(file), printable(&source.description)));
            }
            report.findings.iter().for_each(|finding| tell_of(file, finding));
        }
    }

    /// The answers as text, in the order of their files. One that failed has an object of its own in JSON, and is left out elsewhere.
    pub(super) fn text(&self, answers: &[Answer<'_>]) -> Result<String, Failure> {
        let reports: Vec<(&Path, &InertiaReport)> = answers
            .iter()
            .flat_map(|(file, answer)| answer.iter().flatten().map(|report| (*file, report)))
            .collect();
        let format = if self.csv { Some(ExportFormat::Csv) } else { self.as_format };
        if let Some(format) = format {
            if reports.is_empty() {
                return Ok(String::new());
            }
            let bodies: Vec<_> = reports
                .iter()
                .map(|(file, report)| ExportBody::of_report(name(file, report, &reports), report))
                .collect();
            return export(format, &bodies).map_err(|error| Failure::usage(error.to_string(), error.hint()));
        }
        if !self.json {
            return Ok(reports.iter().map(|(_, report)| report.to_text()).collect::<Vec<_>>().join("\n"));
        }
        let values = answers.iter().flat_map(|(file, answer)| match answer {
            Ok(reports) => reports.iter().map(InertiaReport::to_json).collect(),
            Err(failure) => vec![failure.to_json(file)],
        });
        Ok(match values.collect::<Vec<_>>().as_slice() {
            [value] => pretty(value) + "\n",
            values => pretty(&Value::Array(values.to_vec())) + "\n",
        })
    }
}

/// Says on standard error what was noticed in a file.
pub(super) fn tell_of(file: &Path, Finding { severity, message, code, .. }: &Finding) {
    let severity = severity.name();
    tell(&format!("{severity}: {}: {} [{code}]\n", shown(file), printable(message)));
}

/// What becomes of a file: a report for each of its bodies, or why there is none.
pub(super) type Answer<'a> = (&'a Path, Result<Vec<InertiaReport>, Failure>);

/// What a body is called: its link in a robot, else the file's name without its ending, or all of its path where two have the same.
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
