//! The mass properties of a table of particles.

use std::path::Path;

use polhode_document::SourceInfo;
use polhode_shape::particles;
use polhode_shape::particles::ParticleOptions;
use polhode_shape::report::InertiaReport;
use polhode_source::files::Disk;
use polhode_source::read_file;

use crate::failure::Failure;

pub(super) fn report(
    file: &Path,
    total_mass: Option<f64>,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> Result<InertiaReport, Failure> {
    let options = ParticleOptions { mass_unit, length_unit, total_mass };
    let table = read_file(&Disk, file, |bytes| particles::read(bytes, &options))?;
    let properties = table
        .mass_properties()
        .map_err(|error| Failure::usage(error.to_string(), "check the units of the table"))?;
    let source = SourceInfo::new(file.display().to_string(), "particles")
        .described(table.described())
        .with("particles", table.particles.len())
        .with("tensors", !table.tensors.is_empty());
    Ok(InertiaReport { findings: table.findings, ..InertiaReport::new(source, properties) })
}
