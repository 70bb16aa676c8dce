//! Reports of the molecules of a file.

use std::path::Path;

use polhode::body::BodyError;
use polhode_document::{Extra, SourceInfo};

use super::{Isotopes, Molecule, MoleculeFormat};
use crate::report::{InertiaReport, MoleculeReport};

/// Returns a report for each molecule of a file, in order.
///
/// # Errors
/// [`BodyError`] if the mass properties of a molecule are not finite.
pub fn reports(
    molecules: &[Molecule],
    isotopes: Isotopes,
    file: &Path,
    format: MoleculeFormat,
) -> Result<Vec<InertiaReport>, BodyError> {
    let report = |(k, molecule): (usize, &Molecule)| {
        let properties = molecule.mass_properties(isotopes)?;
        let block = MoleculeReport {
            formula: molecule.formula(),
            atoms: molecule.atoms.len(),
            isotopes: isotopes.name(),
            constants: molecule.rotational_constants(isotopes)?,
        };
        let name = if molecule.name.is_empty() { &block.formula } else { &molecule.name };
        let source = SourceInfo::new(file.display().to_string(), format.name())
            .with("name", molecule.name.clone())
            .with("atoms", molecule.atoms.len());
        let source = match molecules.len() {
            1 => source.described(format!("molecule {name}")),
            _ => source.described(format!("molecule {}, {name}", k + 1)).with("molecule", k + 1),
        };
        Ok(InertiaReport {
            extras: vec![Extra { key: "molecule", json: block.to_json(), text: block.to_text() }],
            findings: molecule.findings_with(isotopes),
            ..InertiaReport::new(source, properties)
        })
    };
    molecules.iter().enumerate().map(report).collect()
}
