//! Output formats of `polhode inertia`.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser as _};
use polhode_shape::{Bodies, ExportFormat};
use polhode_source::Failure;

use crate::form::Form;

/// Options for the output format.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub(super) struct OutputFlags {
    /// Print JSON: one object for one file, an array for several; a file that fails has an object
    /// with its error.
    #[arg(long)]
    json: bool,
    /// Print a CSV table.
    #[arg(long)]
    pub(super) csv: bool,
    /// Print in the format of another program; comments state the frame, reference point and sign.
    #[arg(long = "as", visible_alias = "write", value_name = "FORMAT", value_parser = formats())]
    as_format: Option<ExportFormat>,
}

fn formats() -> impl clap::builder::TypedValueParser<Value = ExportFormat> {
    let names = ExportFormat::ALL.iter().map(|format| format.name());
    PossibleValuesParser::new(names).map(|name| ExportFormat::named(&name).unwrap_or(ExportFormat::Csv))
}

impl OutputFlags {
    fn format(&self) -> Option<ExportFormat> {
        if self.csv { Some(ExportFormat::Csv) } else { self.as_format }
    }

    /// Returns the format for text and JSON.
    pub(super) fn form(&self) -> Form {
        Form { json: self.json, ..Form::default() }
    }

    /// Returns true if the output format has no place for findings.
    pub(super) fn has_no_room(&self) -> bool {
        self.format().is_some()
    }

    /// Returns the results as text, in the order of their files. Only JSON includes failed files.
    pub(super) fn text(&self, bodies: &Bodies) -> Result<String, Failure> {
        match self.format() {
            Some(format) => bodies.to_format(format),
            None => Ok(self.form().text(bodies)),
        }
    }
}
