//! The mass properties of a table of particles.

use std::path::Path;

use polhode::mass_properties_of_particles;
use polhode_formats::particles::{self, ParticleFile, ParticleOptions};
use polhode_formats::read_file;
use polhode_report::{InertiaReport, SourceInfo};

use crate::failure::Failure;

pub(super) fn report(
    file: &Path,
    total_mass: Option<f64>,
    length_unit: Option<f64>,
    mass_unit: Option<f64>,
) -> Result<InertiaReport, Failure> {
    let options = ParticleOptions { mass_unit, length_unit, total_mass };
    let ParticleFile { particles, findings } = read_file(file, |bytes| particles::read(bytes, &options))?;
    let properties = mass_properties_of_particles(&particles)
        .map_err(|error| Failure::usage(error.to_string(), "check the units of the table"))?;
    let source = SourceInfo::new(file.display().to_string(), "particles")
        .described(format!("{} particles", particles.len()))
        .with("particles", particles.len());
    Ok(InertiaReport { findings, ..InertiaReport::new(source, properties) })
}
