//! Mass properties of a particle table.

use std::path::Path;

use polhode::body::BodyError;
use polhode_document::SourceInfo;
use polhode_source::files::Files;
use polhode_source::{Failure, read_file};

use super::request::Request;
use crate::particles;
use crate::particles::{ParticleFile, ParticleOptions};
use crate::report::InertiaReport;

pub(super) fn report(files: &dyn Files, file: &Path, request: &Request) -> Result<InertiaReport, Failure> {
    let (mass_unit, length_unit) = (request.mass_unit(), request.length_unit());
    let options = ParticleOptions { mass_unit, length_unit, total_mass: request.substance.mass() };
    let table = read_file(files, file, |bytes| particles::read(bytes, &options))?;
    let unfit = |error: BodyError| Failure::usage(error.to_string(), "check the units of the table");
    table.into_report(file).map_err(unfit)
}

impl ParticleFile {
    /// Returns the report of the body.
    ///
    /// # Errors
    /// [`BodyError`], as for [`ParticleFile::mass_properties`].
    pub fn into_report(self, file: &Path) -> Result<InertiaReport, BodyError> {
        let properties = self.mass_properties()?;
        let source = SourceInfo::new(file.display().to_string(), "particles")
            .described(self.described())
            .with("particles", self.particles.len())
            .with("tensors", !self.tensors.is_empty());
        Ok(InertiaReport { findings: self.findings, ..InertiaReport::new(source, properties) })
    }
}
