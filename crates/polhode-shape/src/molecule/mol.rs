//! MDL connection tables V2000 and V3000: one in a MOL file, several with data in an SDF. Lengths
//! are in ångström.
//!
//! Isotopes are given by `M  ISO` lines and `MASS=`; without any `M  ISO`, by the differences in
//! columns 35 and 36. Bonds are used only to detect a wrong number of atoms, and hydrogen atoms
//! that are implied but omitted.
//!
//! Source: CTfile Formats, BIOVIA, 2020.

use std::collections::BTreeMap;

use polhode::body::Severity;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::isotope::{Isotope, Species};
use super::line::{Field, Lines};
use super::{ANGSTROM, Builder, Element, Molecule, unknown_element, unknown_isotope};

/// Reads all molecules of a MOL file or an SDF.
///
/// ```
/// use polhode_shape::molecule::mol;
/// let text = b"carbon monoxide\n  by hand\n\n  2  1  0  0  0  0  0  0  0  0999 V2000
///     0.0000    0.0000    0.0000 C   0  0\n    0.0000    0.0000    1.1282 O   0  0
///   1  2  3\nM  ISO  1   1  13\nM  END\n";
/// let molecules = mol::read(text)?;
/// assert_eq!((molecules[0].name.as_str(), molecules[0].formula().as_str()), ("carbon monoxide", "[13C]O"));
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for a count that does not agree with the lines, shifted columns, or an unknown
/// element or isotope.
pub fn read(bytes: &[u8]) -> Result<Vec<Molecule>, ContentError> {
    let mut lines = Lines::new(bytes);
    let mut molecules = Vec::new();
    // Blank lines may be the header of a molecule without a name, or follow the last molecule.
    while lines.clone().any(|line| !line.is_blank()) {
        molecules.push(table(&mut lines)?);
        // Skip the data up to the separator.
        lines.find(|line| line.bytes.starts_with(b"$$$$"));
    }
    if molecules.is_empty() {
        return Err(ContentErrorKind::missing("molecule").of_whole());
    }
    Ok(molecules)
}

/// Reads one connection table.
fn table(lines: &mut Lines<'_>) -> Result<Molecule, ContentError> {
    let mut next = |what: &str| lines.next().ok_or_else(|| lines.ended(what));
    let name = next("the line of the name")?;
    let unsupported = |what: &str| Err(ContentErrorKind::unsupported(what).at(name.trimmed().span()));
    match name.bytes {
        [b'<', ..] => return unsupported("XML as a connection table (the SDF of a robot is another format)"),
        [b'$', b'R', b'X', b'N' | b'D', ..] => return unsupported("reactions"),
        [b'$', b'M', b'D', b'L', ..] => return unsupported("RG files"),
        _ => {}
    }
    let program = next("the line of the program")?;
    next("the line of the comment")?;
    let counts = next("the line of the counts")?;
    let mut builder = Builder::default();
    if program.columns(20..22).bytes == b"2D" {
        let message =
            "the file is marked 2D: the coordinates are those of a drawing, not of the molecule".to_owned();
        builder.notice("molecule.drawing", Severity::Warning, message);
    }
    match counts.columns(33..39).bytes {
        b"V3000" => v3000(lines, &mut builder)?,
        version @ (b"V2000" | b"") => v2000(lines, &counts, version.is_empty(), &mut builder)?,
        _ => {
            let kind = ContentErrorKind::expected(
                "V2000 or V3000 in columns 35 to 39",
                counts.columns(33..39).text().into_owned(),
            );
            let error = kind.at(counts.columns(33..39).span());
            return Err(error.hint("the counts are on line 4, after three lines that may be blank"));
        }
    }
    let place = ContentPlace::Text(counts.span());
    let missing = ContentErrorKind::missing("atoms with a mass in this molecule");
    builder.finish(&name.text(), ANGSTROM).ok_or_else(|| ContentError::new(missing, place))
}

/// Reads the rest of a V2000 table. Older tables (`old`) have no end line.
fn v2000(
    lines: &mut Lines<'_>,
    counts: &Field<'_>,
    old: bool,
    builder: &mut Builder,
) -> Result<(), ContentError> {
    const LINE_4: &str = "the counts are on line 4, after three lines that may be blank";
    let atom_count = counts.columns(0..3);
    let bond_count = counts.columns(3..6);
    let n: usize = atom_count.integer("the number of atoms").map_err(|e| e.hint(LINE_4))?;
    let bonds: usize = bond_count.integer("the number of bonds").map_err(|e| e.hint(LINE_4))?;
    let mut atoms = Vec::new();
    for done in 0..n {
        let line = lines.next().ok_or_else(|| count_error(&atom_count, "atoms", n, done))?;
        atoms.push(atom_line(&line)?);
    }
    // Twice the sum of the bond orders, for each atom.
    let mut valence = vec![0_u32; n];
    for done in 0..bonds {
        let line = lines.next().ok_or_else(|| count_error(&bond_count, "bonds", bonds, done))?;
        let order = match line.columns(6..9).bytes {
            b"2" => 4,
            b"3" => 6,
            b"4" => 3, // aromatic
            _ => 2,
        };
        for columns in [0..3, 3..6] {
            let index: Option<usize> = line.columns(columns).integer("").ok();
            let slot = index.and_then(|k| valence.get_mut(k.checked_sub(1)?));
            slot.into_iter().for_each(|sum| *sum += order);
            if index.is_none_or(|k| k == 0 || k > n) {
                let hint = if atom_line(&line).is_ok() {
                    "this is one atom more than the number in columns 1 to 3 of the counts"
                } else {
                    "a bond has the numbers of two atoms in columns 1 to 3 and 4 to 6"
                };
                return Err(line.trimmed().expected("a bond").hint(hint));
            }
        }
    }
    let Properties { isotopes, abbreviations } = properties(lines, n, old)?;
    if abbreviations > 0 {
        let message = format!(
            "{abbreviations} atoms have an abbreviation, such as Ph, next to their symbol: each counts as one atom"
        );
        builder.notice("molecule.abbreviations", Severity::Warning, message);
    }
    for (k, (symbol, difference, place)) in atoms.iter().enumerate() {
        let named = isotopes.as_ref().and_then(|named| named.get(&k));
        let species = match (builder.species(symbol)?, named) {
            (Some(species), Some((number, field))) if *number != 0 => {
                let element = species.element();
                let found = Species::with_mass_number(element, Some(*number));
                Some(found.ok_or_else(|| unknown_isotope(field, element))?)
            }
            (Some(species), None) if isotopes.is_none() => Some(shifted(species, difference, builder)?),
            (species, _) => species,
        };
        builder.push(species, *place, ANGSTROM)?;
    }
    no_hydrogen(&atoms, &valence, builder);
    Ok(())
}

/// Reports missing hydrogen atoms. Tables may omit them if valence implies them, and the body is
/// then too light.
fn no_hydrogen(atoms: &[AtomLine<'_>], valence: &[u32], builder: &mut Builder) {
    const FOUR_BONDS: u32 = 8;
    let number = |atom: &super::Atom| atom.species.element().number();
    let open = |((symbol, ..), sum): (&AtomLine<'_>, &u32)| symbol.bytes == b"C" && *sum < FOUR_BONDS;
    let any = atoms.iter().zip(valence).any(open);
    if any && atoms.len() > 2 && !builder.atoms.iter().any(|atom| number(atom) == 1) {
        let message =
            "the file has no hydrogen atoms, but carbon with free valences: the body lacks the hydrogen";
        builder.notice("molecule.no_hydrogen", Severity::Warning, message.to_owned());
    }
}

/// Symbol, mass difference and position of a V2000 atom.
type AtomLine<'a> = (Field<'a>, Field<'a>, [Field<'a>; 3]);

fn atom_line<'a>(line: &Field<'a>) -> Result<AtomLine<'a>, ContentError> {
    let place = [0..10, 10..20, 20..30].map(|columns| line.columns(columns));
    let gap = line.columns(30..31);
    let numbers = place.iter().try_for_each(|field| field.number("a coordinate").map(|_| ()));
    let numbers = match numbers {
        Ok(()) if !gap.bytes.is_empty() => Err(gap.expected("a blank in column 31")),
        other => other,
    };
    numbers.map_err(|error| match error.hint {
        None => {
            error.hint("x, y and z are in columns 1 to 10, 11 to 20 and 21 to 30, the symbol in 32 to 34")
        }
        Some(_) => error,
    })?;
    Ok((line.columns(31..34), line.columns(34..36), place))
}

/// Applies the mass difference of an atom line, relative to the rounded standard atomic weight.
fn shifted(species: Species, difference: &Field<'_>, builder: &mut Builder) -> Result<Species, ContentError> {
    if difference.bytes.is_empty() || matches!(species, Species::Isotope(_)) {
        return Ok(species);
    }
    let element = species.element();
    let shift: i16 = difference.integer("the mass difference")?;
    if shift == 0 {
        return Ok(species);
    }
    let first = Isotope::first(element).mass_number();
    let base = element.weight().map_or(first, |weight| weight.round() as u16);
    if base != first {
        let message = format!(
            "the mass difference {shift} of {element} is relative to {base}, the rounded atomic weight; \
             the most abundant isotope is {first}{element}"
        );
        builder.notice("molecule.mass_difference", Severity::Warning, message);
    }
    let number = base.checked_add_signed(shift);
    let found = number.and_then(|number| Species::with_mass_number(element, Some(number)));
    found.ok_or_else(|| unknown_isotope(difference, element))
}

/// Mass number of the last `M  ISO` entry and its position, by atom index from 0.
type Named<'a> = BTreeMap<usize, (u16, Field<'a>)>;

/// Contents of a V2000 property block.
struct Properties<'a> {
    /// Isotopes; `None` without an `M  ISO` line.
    isotopes: Option<Named<'a>>,
    /// Number of atoms that represent an abbreviated group.
    abbreviations: usize,
}

/// Reads a V2000 property block.
fn properties<'a>(lines: &mut Lines<'a>, atoms: usize, old: bool) -> Result<Properties<'a>, ContentError> {
    let mut isotopes: Option<Named<'a>> = None;
    let mut abbreviations = 0;
    loop {
        let before = lines.clone();
        let line = match lines.next() {
            Some(line) if !line.bytes.starts_with(b"$$$$") => line,
            _ if old => {
                *lines = before;
                return Ok(Properties { isotopes, abbreviations });
            }
            Some(line) => return Err(line.expected("M  END")),
            None => return Err(lines.ended("M  END")),
        };
        match line.bytes {
            [b'M', b' ', b' ', b'E', b'N', b'D', ..] => return Ok(Properties { isotopes, abbreviations }),
            [b'M', b' ', b' ', b'I', b'S', b'O', ..] => {
                let named = isotopes.get_or_insert_default();
                let count: usize = line.columns(6..9).integer("the number of isotopes")?;
                for k in 0..count.min(line.bytes.len()) {
                    let atom = line.columns(9 + 8 * k..13 + 8 * k);
                    let number = line.columns(13 + 8 * k..17 + 8 * k);
                    let index: usize = atom.integer("the number of an atom")?;
                    let at = index.checked_sub(1).filter(|at| *at < atoms);
                    let at = at.ok_or_else(|| {
                        let index = i64::try_from(index).unwrap_or(i64::MAX);
                        ContentErrorKind::index("atom", index, atoms).at(atom.span())
                    })?;
                    named.insert(at, (number.integer("a mass number")?, number));
                }
            }
            // The text of an abbreviation is on the next line.
            [b'A' | b'G', b' ', b' ', ..] => {
                abbreviations += 1;
                lines.next();
            }
            _ => {}
        }
    }
}

/// Reads the rest of a V3000 table.
fn v3000(lines: &mut Lines<'_>, builder: &mut Builder) -> Result<(), ContentError> {
    let mut declared: Option<(Field<'_>, usize)> = None;
    let (mut in_atoms, mut present, mut done) = (false, 0, false);
    loop {
        let line = lines.next().ok_or_else(|| lines.ended("M  END"))?;
        if line.bytes.starts_with(b"M  END") {
            break;
        }
        if line.bytes.starts_with(b"$$$$") {
            return Err(line.expected("M  END"));
        }
        let Some(words) = v3000_words(&line, lines)? else { continue };
        let text = |k: usize| words.get(k).map(Field::text).unwrap_or_default();
        match (text(0).as_ref(), text(1).as_ref()) {
            // Only the first table is the molecule; templates may follow.
            ("END", "CTAB") => done = true,
            _ if done => {}
            ("COUNTS", _) => {
                let count = words.get(1).copied().unwrap_or(line);
                declared = Some((count, count.integer("the number of atoms")?));
            }
            ("BEGIN", "ATOM") => in_atoms = true,
            ("END", "ATOM") => in_atoms = false,
            _ if in_atoms => {
                present += 1;
                v3000_atom(&line, &words, builder)?;
            }
            _ => {}
        }
    }
    match declared {
        Some((_, count)) if count == present => Ok(()),
        Some((field, count)) => Err(count_error(&field, "atoms", count, present)),
        None => Err(lines.ended("M  V30 COUNTS")),
    }
}

/// Parses `index type x y z aamap [KEY=value …]`.
fn v3000_atom(line: &Field<'_>, words: &[Field<'_>], builder: &mut Builder) -> Result<(), ContentError> {
    let &[_, symbol, x, y, z, ..] = words else {
        return Err(line.trimmed().expected("an atom: index, type, x, y, z"));
    };
    let mass = words.iter().find_map(|word| {
        let bytes = word.bytes.strip_prefix(b"MASS=")?;
        Some(Field { start: word.start + 5, bytes })
    });
    let species = match (builder.species(&symbol)?, mass) {
        (Some(species), Some(mass)) => {
            let element: Element = species.element();
            let value = mass.number("the mass")?;
            // 0 means the natural mixture. A value with decimals is the mass of an isotope.
            let near = (value - value.round()).abs() < 0.25 && (0.0..1000.0).contains(&value);
            let number = value.round() as u16;
            match number {
                0 if near => Some(species),
                _ => {
                    let found = Species::with_mass_number(element, Some(number).filter(|_| near));
                    let found = found.filter(|_| near);
                    Some(found.ok_or_else(|| unknown_isotope(&mass, element))?)
                }
            }
        }
        (species, _) => species,
    };
    if symbol.bytes.contains(&b'[') && species.is_none() {
        return Err(unknown_element(&symbol));
    }
    builder.push(species, [x, y, z], ANGSTROM)
}

/// Returns the words after `M  V30`, including continuation lines after a `-`; `None` for other
/// lines.
fn v3000_words<'a>(line: &Field<'a>, lines: &mut Lines<'a>) -> Result<Option<Vec<Field<'a>>>, ContentError> {
    const PREFIX: &[u8] = b"M  V30 ";
    let Some(mut rest) = line.bytes.strip_prefix(PREFIX) else { return Ok(None) };
    let (mut start, mut words) = (line.start + PREFIX.len(), Vec::new());
    loop {
        let continued = rest.trim_ascii_end().strip_suffix(b"-");
        words.extend(Field { start, bytes: continued.unwrap_or(rest) }.words());
        if continued.is_none() {
            return Ok(Some(words));
        }
        let next = lines.next().ok_or_else(|| lines.ended("the continuation of the line"))?;
        let Some(more) = next.bytes.strip_prefix(PREFIX) else {
            return Err(next.expected("M  V30, because the previous line ends in -"));
        };
        (rest, start) = (more, next.start + PREFIX.len());
    }
}

fn count_error(place: &Field<'_>, what: &str, declared: usize, present: usize) -> ContentError {
    let (declared, present) = (declared as u64, present as u64);
    let error = ContentErrorKind::count(what, declared, present).at(place.span());
    if declared > present { error.hint("correct the number, or the file is truncated") } else { error }
}
