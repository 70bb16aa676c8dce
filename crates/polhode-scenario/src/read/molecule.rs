//! Molecule as a part of the body; its atoms are particles.

use std::sync::Arc;

use polhode::body::{BodyPart, Finding, Form, Particle, mass_properties_of_particles};
use polhode::math::{Part, Position};
use polhode_shape::molecule;
use polhode_shape::molecule::{ATOMIC_MASS, Isotopes, Molecule, MoleculeFormat};
use polhode_source::toml::reader::Table;
use polhode_source::toml::tree::Known;
use polhode_source::{FormatError, FormatErrorKind};

use super::placement::Placement;

/// Reads `file = "water.xyz"`, `isotopes = "average"`: the first molecule of the file.
pub(crate) fn molecule(
    table: &Table<'_>,
    name: String,
    placement: &Placement,
    findings: &mut Vec<Finding>,
) -> Result<BodyPart, FormatError> {
    let file = table.require("file", "file = \"water.xyz\"")?;
    let isotopes = match table.get("isotopes") {
        Some(choice) => match choice.choice(&["abundant", "average"])? {
            "average" => Isotopes::Average,
            _ => Isotopes::Abundant,
        },
        None => Isotopes::default(),
    };
    let path = file.path()?;
    let Some(format) = MoleculeFormat::of_path(&path) else {
        return Err(file.invalid("a molecule's file").with_hint("they end in .xyz, .mol, .sdf and .pdb"));
    };
    let read = || {
        let molecules = molecule::read(file.files(), &path, format).map_err(|error| match error.kind() {
            // A missing file has no lines, so the error refers to the scenario.
            kind @ FormatErrorKind::Io { .. } => file
                .error(kind.clone())
                .with_hint(format!("paths are relative to the scenario: this one is {path:?}")),
            _ => error.named_in(file.source().path, file.place()),
        })?;
        let first = molecules.into_iter().next().ok_or_else(|| file.invalid("a molecule with atoms"))?;
        let first = Arc::new(first);
        file.keep(Known::File(first.clone()));
        Ok(first)
    };
    let first = match file.known_as::<Molecule>() {
        Some(first) => first,
        None => read()?,
    };
    findings.extend(first.findings_with(isotopes));
    let particle = |atom: &molecule::Atom| {
        let in_part = Position::<Part>::from_array(atom.position_m);
        let in_body = placement.position + placement.rotation * in_part;
        Particle::new(atom.species.mass(isotopes) * ATOMIC_MASS, in_body)
    };
    let particles: Vec<_> =
        first.atoms.iter().map(particle).collect::<Result<_, _>>().map_err(|e| file.body(e))?;
    let properties = mass_properties_of_particles(&particles).map_err(|e| file.body(e))?;
    let symbols = first.atoms.iter().map(|atom| atom.species.element().symbol()).collect();
    Ok(BodyPart {
        name,
        kind: "molecule",
        properties,
        extent: None,
        surface_area: None,
        particles,
        form: Some(placement.form(Form::Molecule(symbols))),
    })
}
