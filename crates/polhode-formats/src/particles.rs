//! Particles and point clouds, as CSV.
//!
//! The header names the columns, with their units: `mass_kg,x_m,y_m,z_m`, or `mass [g]; x [mm]; y [mm]; z
//! [mm]`. Fields are separated by semicolons, tabs, commas or spaces, whichever of these comes first in this
//! list and stands in the first line; with semicolons or tabs the decimal mark may be a comma. Thousands are
//! not separated. Blank lines and what follows a `#` are for people, but a comment line right above the
//! numbers may be the header, as NumPy writes it.
//!
//! Units are read and not guessed: a column without one, or a file without a header, needs
//! [`ParticleOptions`].

mod fields;

use std::ops::Range;

use polhode::{Body, Finding, Particle, Position, Severity};

use crate::content::{ContentError, ContentErrorKind, ContentPlace, told_unit};
use crate::text::{cut, escaped};
use crate::unit::{self, Dimension};
use fields::{Lines, Separator, fields, line_at, number, text_of};

/// What a file may leave open; by default nothing is answered.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ParticleOptions {
    /// Kilograms in the unit of mass, where the header names none.
    pub mass_unit: Option<f64>,
    /// Metres in the unit of length, where the header names none.
    pub length_unit: Option<f64>,
    /// Mass of the whole, kg, shared equally by points without masses.
    pub total_mass: Option<f64>,
}

/// A file of particles that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct ParticleFile {
    /// At least one, in the order of the file, in SI.
    pub particles: Vec<Particle<Body>>,
    /// What was decided on the way.
    pub findings: Vec<Finding>,
}

/// Reads particles from the bytes of a file.
///
/// A value is the nearest double to the number times its unit where the unit is a power of ten, and within
/// one unit in the last place elsewhere.
///
/// ```
/// use polhode_formats::particles::{self, ParticleOptions};
/// let file = b"name; mass [g]; x [mm]; y [mm]; z [mm]\nA; 1,5; 10; -20,5; 3\nB; 2; 0; 4; -7\n";
/// let read = particles::read(file, &ParticleOptions::default())?;
/// assert_eq!(read.particles[0].mass(), 0.0015);
/// assert_eq!(read.particles[0].position().to_array(), [0.01, -0.0205, 0.003]);
///
/// let cloud = ParticleOptions { total_mass: Some(3.0), ..ParticleOptions::default() };
/// let read = particles::read(b"x_m,y_m,z_m\n1,2,3\n-1,0,2\n", &cloud)?;
/// assert_eq!(read.particles[1].mass(), 1.5);
/// # Ok::<(), polhode_formats::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] with its place if a column or a unit is missing, a line has more or fewer fields than the
/// first, a field is no finite number, or a mass is not positive.
pub fn read(bytes: &[u8], options: &ParticleOptions) -> Result<ParticleFile, ContentError> {
    told_unit("the unit of mass", options.mass_unit)?;
    told_unit("the unit of length", options.length_unit)?;
    let start = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let mut findings = Vec::new();
    let (table, data) = Table::of(bytes, start, options, &mut findings)?;
    let mut particles = Vec::new();
    let mut add = |line: Range<usize>, mass: f64, [x, y, z]: [f64; 3]| {
        let particle = Particle::new(mass, Position::new(x, y, z));
        particles.push(particle.map_err(|error| {
            ContentError::new(ContentErrorKind::Body(Box::new(error)), ContentPlace::Text(line))
        })?);
        Ok(())
    };
    match (table.roles.contains(&Some(MASS)), options.total_mass) {
        (true, None) => table.each_point(bytes, data, |line, [mass, place @ ..]| add(line, mass, place))?,
        (false, Some(total)) => {
            let mut points = Vec::new();
            table.each_point(bytes, data, |line, [_, place @ ..]| {
                points.push((line.start, place));
                Ok(())
            })?;
            let share = total / points.len() as f64;
            let message = format!("{} points without masses share {total} kg equally", points.len());
            findings.push(finding("particles.equal-masses", message));
            points.into_iter().try_for_each(|(line, place)| add(line..line, share, place))?;
        }
        (true, Some(total)) => {
            let rule = "left out, as the file has a column of masses".to_owned();
            return Err(value("the total mass", total.to_string(), rule, ContentPlace::Whole));
        }
        (false, None) => {
            let hint =
                "add a column mass_kg, or give the mass of the whole, which the points then share equally";
            return Err(missing("column of masses", hint));
        }
    }
    if particles.is_empty() {
        return Err(missing("lines of numbers", "a line is a mass and a place, such as 1.5,0,0.2,-3"));
    }
    Ok(ParticleFile { particles, findings })
}

/// The four numbers of a particle, in this order wherever four numbers stand.
const NAMES: [&str; 4] = ["mass", "x", "y", "z"];
const MASS: usize = 0;

/// How the lines of a file are built.
struct Table {
    separator: Separator,
    /// Which of the four numbers each column is, if any.
    roles: Vec<Option<usize>>,
    scales: [Scale; 4],
}

impl Table {
    /// The table that the header describes, and where its numbers begin.
    fn of(
        bytes: &[u8],
        start: usize,
        options: &ParticleOptions,
        findings: &mut Vec<Finding>,
    ) -> Result<(Self, usize), ContentError> {
        let (mut at, mut comment) = (start, None);
        while let Some((line, next)) = line_at(bytes, at) {
            if bytes[line.clone()].starts_with(b"#") {
                comment = Some(line.start + 1);
            } else if !line.is_empty() {
                let separator = Separator::of(&bytes[line.clone()]);
                let first = fields(bytes, at, separator)?;
                if first.iter().any(|field| number(&bytes[field.clone()], separator).is_none()) {
                    return Ok((Self::named(bytes, &first, separator, options, findings)?, next));
                }
                // NumPy's header is a comment.
                if let Some(comment) = comment {
                    let header = fields(bytes, comment, separator).unwrap_or_default();
                    let roles: Vec<_> = header.iter().filter_map(|f| column(bytes, f).role).collect();
                    if header.len() == first.len() && (1..4).all(|k| roles.contains(&k)) {
                        return Ok((Self::named(bytes, &header, separator, options, findings)?, at));
                    }
                }
                return Ok((Self::nameless(&line, first.len(), separator, options, findings)?, at));
            }
            at = next;
        }
        Err(missing("lines", "write a header such as mass_kg,x_m,y_m,z_m and a line for each particle"))
    }

    fn named(
        bytes: &[u8],
        header: &[Range<usize>],
        separator: Separator,
        options: &ParticleOptions,
        findings: &mut Vec<Finding>,
    ) -> Result<Self, ContentError> {
        let mut scales = [None; 4];
        let (mut roles, mut ignored) = (Vec::new(), Vec::new());
        for field in header {
            let Column { role, unit, name } = column(bytes, field);
            roles.push(role);
            let Some(role) = role else {
                ignored.push(cut(&escaped(&name)));
                continue;
            };
            let error = |kind| ContentError::new(kind, ContentPlace::Text(field.clone()));
            let told = if role == MASS { options.mass_unit } else { options.length_unit };
            let dimension = if role == MASS { Dimension::MASS } else { Dimension::LENGTH };
            let factor = match unit {
                Some(unit) => unit::factor(&unit, dimension).map_err(|wrong| {
                    let what = format!("the unit of {}", NAMES[role]);
                    let rule = format!("a unit that polhode knows: {wrong}");
                    let hinted = error(ContentErrorKind::Value { what, value: unit, rule });
                    match wrong.hint() {
                        Some(hint) => hinted.hint(hint),
                        None => hinted,
                    }
                })?,
                None => told.ok_or_else(|| {
                    let question = format!("in which unit is {}?", NAMES[role]);
                    let hint = ["mass_kg", "x_m", "y_m", "z_m"][role];
                    error(ContentErrorKind::Unclear { question, found: String::new() })
                        .hint(format!("name the unit in the header, such as {hint}, or answer with --unit"))
                })?,
            };
            if scales[role].replace(Scale::by(factor)).is_some() {
                let rule = "named once".to_owned();
                let what = "the column".to_owned();
                return Err(error(ContentErrorKind::Value { what, value: NAMES[role].to_owned(), rule }));
            }
        }
        for k in 1..4 {
            if scales[k].is_none() {
                let hint = "the header has to name x, y and z with their units, such as x_m,y_m,z_m";
                return Err(missing(&format!("column {}", NAMES[k]), hint));
            }
        }
        if !ignored.is_empty() {
            let message = format!("columns not read: {}", ignored.join(", "));
            findings.push(finding("particles.ignored-columns", message));
        }
        Ok(Self { separator, roles, scales: scales.map(|scale| scale.unwrap_or(Scale::Times(1.0))) })
    }

    /// A file of numbers only: three columns are places, four are masses and places.
    fn nameless(
        line: &Range<usize>,
        columns: usize,
        separator: Separator,
        options: &ParticleOptions,
        findings: &mut Vec<Finding>,
    ) -> Result<Self, ContentError> {
        let error = |kind| ContentError::new(kind, ContentPlace::Text(line.clone()));
        let first = match columns {
            3 => 1,
            4 => MASS,
            _ => {
                let rule = "x, y, z or mass, x, y, z in a file without a header".to_owned();
                let kind = ContentErrorKind::Value {
                    what: "the number of columns".to_owned(),
                    value: columns.to_string(),
                    rule,
                };
                return Err(error(kind).hint("add a header, such as mass_kg,x_m,y_m,z_m"));
            }
        };
        let unclear = |what: &str| {
            let question = format!("in which unit is the {what}? There is no header.");
            error(ContentErrorKind::Unclear { question, found: String::new() })
                .hint("add a header, such as mass_kg,x_m,y_m,z_m, or answer with --unit")
        };
        let length = Scale::by(options.length_unit.ok_or_else(|| unclear("length"))?);
        let mass = match (first, options.mass_unit) {
            (MASS, None) => return Err(unclear("mass")),
            (_, unit) => Scale::by(unit.unwrap_or(1.0)),
        };
        let message = format!("there is no header: the columns were read as {}", NAMES[first..].join(", "));
        findings.push(finding("particles.no-header", message));
        let roles = (first..4).map(Some).collect();
        Ok(Self { separator, roles, scales: [mass, length, length, length] })
    }

    /// Calls `visit` with every line from byte `at` on, and its mass, x, y, z; without a column of masses
    /// that is 0.
    fn each_point(
        &self,
        bytes: &[u8],
        at: usize,
        mut visit: impl FnMut(Range<usize>, [f64; 4]) -> Result<(), ContentError>,
    ) -> Result<(), ContentError> {
        let (mut lines, mut mark) = (Lines::new(bytes, at, self.separator), None);
        loop {
            let (mut point, mut count) = ([0.0; 4], 0);
            let line = lines.each_field(|field| {
                if let Some(Some(role)) = self.roles.get(count) {
                    point[*role] = self.scales[*role].apply(self.number(bytes, &field, *role, &mut mark)?);
                }
                count += 1;
                Ok(())
            })?;
            match line {
                None => return Ok(()),
                Some(_) if count == 0 => {}
                Some(line) if count == self.roles.len() => visit(line, point)?,
                Some(line) => {
                    let rule =
                        format!("{} fields long, as the first line is; it has {count}", self.roles.len());
                    return Err(value("the line", text_of(bytes, &line), rule, ContentPlace::Text(line)));
                }
            }
        }
    }

    /// A finite number with the decimal mark of those before it.
    fn number(
        &self,
        bytes: &[u8],
        field: &Range<usize>,
        role: usize,
        mark: &mut Option<u8>,
    ) -> Result<f64, ContentError> {
        let (number, found) =
            number(&bytes[field.clone()], self.separator).ok_or_else(|| not_a_number(bytes, field))?;
        if found.is_some() && mark.is_some() && *mark != found {
            let hint = "the file has decimal points and decimal commas; it needs one of them throughout";
            return Err(not_a_number(bytes, field).hint(hint));
        }
        *mark = mark.or(found);
        if !number.is_finite() {
            let kind =
                ContentErrorKind::NotFinite { what: NAMES[role].to_owned(), found: text_of(bytes, field) };
            return Err(ContentError::new(kind, ContentPlace::Text(field.clone())));
        }
        Ok(number)
    }
}

/// A unit's value, so that powers of ten below one are divided by and round once only.
#[derive(Clone, Copy, Debug)]
enum Scale {
    Times(f64),
    Over(f64),
}

impl Scale {
    fn by(factor: f64) -> Self {
        let inverse = (1.0 / factor).round();
        let exact = factor < 1.0 && 1.0 / inverse == factor;
        if exact { Self::Over(inverse) } else { Self::Times(factor) }
    }

    fn apply(self, value: f64) -> f64 {
        match self {
            Self::Times(factor) => value * factor,
            Self::Over(inverse) => value / inverse,
        }
    }
}

/// A column by its header.
struct Column {
    role: Option<usize>,
    unit: Option<String>,
    name: String,
}

/// `x_mm`, `x [mm]`, `x (mm)` or `x`; anything else is a column that is not read.
fn column(bytes: &[u8], field: &Range<usize>) -> Column {
    let whole = text_of(bytes, field);
    let name = whole.trim_matches('"').trim();
    let (base, unit) = match name.split_once(['[', '(']) {
        Some((base, unit)) => (base, Some(unit.trim_end_matches([']', ')']))),
        None => name.split_once(['_', ' ']).map_or((name, None), |(base, unit)| (base, Some(unit))),
    };
    let role = match base.trim().trim_end_matches('_').to_ascii_lowercase().as_str() {
        "mass" | "m" => Some(0),
        "x" => Some(1),
        "y" => Some(2),
        "z" => Some(3),
        _ => None,
    };
    let unit = unit.map(|unit| unit.trim().to_owned()).filter(|unit| !unit.is_empty());
    Column { role, unit, name: name.to_owned() }
}

fn not_a_number(bytes: &[u8], field: &Range<usize>) -> ContentError {
    let found = if field.is_empty() { "nothing".to_owned() } else { text_of(bytes, field) };
    let kind = ContentErrorKind::Expected { what: "a number".to_owned(), found };
    ContentError::new(kind, ContentPlace::Text(field.clone()))
}

fn value(what: &str, value: String, rule: String, place: ContentPlace) -> ContentError {
    ContentError::new(ContentErrorKind::Value { what: what.to_owned(), value, rule }, place)
}

fn missing(what: &str, hint: &str) -> ContentError {
    ContentError::new(ContentErrorKind::Missing { what: what.to_owned() }, ContentPlace::Whole).hint(hint)
}

fn finding(code: &'static str, message: String) -> Finding {
    Finding { code, severity: Severity::Info, message, place: None }
}
