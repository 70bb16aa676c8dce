//! Binary STL files at the speed at which their bytes are read.

use std::fs;
use std::path::Path;

use polhode::{Finding, Severity};
use polhode_formats::mesh::MeshFormat;
use polhode_formats::mesh::stl_quick::{self, QuickMoments, QuickOptions};
use polhode_report::SourceInfo;

use super::mesh::{Model, Piece, remark, unfit};
use crate::failure::Failure;
use crate::stdout::shown;

/// How carefully a file is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Care {
    /// Its moments, and nothing else.
    None,
    /// Of a large file, whether it is closed and consistently wound; a small one is diagnosed wholly elsewhere.
    VerdictIfLarge,
}

/// From this size on (200,000 triangles) the full diagnosis would be waited for.
const LARGE: u64 = 10_000_000;

/// The moments of a binary STL file; `None` if it has to be looked at wholly: what is small, not binary, or not closed.
pub(super) fn solid(file: &Path, format: MeshFormat, care: Care) -> Result<Option<QuickMoments>, Failure> {
    let refused = || {
        let hint = "leave it out: other files are read and checked wholly";
        Err(Failure::usage(format!("--quick is for binary STL, and {} is not", shown(file)), hint))
    };
    let large = fs::metadata(file).is_ok_and(|file| file.is_file() && file.len() >= LARGE);
    if format != MeshFormat::Stl || care == Care::VerdictIfLarge && !large {
        return if care == Care::None { refused() } else { Ok(None) };
    }
    let options = QuickOptions { verdict: care != Care::None, ..QuickOptions::default() };
    match stl_quick::read(file, &options)? {
        None if care == Care::None => refused(),
        Some(moments) if moments.closed == Some(false) => Ok(None),
        found => Ok(found),
    }
}

/// The solid of the moments.
pub(super) fn model(
    file: &Path,
    moments: &QuickMoments,
    unit: f64,
    findings: &mut Vec<Finding>,
) -> Result<Model, Failure> {
    let solid = moments.solid(unit).map_err(unfit)?;
    if moments.inverted {
        let message = "the normals of the mesh pointed inward and were turned";
        findings.push(remark(file, "mesh.inverted", Severity::Warning, message));
    }
    let verdict = if moments.closed == Some(true) {
        let message = "closed and consistently wound; overlaps, nesting and duplicates were not looked for (--diagnose does)";
        findings.push(remark(file, "mesh.not_diagnosed", Severity::Info, message));
        "closed, consistently wound"
    } else {
        let message = "whether the mesh bounds a solid was not looked at, as you said";
        findings.push(remark(file, "mesh.not_checked", Severity::Warning, message));
        "not checked"
    };
    let source = SourceInfo::new(file.display().to_string(), "stl")
        .described(format!("STL binary, {} triangles, {verdict}", moments.triangles))
        .with("encoding", "binary")
        .with("triangles", moments.triangles)
        .with("parts", 1)
        .with("unit_m", unit)
        .with("taken_as", "solid");
    Ok(Model { source, pieces: vec![Piece { name: String::new(), shape: Box::new(solid) }], field: None })
}
