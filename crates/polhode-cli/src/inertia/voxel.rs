//! The mass properties of a voxel grid.

use std::path::Path;

use clap::Args;
use polhode::body::{BodyError, MassProperties, PlacedPart};
use polhode::math::{Body, Part, Position, Rotation};
use polhode_document::SourceInfo;
use polhode_scenario::report::error_estimate;
use polhode_shape::report::InertiaReport;
use polhode_shape::voxel;
use polhode_shape::voxel::VoxelOptions;
use polhode_source::FormatError;
use polhode_source::files::Disk;
use polhode_source::given::{list, numbers, positive, quantity};
use polhode_source::unit::Dimension;

use crate::failure::Failure;

/// Flags for voxel grids.
#[derive(Debug, Args)]
pub(super) struct VoxelFlags {
    /// From a voxel to the next along the file's axes, one length or three, for a grid whose file does not say.
    #[arg(long, value_name = "A,B,C", value_parser = spacing)]
    spacing: Option<[f64; 3]>,
    /// Where the middle of the first voxel is, x,y,z, for a grid whose file does not say [default: the origin].
    #[arg(long, value_name = "X,Y,Z", value_parser = origin, allow_hyphen_values = true)]
    origin: Option<[f64; 3]>,
    /// The density that a voxel's value of 1 stands for, such as "1 g/cm^3" [default: 1 kg/m^3].
    #[arg(long, value_name = "DENSITY", value_parser = per_value)]
    per_value: Option<f64>,
}

impl VoxelFlags {
    /// The first that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { spacing: Some(_), .. } => Some("--spacing"),
            Self { origin: Some(_), .. } => Some("--origin"),
            Self { per_value: Some(_), .. } => Some("--per-value"),
            _ => None,
        }
    }
}

pub(super) fn report(
    file: &Path,
    format: &'static str,
    flags: &VoxelFlags,
    unit: Option<f64>,
) -> Result<InertiaReport, Failure> {
    let options = VoxelOptions { spacing: flags.spacing, unit, origin: flags.origin };
    let scale = flags.per_value.unwrap_or(1.0);
    let misread = |error| FormatError::of_content(file, &[], error);
    let mut voxels = voxel::open(&Disk, file)?;
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

fn spacing(text: &str) -> Result<[f64; 3], String> {
    let steps = match list(text, Dimension::LENGTH)?.as_slice() {
        [all] => [*all; 3],
        [a, b, c] => [*a, *b, *c],
        other => return Err(format!("one length or three belong here, not {}", other.len())),
    };
    steps.into_iter().try_for_each(|step| positive(step).map(|_| ()))?;
    Ok(steps)
}

fn origin(text: &str) -> Result<[f64; 3], String> {
    numbers(text, "x,y,z", Dimension::LENGTH)
}

fn per_value(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::DENSITY)?)
}
