//! XYZ: the number of atoms, a comment, and a line for each atom: symbol, x, y, z in ångström.
//!
//! A symbol may be an atomic number or an isotope (`13C`, `D`). Text after the coordinates is not
//! read. In extended XYZ the comment has `Properties=species:S:1:pos:R:3:…`, which defines the
//! columns; a column of masses is refused. Only the first frame is read. The number of atoms may be
//! followed by the unit `au` or `bohr`, as written by some programs.

use polhode::body::Severity;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::isotope::Species;
use super::line::{Field, Lines};
use super::{ANGSTROM, Builder, Element, Molecule};

/// Bohr radius, m (CODATA 2018).
const BOHR: f64 = 0.529_177_210_903e-10;

/// Reads the first frame of an XYZ file.
///
/// ```
/// use polhode_shape::molecule::{Species, xyz};
/// let text = b"2\nProperties=pos:R:3:charge:R:1:species:S:1\n0 0 0.6 -0.2 13C\n0 0 -0.53 0.2 O\n";
/// let molecule = xyz::read(text)?;
/// assert_eq!(molecule.formula(), "[13C]O");
/// assert_eq!(molecule.atoms[0].position_m, [0.0, 0.0, 0.6e-10]);
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for a count that does not agree with the lines, an unknown element, or a
/// coordinate that is not finite.
pub fn read(bytes: &[u8]) -> Result<Molecule, ContentError> {
    let mut lines = Lines::new(bytes);
    let whole = ContentErrorKind::of_whole;
    let first = lines.find(|line| !line.is_blank());
    let first = first.ok_or_else(|| whole(ContentErrorKind::missing("atoms")))?;
    let mut molecule = Builder::default();
    let (count, unit) = heading(&first, &mut molecule)?;
    let comment = lines.next().ok_or_else(|| lines.ended("the line of the comment"))?;
    let columns = Columns::of(&comment)?;
    if comment.text().contains("Lattice=") {
        let message =
            "the file has a lattice: the atoms of one cell are used at the given positions".to_owned();
        molecule.notice("molecule.lattice", Severity::Info, message);
    }
    for done in 0..count {
        let line = lines.next().filter(|line| !line.is_blank());
        let line = line.ok_or_else(|| count_error(&first, count, done))?;
        atom(&line, &columns, unit, &mut molecule)?;
    }
    let frames = 1 + more_frames(lines, &first, count, &columns)?;
    if frames > 1 {
        let message = format!("the file has {frames} frames; only the first one is read");
        molecule.notice("molecule.frames", Severity::Warning, message);
    }
    let name = if columns.extended { String::new() } else { comment.text().into_owned() };
    molecule.finish(&name, unit).ok_or_else(|| whole(ContentErrorKind::missing("atoms with a mass")))
}

/// Returns the number of atoms, and the unit of length in metres.
fn heading(line: &Field<'_>, molecule: &mut Builder) -> Result<(u64, f64), ContentError> {
    let mut words = line.words();
    let count = words.next().unwrap_or(line.trimmed());
    let count: u64 = count.integer("the number of atoms").map_err(|error| {
        error.hint("line 1 is the number of atoms, line 2 a comment; then the atoms follow")
    })?;
    let Some(word) = words.next() else { return Ok((count, ANGSTROM)) };
    match word.text().to_ascii_lowercase().as_str() {
        "au" | "a.u." | "bohr" => {
            let message = "the coordinates are in bohr, as stated on line 1".to_owned();
            molecule.notice("molecule.bohr", Severity::Info, message);
            Ok((count, BOHR))
        }
        "angstrom" | "ang" | "å" => Ok((count, ANGSTROM)),
        _ => {
            let message = "text after the number of atoms on line 1 was not read".to_owned();
            molecule.notice("molecule.heading", Severity::Info, message);
            Ok((count, ANGSTROM))
        }
    }
}

/// Columns of an atom line, counted from 0.
#[derive(Debug)]
struct Columns {
    species: usize,
    position: usize,
    extended: bool,
}

impl Columns {
    /// Parses the comment; without `Properties` the columns are those of plain XYZ.
    fn of(comment: &Field<'_>) -> Result<Self, ContentError> {
        const PLAIN: Columns = Columns { species: 0, position: 1, extended: false };
        let Some(word) = comment.words().find(|word| word.bytes.starts_with(b"Properties=")) else {
            return Ok(PLAIN);
        };
        let text = word.text();
        let list = text.trim_start_matches("Properties=").trim_matches(['"', '\'']);
        let rule = "triples of name, type and number of columns, such as species:S:1:pos:R:3";
        let wrong = || word.wrong("Properties", rule);
        let (mut species, mut number, mut position, mut at) = (None, None, None, 0_usize);
        let mut parts = list.split(':');
        while let Some(name) = parts.next() {
            let (Some(_), Some(width)) = (parts.next(), parts.next()) else { return Err(wrong()) };
            let width: usize = width.parse().map_err(|_| wrong())?;
            match (name, width) {
                ("species", 1) => species = Some(at),
                ("Z", 1) => number = Some(at),
                ("pos", 3) => position = Some(at),
                ("species" | "pos", _) => return Err(wrong()),
                // Such columns would replace the masses of the species.
                ("masses" | "mass" | "isotopes" | "isotope", _) => {
                    let what = format!("masses of individual atoms in the column {name}");
                    let place = ContentPlace::Text(word.span());
                    return Err(ContentError::new(ContentErrorKind::unsupported(what), place)
                        .hint("name isotopes by their symbols, such as 13C or D, and delete the column"));
                }
                _ => {}
            }
            at = at.saturating_add(width);
        }
        match (species.or(number), position) {
            (Some(species), Some(position)) => Ok(Self { species, position, extended: true }),
            _ => Err(word.wrong("Properties", "a list with species:S:1 and pos:R:3")),
        }
    }
}

fn atom(line: &Field<'_>, columns: &Columns, unit: f64, molecule: &mut Builder) -> Result<(), ContentError> {
    let end = line.start + line.bytes.len();
    let missing = Field { start: end, bytes: b"" };
    let word = |k: usize| line.words().nth(k).unwrap_or(missing);
    let symbol = word(columns.species);
    let species = match symbol.text().parse::<u8>() {
        Ok(0) => None,
        Ok(number) => {
            let element = Element::from_number(number);
            let element = element.ok_or_else(|| symbol.wrong("the atomic number", "from 1 to 118"))?;
            Some(Species::Element(element))
        }
        Err(_) => molecule.species(&symbol)?,
    };
    let place = [0, 1, 2].map(|k| word(columns.position.saturating_add(k)));
    molecule.push(species, place, unit).map_err(|error| {
        let numbered = symbol.bytes.iter().all(u8::is_ascii_digit);
        match super::label(&place[0].text()) {
            Some(_) if numbered && error.hint.is_none() => {
                error.hint("a line is: symbol x y z; a number before the symbol indicates Tinker's format")
            }
            _ => error,
        }
    })
}

/// Returns the number of further frames, complete or not; other text is an error.
fn more_frames(
    mut lines: Lines<'_>,
    first: &Field<'_>,
    count: u64,
    columns: &Columns,
) -> Result<u64, ContentError> {
    let mut frames = 0;
    while let Some(line) = lines.find(|line| !line.is_blank()) {
        let mut words = line.words();
        let next: Option<u64> = words.next().and_then(|word| word.integer("").ok());
        // An undeclared atom may begin with its atomic number.
        let is_atom = atom(&line, columns, ANGSTROM, &mut Builder::default()).is_ok();
        match next.filter(|_| !is_atom) {
            Some(next) => {
                frames += 1;
                // Skip the comment, and the declared number of lines.
                let skipped = usize::try_from(next).unwrap_or(usize::MAX);
                lines.nth(skipped);
            }
            None if is_atom && frames == 0 => {
                let is_atom =
                    |line: &Field<'_>| atom(line, columns, ANGSTROM, &mut Builder::default()).is_ok();
                let more = lines.take_while(is_atom).count() as u64;
                return Err(count_error(first, count, count + 1 + more));
            }
            None => return Err(line.trimmed().expected("the number of atoms of another frame, or the end")),
        }
    }
    Ok(frames)
}

fn count_error(first: &Field<'_>, declared: u64, present: u64) -> ContentError {
    let kind = ContentErrorKind::count("atoms", declared, present);
    let place = first.words().next().unwrap_or(*first).span();
    kind.at(place).hint(if declared > present {
        "correct the number, or the file is truncated (no blank lines between atoms)"
    } else {
        "correct the number"
    })
}
