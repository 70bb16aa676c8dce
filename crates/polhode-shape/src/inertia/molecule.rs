//! Mass properties and rotational constants of molecules.

use std::path::Path;

use polhode::body::BodyError;
use polhode_source::Failure;
use polhode_source::files::Files;

use super::request::Request;
use crate::molecule;
use crate::molecule::MoleculeFormat;
use crate::report::InertiaReport;

/// Returns one report for each molecule of the file.
pub(super) fn reports(
    files: &dyn Files,
    file: &Path,
    format: MoleculeFormat,
    request: &Request,
) -> Result<Vec<InertiaReport>, Failure> {
    let isotopes = request.molecule.isotopes.unwrap_or_default();
    let molecules = molecule::read(files, file, format)?;
    let unfit = |error: BodyError| Failure::usage(error.to_string(), "check the positions of the atoms");
    molecule::reports(&molecules, isotopes, file, format).map_err(unfit)
}
