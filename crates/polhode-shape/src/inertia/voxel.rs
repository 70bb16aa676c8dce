//! The mass properties of a voxel grid.

use std::path::Path;

use polhode::body::{BodyError, MassProperties, PlacedPart};
use polhode::math::{Body, Part, Position, Rotation};
use polhode_document::SourceInfo;
use polhode_source::files::Files;
use polhode_source::{Failure, FormatError};

use super::choice::VoxelChoice;
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
    let misread = |error| FormatError::of_content(file, &[], error);
    let mut voxels = voxel::open(files, file)?;
    let grid = voxels.grid(&options).map_err(misread)?;
    let (counts, kind) = (voxels.counts(), voxels.type_name());
    let result = voxels.mass_properties(&grid, scale).map_err(misread)?;
    let unfit = |error: BodyError| {
        Failure::usage(error.to_string(), "a voxel's value is a density, zero or positive: check --per-value")
    };
    let body = result.map_err(unfit)?;
    let [a, b, c] = counts;
    let source = SourceInfo::new(file.display().to_string(), format)
        .described(format!("voxels, {a} × {b} × {c} of {kind}, {} filled", body.filled))
        .with("voxels", counts.to_vec())
        .with("type", kind)
        .with("filled", body.filled);
    let error = error_estimate(&body.error_estimate, "what a voxel's value leaves open within it");
    Ok(InertiaReport {
        extras: vec![error],
        ..InertiaReport::new(source, in_body(body.properties).map_err(unfit)?).with_volume(Some(body.volume))
    })
}

/// A file's axes are the body's.
pub(super) fn in_body(part: MassProperties<Part>) -> Result<MassProperties<Body>, BodyError> {
    Ok(PlacedPart::new(part, Position::ZERO, Rotation::identity())?.in_body())
}
