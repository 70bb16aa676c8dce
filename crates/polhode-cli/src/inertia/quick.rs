//! Binary STL files at the speed at which their bytes are read, and what that leaves out.

use std::path::Path;

use polhode::body::{Finding, Severity};
use polhode_formats::mesh::MeshFormat;
use polhode_formats::mesh::stl_quick::{self, QuickOptions};
use polhode_report::SourceInfo;

use super::model::{Model, Piece, remark, unfit};
use crate::failure::Failure;
use crate::stderr::shown;

/// What `--quick` does not look at.
pub(super) const NOT_CHECKED: &[&str] = &["closed", "winding", "duplicates", "nesting", "overlaps"];

/// The solid of the moments of a binary STL file.
pub(super) fn model(
    file: &Path,
    format: MeshFormat,
    unit: f64,
    findings: &mut Vec<Finding>,
) -> Result<Model, Failure> {
    let refused = || {
        let hint = "leave it out: other files are read and checked wholly";
        Failure::usage(format!("--quick is for binary STL, and {} is not", shown(file)), hint)
    };
    if format != MeshFormat::Stl {
        return Err(refused());
    }
    let options = QuickOptions { verdict: false, ..QuickOptions::default() };
    let moments = stl_quick::read(file, &options)?.ok_or_else(refused)?;
    let solid = moments.solid(unit).map_err(unfit)?;
    if moments.inverted {
        let message = "the normals of the mesh pointed inward and were turned";
        findings.push(remark(file, "mesh.inverted", Severity::Warning, message));
    }
    let message = "whether the mesh bounds a solid was not looked at, as you said";
    findings.push(remark(file, "mesh.not_checked", Severity::Warning, message));
    let words = NOT_CHECKED.join(", ");
    let source = SourceInfo::new(file.display().to_string(), "stl")
        .described(format!("STL binary, {} triangles, not checked: {words}", moments.triangles))
        .with("encoding", "binary")
        .with("triangles", moments.triangles)
        .with("parts", 1)
        .with("unit_m", unit)
        .with("taken_as", "solid");
    Ok(Model {
        source,
        unit,
        pieces: vec![Piece { name: String::new(), shape: Box::new(solid) }],
        field: None,
    })
}
