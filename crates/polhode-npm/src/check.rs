//! Checks of robot models.

use std::path::Path;

use polhode_document::Report as _;
use polhode_robot::model::ModelFormat;
use polhode_robot::read::format_of;
use polhode_robot::{Format, Request, run};
use polhode_shape::mesh::MeshFormat;
use polhode_source::files::{Files as _, Memory};
use serde_json::{Value, json};

use crate::failed::Failed;
use crate::outcome::Outcome;

/// Checks models. The value has the report of each file, also if there is only one.
pub(crate) fn outcome(request: &Request, files: &Memory) -> Outcome {
    if !cfg!(feature = "full") && needs_full(request, files) {
        return Outcome::NeedsFull;
    }
    let checked = match run(request, files) {
        Ok(checked) => checked,
        Err(failure) => return failure.into(),
    };
    let failed = |file: &polhode_robot::FileChecked| {
        let failure = file.report.as_ref().err()?;
        Some(Failed::in_file(failure, &file.path))
    };
    let failures: Vec<Failed> = checked.files.iter().filter_map(failed).collect();
    if !failures.is_empty() {
        return Outcome::Failed(failures);
    }
    let reports = match checked.to_json() {
        Value::Array(reports) => reports,
        report => vec![report],
    };
    let remarks = checked.left_out_of(Format::Json);
    let remarks: Vec<&str> = remarks.lines().collect();
    Outcome::of(json!({ "failed": checked.has_failed(), "reports": reports, "remarks": remarks }))
}

/// Returns true if a file or the request needs a build with all languages and formats.
fn needs_full(request: &Request, files: &Memory) -> bool {
    let is_other = |bytes: &[u8]| {
        let format = str::from_utf8(bytes).ok().and_then(format_of);
        format.is_some_and(|format| format != ModelFormat::Urdf)
    };
    let is_other_mesh = |path: &Path| {
        let format = MeshFormat::of_path(path);
        format.is_some_and(|format| !matches!(format, MeshFormat::Stl | MeshFormat::Obj))
    };
    let has_policy =
        request.config.is_some() || request.baseline.is_some() || files.is_file("polhode.toml".as_ref());
    has_policy || request.nearest || files.all().any(|(path, bytes)| is_other_mesh(path) || is_other(bytes))
}
