//! Mass properties of a voxel grid.

use std::path::Path;

use polhode::body::BodyError;
use polhode::body::density::VoxelMassProperties;
use polhode_document::SourceInfo;
use polhode_source::files::Files;
use polhode_source::{Failure, FormatError};

use super::choice::VoxelChoice;
use super::in_body;
use super::request::Request;
use crate::report::{InertiaReport, error_estimate};
use crate::voxel;
use crate::voxel::VoxelOptions;

pub(super) fn report(
    files: &dyn Files,
    file: &Path,
    format: &'static str,
    request: &Request,
) -> Result<InertiaReport, Failure> {
    let VoxelChoice { spacing, origin, per_value } = &request.voxel;
    let options = VoxelOptions {
        spacing: spacing.as_ref().map(|steps| steps.value.0),
        unit: request.length_unit(),
        origin: origin.as_ref().map(|corner| corner.value.0),
    };
    let scale = per_value.as_ref().map_or(1.0, |density| density.value.0.0);
    let unfit = |error: BodyError| {
        Failure::usage(error.to_string(), "a voxel's value is a density, zero or positive: check --per-value")
    };
    voxel_report(files, file, format, &options, scale)?.map_err(unfit)
}

/// Returns the report of a voxel grid in a file of format `npy` or `nrrd`. `per_value` is the
/// density for a value of 1, kg/m³. The inner error is returned if the densities do not form a
/// physical body.
///
/// # Errors
/// [`FormatError`] if the file cannot be read.
pub fn voxel_report(
    files: &dyn Files,
    file: &Path,
    format: &str,
    options: &VoxelOptions,
    per_value: f64,
) -> Result<Result<InertiaReport, BodyError>, FormatError> {
    let misread = |error| FormatError::of_content(file, &[], error);
    let mut voxels = voxel::open(files, file)?;
    let grid = voxels.grid(options).map_err(misread)?;
    let (counts, kind) = (voxels.counts(), voxels.type_name());
    let body = voxels.mass_properties(&grid, per_value).map_err(misread)?;
    let report = |body: VoxelMassProperties| {
        let [a, b, c] = counts;
        let source = SourceInfo::new(file.display().to_string(), format)
            .described(format!("voxels, {a} × {b} × {c} of {kind}, {} filled", body.filled))
            .with("voxels", counts.to_vec())
            .with("type", kind)
            .with("filled", body.filled);
        let error = error_estimate(&body.error_estimate, "from the unknown distribution within each voxel");
        let report = InertiaReport::new(source, in_body(body.properties)?).with_volume(Some(body.volume));
        Ok(InertiaReport { extras: vec![error], ..report })
    };
    Ok(body.and_then(report))
}
