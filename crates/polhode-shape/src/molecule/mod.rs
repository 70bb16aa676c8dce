//! Molecules: atoms and their positions, from XYZ, MOL, SDF and PDB files.
//!
//! The unit of length of these formats is the ångström. An atom is an element or, if the file says
//! so, one of its isotopes. The mass of an element is a choice of the user, see [`Isotopes`].
//!
//! - [`xyz`]: a count, a comment, and a line for each atom; also extended XYZ
//! - [`mol`]: MDL connection tables V2000 and V3000; one in a MOL file, several in an SDF
//! - [`pdb`]: column format of the Protein Data Bank

mod element;
mod isotope;
mod line;
pub mod mol;
pub mod pdb;
mod report;
pub mod xyz;

use std::collections::BTreeMap;
use std::path::Path;

use polhode::body::{BodyError, Finding, MassProperties, Particle, Severity, mass_properties_of_particles};
use polhode::math::{Body, Position};
use polhode::observe::RotationalConstants;
use polhode_source::ContentError;
use polhode_source::file;
use polhode_source::files::Files;
use polhode_source::{FormatError, FormatErrorKind};

use isotope::{Label, label};
use line::{Field, decimals};

use crate::finding::info;

pub use element::Element;
pub use isotope::{Isotope, Isotopes, Species};
pub use report::reports;

/// Ångström, m.
const ANGSTROM: f64 = 1e-10;

/// Atomic mass constant, kg (CODATA 2018).
pub const ATOMIC_MASS: f64 = 1.660_539_066_60e-27;

/// Molecule: rigidly joined atoms of a file.
///
/// ```
/// use polhode::observe::Top;
/// use polhode_shape::molecule::{Isotopes, xyz};
/// let text = b"3\nwater, calculated\nO 0 0 0.120823\nH 0 0.761688 -0.483292\nH 0 -0.761688 -0.483292\n";
/// let water = xyz::read(text)?;
/// assert_eq!(water.formula(), "H2O");
/// let constants = water.rotational_constants(Isotopes::Abundant)?.ok_or("an atom")?;
/// assert_eq!(constants.top(), Top::Asymmetric);
/// let [a, b, c] = constants.gigahertz().map(Option::unwrap);
/// assert!((a - 773.585).abs() < 0.01 && (b - 432.163).abs() < 0.01 && (c - 277.268).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Molecule {
    /// Name in the file; often empty.
    pub name: String,
    /// Atoms; at least one.
    pub atoms: Vec<Atom>,
    /// Resolution of the coordinates, m: one unit of their last decimal.
    pub step_m: f64,
    /// Findings of the reader.
    pub findings: Vec<Finding>,
}

/// Atom of a molecule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Atom {
    /// Element or isotope.
    pub species: Species,
    /// Position of the nucleus, m.
    pub position_m: [f64; 3],
}

impl Molecule {
    /// Returns mass (kg), centre of mass and inertia tensor.
    ///
    /// Each atom is a point at its nucleus with the mass of the neutral atom, as is usual. Charges
    /// do not change the mass.
    ///
    /// # Errors
    /// [`BodyError::Empty`] without atoms, [`BodyError::Parameter`] if a position or a sum is not
    /// finite.
    pub fn mass_properties(&self, isotopes: Isotopes) -> Result<MassProperties<Body>, BodyError> {
        let particle = |atom: &Atom| {
            let mass = atom.species.mass(isotopes) * ATOMIC_MASS;
            Particle::new(mass, Position::from_array(atom.position_m))
        };
        let particles: Vec<_> = self.atoms.iter().map(particle).collect::<Result<_, _>>()?;
        mass_properties_of_particles(&particles)
    }

    /// Returns the rotational constants; `None` for a single atom.
    ///
    /// Moments count as equal, and atoms as collinear, within the rounding of the coordinates. For
    /// the radius of gyration r and the last decimal s, the relative tolerance is τ = 2 s/r. It is
    /// at least [`RotationalConstants::TOLERANCE`] and at most a hundredth.
    ///
    /// # Errors
    /// [`BodyError`], as for [`Self::mass_properties`].
    pub fn rotational_constants(&self, isotopes: Isotopes) -> Result<Option<RotationalConstants>, BodyError> {
        const MOST: f64 = 1e-2;
        let body = self.mass_properties(isotopes)?;
        let [_, _, radius] = body.gyration_radii();
        let tolerance = (2.0 * self.step_m / radius).clamp(RotationalConstants::TOLERANCE, MOST);
        RotationalConstants::with_tolerance(&body, tolerance)
    }

    /// Returns the formula in Hill order: carbon, hydrogen, then the others in alphabetical order;
    /// without carbon, all in alphabetical order. Isotopes given by the file follow their element:
    /// `C[13C]H5DO`.
    pub fn formula(&self) -> String {
        let carbon = self.atoms.iter().any(|atom| atom.species.element().number() == 6);
        let mut counts = BTreeMap::new();
        for Atom { species, .. } in &self.atoms {
            let first = match species.element().number() {
                6 => 0,
                1 if carbon => 1,
                _ => 2,
            };
            let mass_number = match species {
                Species::Element(_) => 0,
                Species::Isotope(isotope) => isotope.mass_number(),
            };
            let key = (first, species.element().symbol(), mass_number);
            counts.entry(key).or_insert((species, 0_usize)).1 += 1;
        }
        let one = |(species, count): &(&Species, usize)| match count {
            1 => species.to_string(),
            _ => format!("{species}{count}"),
        };
        counts.values().map(one).collect()
    }

    /// Returns the findings of the file, and those about the choice of masses. For elements with
    /// only short-lived isotopes, the mass is that of the longest-lived one.
    pub fn findings_with(&self, isotopes: Isotopes) -> Vec<Finding> {
        let mut findings = self.findings.clone();
        let open = self.atoms.iter().filter_map(|atom| match atom.species {
            Species::Element(element) if element.weight().is_none() => Some(element),
            _ => None,
        });
        let elements: std::collections::BTreeSet<Element> = open.collect();
        for element in elements {
            let first = Isotope::first(element);
            let instead = match isotopes {
                Isotopes::Abundant => "most abundant isotope",
                Isotopes::Average => "standard atomic weight",
            };
            let message = format!(
                "{element} has no {instead}: the mass of {first} is used, the longest-lived isotope in NUBASE2020"
            );
            findings.push(info("molecule.longest_lived", message));
        }
        findings
    }
}

/// File format of molecules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoleculeFormat {
    /// XYZ and extended XYZ.
    Xyz,
    /// MDL connection table.
    Mol,
    /// Sequence of connection tables with data.
    Sdf,
    /// Protein Data Bank format.
    Pdb,
}

impl MoleculeFormat {
    /// Returns the format for a file extension: `.xyz`, `.extxyz`, `.mol`, `.sdf`, `.sd`, `.pdb`,
    /// `.ent`, in any case.
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "xyz" | "extxyz" => Self::Xyz,
            "mol" => Self::Mol,
            "sdf" | "sd" => Self::Sdf,
            "pdb" | "ent" => Self::Pdb,
            _ => return None,
        })
    }

    /// Returns the lower-case name, as in JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xyz => "xyz",
            Self::Mol => "mol",
            Self::Sdf => "sdf",
            Self::Pdb => "pdb",
        }
    }
}

/// Reads the molecules of a file: all of an SDF, otherwise one.
///
/// # Errors
/// [`FormatError`] if the file cannot be read or is not in its format.
pub fn read(files: &dyn Files, path: &Path, format: MoleculeFormat) -> Result<Vec<Molecule>, FormatError> {
    let bytes = file::bytes(files, path, &path.to_string_lossy(), u64::MAX);
    parse(&bytes.map_err(|kind| FormatError::new(path, None, kind))?, format, path)
}

/// Parses the molecules in the bytes of a file; `path` is for messages.
///
/// ```
/// use polhode_shape::molecule::{MoleculeFormat, parse};
/// let text = b"2\ncarbon monoxide\nC 0,0 0,0 0,0\nO 0,0 0,0 1,128\n";
/// let error = parse(text, MoleculeFormat::Xyz, "co.xyz".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "co.xyz:3:3: expected the coordinate x, found \"0,0\"");
/// assert_eq!(error.hint().as_deref(), Some("use a decimal point"));
/// ```
///
/// # Errors
/// [`FormatError`] if the bytes are not in the format.
pub fn parse(bytes: &[u8], format: MoleculeFormat, path: &Path) -> Result<Vec<Molecule>, FormatError> {
    let molecules = match format {
        MoleculeFormat::Xyz => xyz::read(bytes).map(|molecule| vec![molecule]),
        MoleculeFormat::Mol | MoleculeFormat::Sdf => mol::read(bytes),
        MoleculeFormat::Pdb => pdb::read(bytes).map(|molecule| vec![molecule]),
    };
    let molecules = molecules.map_err(|error| FormatError::of_content(path, bytes, error))?;
    for molecule in &molecules {
        // Finite positions may be so far apart that their squares overflow.
        molecule
            .mass_properties(Isotopes::Abundant)
            .map_err(|error| FormatError::new(path, None, FormatErrorKind::Body(error)))?;
    }
    Ok(molecules)
}

/// Atoms read so far, with findings.
#[derive(Debug, Default)]
struct Builder {
    atoms: Vec<Atom>,
    decimals: Option<i32>,
    massless: usize,
    numbered: usize,
    findings: Vec<Finding>,
}

impl Builder {
    /// Adds an atom, or skips a point without mass; the three coordinates are in `unit` metres.
    fn push(
        &mut self,
        species: Option<Species>,
        place: [Field<'_>; 3],
        unit: f64,
    ) -> Result<(), ContentError> {
        let mut position_m = [0.0; 3];
        for ((coordinate, field), axis) in position_m.iter_mut().zip(&place).zip(["x", "y", "z"]) {
            *coordinate = field.number(&format!("the coordinate {axis}"))? * unit;
            self.decimals = self.decimals.max(Some(decimals(field.bytes)));
        }
        match species {
            Some(species) => self.atoms.push(Atom { species, position_m }),
            None => self.massless += 1,
        }
        Ok(())
    }

    /// Returns the species of a label; `None` for a point without mass.
    fn species(&mut self, field: &Field<'_>) -> Result<Option<Species>, ContentError> {
        match label(&field.text()) {
            Some(Label::Atom(species)) => Ok(Some(species)),
            Some(Label::Massless) => Ok(None),
            Some(Label::Numbered(element)) => {
                self.numbered += 1;
                Ok(Some(Species::Element(element)))
            }
            Some(Label::UnknownIsotope(element, _)) => Err(unknown_isotope(field, element)),
            None => Err(unknown_element(field)),
        }
    }

    fn notice(&mut self, code: &'static str, severity: Severity, message: String) {
        self.findings.push(Finding { code, severity, message, place: None });
    }

    /// Returns the molecule; `None` without atoms. `unit` is as in [`Self::push`].
    fn finish(mut self, name: &str, unit: f64) -> Option<Molecule> {
        if self.numbered > 0 {
            let message = format!(
                "{} labels such as C13 were read as an element and an atom number; write an isotope as 13C",
                self.numbered
            );
            self.notice("molecule.numbered_atoms", Severity::Warning, message);
        }
        if self.massless > 0 {
            let message = format!("{} points without mass (ghost atoms) were ignored", self.massless);
            self.notice("molecule.massless_points", Severity::Warning, message);
        }
        let step_m = 10_f64.powi(-self.decimals.unwrap_or(0).clamp(-300, 300)) * unit;
        let name = name.trim().to_owned();
        (!self.atoms.is_empty()).then_some(Molecule {
            name,
            atoms: self.atoms,
            step_m,
            findings: self.findings,
        })
    }
}

fn unknown_element(field: &Field<'_>) -> ContentError {
    field.wrong("the element", "a chemical symbol").hint("such as C, Cl or D; write an isotope as 13C")
}

fn unknown_isotope(field: &Field<'_>, element: Element) -> ContentError {
    let known: Vec<String> = Isotope::all(element).map(|isotope| isotope.to_string()).collect();
    field.wrong("the isotope", "one with a known mass").hint(format!("known isotopes: {}", known.join(", ")))
}
