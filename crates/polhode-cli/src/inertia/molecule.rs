//! The mass properties and rotational constants of molecules.

use std::path::Path;

use clap::{Args, ValueEnum};
use polhode_document::Extra;
use polhode_document::SourceInfo;
use polhode_shape::molecule;
use polhode_shape::molecule::{Isotopes, Molecule, MoleculeFormat};
use polhode_shape::report::InertiaReport;
use polhode_shape::report::MoleculeReport;
use polhode_source::files::Disk;

use crate::failure::Failure;

/// Flags for molecules.
#[derive(Debug, Args)]
pub(super) struct MoleculeFlags {
    /// The masses of a molecule's atoms whose isotope its file does not name [default: abundant].
    #[arg(long, value_name = "WHICH")]
    isotopes: Option<Which>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Which {
    /// Those of the most abundant isotopes.
    Abundant,
    /// Standard atomic weights.
    Average,
}

impl MoleculeFlags {
    /// The first that is given.
    pub(super) const fn given(&self) -> Option<&'static str> {
        if self.isotopes.is_some() { Some("--isotopes") } else { None }
    }
}

/// One report for each molecule of the file.
pub(super) fn reports(
    file: &Path,
    format: MoleculeFormat,
    flags: &MoleculeFlags,
) -> Result<Vec<InertiaReport>, Failure> {
    let isotopes = match flags.isotopes {
        Some(Which::Average) => Isotopes::Average,
        _ => Isotopes::Abundant,
    };
    let molecules = molecule::read(&Disk, file, format)?;
    let several = molecules.len() > 1;
    molecules
        .iter()
        .enumerate()
        .map(|(k, molecule)| report(file, format, molecule, several.then_some(k + 1), isotopes))
        .collect()
}

fn report(
    file: &Path,
    format: MoleculeFormat,
    molecule: &Molecule,
    number: Option<usize>,
    isotopes: Isotopes,
) -> Result<InertiaReport, Failure> {
    let unfit =
        |error: polhode::body::BodyError| Failure::usage(error.to_string(), "check the atoms' places");
    let properties = molecule.mass_properties(isotopes).map_err(unfit)?;
    let block = MoleculeReport {
        formula: molecule.formula(),
        atoms: molecule.atoms.len(),
        isotopes: isotopes.name(),
        constants: molecule.rotational_constants(isotopes).map_err(unfit)?,
    };
    let name = if molecule.name.is_empty() { block.formula.clone() } else { molecule.name.clone() };
    let words = match number {
        None => format!("molecule {name}"),
        Some(number) => format!("molecule {number}, {name}"),
    };
    let mut source = SourceInfo::new(file.display().to_string(), format.name())
        .described(words)
        .with("name", molecule.name.clone())
        .with("atoms", molecule.atoms.len());
    if let Some(number) = number {
        source = source.with("molecule", number);
    }
    Ok(InertiaReport {
        extras: vec![Extra { key: "molecule", json: block.to_json(), text: block.to_text() }],
        findings: molecule.findings_with(isotopes),
        ..InertiaReport::new(source, properties)
    })
}
