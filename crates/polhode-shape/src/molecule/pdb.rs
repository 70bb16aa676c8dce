//! PDB: atoms in fixed columns, lengths in ångström.
//!
//! The records `ATOM` and `HETATM` are read. Columns: name 13–16, alternate location 17, residue
//! 18–27, x 31–38, y 39–46, z 47–54, occupancy 55–60, element 77–78. Numbers of atoms and residues
//! are only compared, so hexadecimal, hybrid-36 and starred numbers are accepted. Only the first
//! model is read, and the alternate location with the highest occupancy in each residue.
//!
//! Source: wwPDB, Protein Data Bank contents guide, version 3.3.

use std::collections::{BTreeMap, BTreeSet};

use polhode::body::Severity;
use polhode_source::text::counted;
use polhode_source::{ContentError, ContentErrorKind};

use super::isotope::{Label, Species, label};
use super::line::{Field, Lines};
use super::{ANGSTROM, Builder, Element, Molecule};

/// Reads the first model of a PDB file.
///
/// ```
/// use polhode_shape::molecule::pdb;
/// let text = b"HETATM    1  C   CMO A   1       0.000   0.000   0.000  1.00  0.00           C
/// HETATM    2  O   CMO A   1       0.000   0.000   1.128  1.00  0.00           O
/// END\n";
/// assert_eq!(pdb::read(text)?.formula(), "CO");
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] without atoms, for shifted columns, or for an element that neither its columns
/// nor the name determine.
pub fn read(bytes: &[u8]) -> Result<Molecule, ContentError> {
    let (mut atoms, mut models, mut in_model, mut title) = (Vec::new(), 0_u64, false, String::new());
    for line in Lines::new(bytes) {
        match line.columns(0..6).bytes {
            b"ATOM" | b"HETATM" => {
                if !in_model {
                    models += 1;
                    in_model = true;
                }
                if models == 1 {
                    atoms.push(AtomLine::of(&line)?);
                }
            }
            b"MODEL" | b"ENDMDL" | b"END" => in_model = false,
            b"TITLE" if title.is_empty() => title = line.columns(10..80).text().into_owned(),
            b"HEADER" if title.is_empty() => title = line.columns(62..66).text().into_owned(),
            _ => {}
        }
    }
    let mut builder = Builder::default();
    if models > 1 {
        let message = format!("the file has {models} models; only the first one is read");
        builder.notice("molecule.models", Severity::Warning, message);
    }
    let all = atoms.len();
    let atoms = one_location(atoms);
    if atoms.len() < all {
        let message = format!(
            "{} atoms at alternate locations were ignored: in each residue, the location with the highest occupancy is used",
            all - atoms.len()
        );
        builder.notice("molecule.alternate_locations", Severity::Warning, message);
    }
    let mut deduced = 0;
    for atom in &atoms {
        let (species, from_name) = atom.species()?;
        deduced += usize::from(from_name);
        builder.push(species, atom.place, ANGSTROM)?;
    }
    if deduced > 0 {
        let atoms = counted(deduced, "atom");
        let message = format!("the element of {atoms} was inferred from the atom name");
        builder.notice("molecule.elements_deduced", Severity::Warning, message);
    }
    let has = |number: u8| builder.atoms.iter().any(|atom| atom.species.element().number() == number);
    if has(6) && !has(1) && atoms.iter().any(|atom| is_polymer(atom.residue)) {
        let message = "the file has no hydrogen atoms: the body lacks them".to_owned();
        builder.notice("molecule.no_hydrogen", Severity::Warning, message);
    }
    let missing = ContentErrorKind::missing("atoms (ATOM or HETATM)");
    builder.finish(&title, ANGSTROM).ok_or_else(|| missing.of_whole())
}

/// Fields of an atom record.
#[derive(Debug)]
struct AtomLine<'a> {
    /// Columns 13 to 16 with their blanks, which determine the position of the symbol.
    name: Field<'a>,
    location: Option<u8>,
    /// Name of the residue.
    residue: &'a [u8],
    /// Chain, residue number and insertion code.
    site: &'a [u8],
    place: [Field<'a>; 3],
    occupancy: f64,
    element: Field<'a>,
}

impl<'a> AtomLine<'a> {
    fn of(line: &Field<'a>) -> Result<Self, ContentError> {
        const HINT: &str = "x, y and z are in columns 31 to 38, 39 to 46 and 47 to 54";
        let place = [30..38, 38..46, 46..54].map(|columns| line.columns(columns));
        let hinted = |error: ContentError| if error.hint.is_none() { error.hint(HINT) } else { error };
        let gap = line.columns(27..30);
        for field in &place {
            field.number("a coordinate").map_err(hinted)?;
        }
        // A truncated z would also be a number.
        if line.bytes.len() < 54 {
            return Err(hinted(place[2].expected("z up to column 54")));
        }
        if !gap.bytes.is_empty() {
            return Err(hinted(gap.expected("blanks in columns 28 to 30")));
        }
        let location = line.bytes.get(16).copied().filter(|b| !b.is_ascii_whitespace());
        let occupancy = line.columns(54..60);
        let occupancy = match location {
            Some(_) if !occupancy.bytes.is_empty() => occupancy.number("the occupancy")?,
            _ => 1.0,
        };
        Ok(Self {
            name: Field { start: line.start + 12, bytes: line.bytes.get(12..16).unwrap_or_default() },
            location,
            residue: line.bytes.get(17..20).unwrap_or_default(),
            site: line.bytes.get(21..27).unwrap_or_default(),
            place,
            occupancy,
            element: line.columns(76..80),
        })
    }

    /// Returns the species, or `None` for a point without mass; true if it was derived from the
    /// name.
    fn species(&self) -> Result<(Option<Species>, bool), ContentError> {
        // A charge may follow the symbol: "O1-", "CL", "FE2+".
        let letters = self.element.bytes.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let symbol = String::from_utf8_lossy(&self.element.bytes[..letters.min(2)]);
        let charge = |b: &u8| b"+-".contains(b) || b.is_ascii_digit();
        if letters <= 2 && self.element.bytes[letters..].iter().all(charge) {
            match label(&symbol) {
                Some(Label::Atom(species)) => return Ok((Some(species), false)),
                Some(Label::Massless) => return Ok((None, false)),
                _ => {}
            }
        }
        let element = self.element_of_name().ok_or_else(|| {
            let error = self.name.trimmed().wrong("the atom's name", "a name that begins with the element");
            error.hint("write the element in columns 77 and 78")
        })?;
        Ok((Some(element), true))
    }

    /// Derives the element from the name. The symbol is right-justified in its first two columns,
    /// except for hydrogen names with four characters.
    fn element_of_name(&self) -> Option<Species> {
        let text = self.name.text();
        let letters = text.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' ');
        let one = |text: &str| match label(text.get(..1)?)? {
            Label::Atom(species) => Some(species),
            _ => None,
        };
        let in_place = text.as_bytes().first().is_some_and(u8::is_ascii_alphabetic);
        let hydrogen = text.starts_with(['H', 'D']) && text.trim_end().len() == 4;
        if !in_place || hydrogen || is_polymer(self.residue) {
            return one(letters);
        }
        let two = letters.get(..2).and_then(Element::from_symbol).map(Species::Element);
        two.or_else(|| one(letters))
    }
}

/// Returns true if a residue is an amino acid or nucleotide of a chain, or water. All their atoms
/// have symbols of one letter.
fn is_polymer(residue: &[u8]) -> bool {
    const NAMES: [&str; 30] = [
        "ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
        "PRO", "SER", "THR", "TRP", "TYR", "VAL", "A", "C", "G", "U", "DA", "DC", "DG", "DT", "I", "HOH",
    ];
    NAMES.iter().any(|name| name.as_bytes() == residue.trim_ascii())
}

/// Returns the atoms with one location each.
///
/// A residue keeps the location with the highest occupancy (the first if equal), and its atoms
/// without a location. For an atom that exists only at other locations, the best of these is kept.
fn one_location(atoms: Vec<AtomLine<'_>>) -> Vec<AtomLine<'_>> {
    // Map from site to location, occupancy and residue.
    let mut chosen: BTreeMap<&[u8], (u8, f64, &[u8])> = BTreeMap::new();
    for atom in &atoms {
        let Some(location) = atom.location else { continue };
        let best = chosen.entry(atom.site).or_insert((location, atom.occupancy, atom.residue));
        if atom.occupancy > best.1 {
            *best = (location, atom.occupancy, atom.residue);
        }
    }
    if chosen.is_empty() {
        return atoms;
    }
    let is_chosen = |atom: &AtomLine<'_>| {
        atom.location.is_none()
            || chosen.get(atom.site).is_some_and(|(location, ..)| Some(*location) == atom.location)
    };
    // Atoms by site and name: the selected ones, and the best of the others.
    let there: BTreeSet<_> =
        atoms.iter().filter(|atom| is_chosen(atom)).map(|atom| (atom.site, atom.name.bytes)).collect();
    let mut instead: BTreeMap<_, (usize, f64)> = BTreeMap::new();
    for (k, atom) in atoms.iter().enumerate() {
        let key = (atom.site, atom.name.bytes);
        let other_residue = chosen.get(atom.site).is_some_and(|(.., residue)| *residue != atom.residue);
        if is_chosen(atom) || there.contains(&key) || other_residue {
            continue;
        }
        let best = instead.entry(key).or_insert((k, atom.occupancy));
        if atom.occupancy > best.1 {
            *best = (k, atom.occupancy);
        }
    }
    let instead: BTreeSet<usize> = instead.values().map(|(k, _)| *k).collect();
    let keep: Vec<bool> =
        atoms.iter().enumerate().map(|(k, atom)| is_chosen(atom) || instead.contains(&k)).collect();
    atoms.into_iter().zip(keep).filter_map(|(atom, keep)| keep.then_some(atom)).collect()
}
