//! In which form the answers are printed.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser as _};
use polhode_report::{ExportBody, ExportFormat, InertiaReport, export, pretty};
use serde_json::Value;

use crate::failure::Failure;

/// Flags for the form of the answer.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub(super) struct OutputFlags {
    /// Print JSON: one object for one file, an array for several.
    #[arg(long)]
    json: bool,
    /// Print a table, one line a file.
    #[arg(long)]
    csv: bool,
    /// Print it as another program reads it; frame, point and sign are stated beside the numbers.
    #[arg(long = "as", visible_alias = "write", value_name = "FORMAT", value_parser = formats())]
    as_format: Option<ExportFormat>,
}

fn formats() -> impl clap::builder::TypedValueParser<Value = ExportFormat> {
    let names = ExportFormat::ALL.iter().map(|format| format.name());
    PossibleValuesParser::new(names).map(|name| ExportFormat::named(&name).unwrap_or(ExportFormat::Csv))
}

impl OutputFlags {
    /// The reports as text, in the order of their files.
    pub(super) fn text(&self, reports: &[(PathBuf, InertiaReport)]) -> Result<String, Failure> {
        let format = if self.csv { Some(ExportFormat::Csv) } else { self.as_format };
        if let Some(format) = format {
            let bodies: Vec<_> = reports
                .iter()
                .map(|(file, report)| ExportBody::of_report(name(file, report, reports), report))
                .collect();
            return export(format, &bodies).map_err(|error| Failure::usage(error.to_string(), error.hint()));
        }
        let json = || reports.iter().map(|(_, report)| report.to_json());
        Ok(match reports {
            _ if !self.json => {
                reports.iter().map(|(_, report)| report.to_text()).collect::<Vec<_>>().join("\n")
            }
            [(_, report)] => pretty(&report.to_json()) + "\n",
            _ => pretty(&Value::Array(json().collect())) + "\n",
        })
    }
}

/// What a body is called: its link in a robot, else the file's name without its ending, or all of its path where two have the same.
fn name(file: &Path, report: &InertiaReport, all: &[(PathBuf, InertiaReport)]) -> String {
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
