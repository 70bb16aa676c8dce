//! Quantities of a scenario that can be replaced: a number, a vector, a rotation, or mass
//! properties.

use std::ops::Range;

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode::motion::Scenario;
use polhode_source::FormatError;
use polhode_source::toml::reader::Value;
use polhode_source::toml::tree::{Entries, Kind, Known, Node, Step, Way};
use polhode_source::unit::Dimension;

use super::body::KnownPart;
use super::key::{Spot, mirrored};

/// Replaceable quantity of a scenario, identified by its key: a number, a vector, a rotation, or
/// mass properties.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Key as written in the file.
    pub key: String,
    /// Bytes of the key in the file.
    pub place: Range<usize>,
    pub(crate) varied: Varied,
    /// Parts of the body, from 0, to which it belongs; empty for the whole body.
    pub parts: Vec<usize>,
    /// Values as written, SI units.
    nominal: Vec<f64>,
    columns: Vec<TargetColumn>,
    dimension: Dimension,
    /// Places of all values of the file that it replaces.
    covered: Vec<usize>,
}

/// One number of a target, as a column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetColumn {
    /// Name from the key and the unit, such as `start_spin_body_x_rad_s`.
    pub name: String,
    /// SI unit, such as `rad/s`; empty if there is none.
    pub unit: String,
    /// Description of the number.
    pub description: String,
}

/// Destination of the values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Varied {
    /// Numbers of the file by their paths; an element of a symmetric matrix has two.
    Numbers(Vec<Vec<Way>>),
    /// Rotation of the file.
    Rotation(Way),
    /// Mass properties of the body or of a named part; components without values keep those given
    /// here.
    MassProperties(Way, String, MassProperties<Body>),
}

impl Target {
    /// Returns the key as written in the file.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// Returns the values as written, SI units, one for each column.
    pub fn nominal(&self) -> &[f64] {
        &self.nominal
    }

    /// Returns the columns.
    pub fn columns(&self) -> &[TargetColumn] {
        &self.columns
    }

    /// Returns the mass properties as written, if the target is mass properties.
    pub const fn mass_properties(&self) -> Option<&MassProperties<Body>> {
        match &self.varied {
            Varied::MassProperties(_, _, nominal) => Some(nominal),
            _ => None,
        }
    }

    /// Returns the dimension of its numbers; a plain number if they differ.
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Adds another number that always gets the same value.
    pub fn joined(mut self, other: Self, key: &Value<'_>) -> Result<Self, FormatError> {
        if self.overlaps(&other) {
            return Err(key.invalid("different from the numbers before it").with_hint("leave it out"));
        }
        if self.dimension != other.dimension {
            let rule = format!("{}, as {} is", self.dimension, self.key);
            return Err(key
                .invalid(rule)
                .with_hint("numbers that vary together must have the same dimension"));
        }
        if self.nominal != other.nominal {
            let hint = "numbers that vary together must have the same written value";
            let value = self.nominal.first().copied().unwrap_or_default();
            return Err(key.invalid(format!("equal to {}, {value}", self.key)).with_hint(hint));
        }
        if let (Varied::Numbers(mine), Varied::Numbers(theirs)) = (&mut self.varied, other.varied) {
            mine.iter_mut().zip(theirs).for_each(|(mine, theirs)| mine.extend(theirs));
        }
        self.covered.extend(other.covered);
        if let Some(column) = self.columns.first_mut() {
            column.description = format!("{}, and {}", column.description, other.key);
        }
        self.parts.extend(other.parts);
        Ok(self)
    }

    /// Adds another number that gets a value of its own.
    pub fn joined_with(mut self, other: Self, key: &Value<'_>) -> Result<Self, FormatError> {
        if self.overlaps(&other) {
            return Err(key.invalid("different from the numbers before it").with_hint("leave it out"));
        }
        let named = |name: &str| self.columns.iter().any(|column| column.name == name);
        if let Some(twice) = other.columns.iter().find(|column| named(&column.name)) {
            let error = key.invalid(format!("of another name: {} is a column already", twice.name));
            return Err(error.with_hint("a column's name has letters, digits and underscores"));
        }
        if let (Varied::Numbers(mine), Varied::Numbers(theirs)) = (&mut self.varied, other.varied) {
            mine.extend(theirs);
        }
        if self.dimension != other.dimension {
            self.dimension = Dimension::NONE;
        }
        self.key = format!("{}, {}", self.key, other.key);
        self.parts.extend(other.parts);
        self.nominal.extend(other.nominal);
        self.columns.extend(other.columns);
        self.covered.extend(other.covered);
        Ok(self)
    }

    /// Returns true if both targets contain the same number.
    pub fn overlaps(&self, other: &Self) -> bool {
        let is_made = |target: &Self| matches!(target.varied, Varied::MassProperties(..));
        match (is_made(self), is_made(other)) {
            (false, false) => self.covered.iter().any(|place| other.covered.contains(place)),
            // Dispersed mass properties replace those of a part, or of all parts together.
            (true, true) => self.parts.is_empty() || other.parts.is_empty() || self.parts == other.parts,
            (true, false) => other.parts.iter().any(|k| self.parts.is_empty() || self.parts.contains(k)),
            (false, true) => other.overlaps(self),
        }
    }
}

/// Returns the rest of the key of the first value inside a table or a list.
fn first_inside(kind: &Kind) -> String {
    match kind {
        Kind::Table(entries) => entries
            .iter()
            .next()
            .map_or(String::new(), |(key, entry)| format!(".{key}{}", first_inside(&entry.node.kind))),
        Kind::List(elements) => {
            format!("[0]{}", elements.first().map_or(String::new(), |first| first_inside(&first.kind)))
        }
        _ => String::new(),
    }
}

/// Values of a scenario for lookup by key.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Catalogue<'a> {
    pub entries: &'a Entries,
    pub nominal: &'a Scenario,
}

impl Catalogue<'_> {
    /// Returns the target of a single number.
    pub(crate) fn number(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        if let Kind::List(_) | Kind::Table(_) = spot.node.kind {
            let error = key.invalid("a single number of the scenario");
            let hint = format!("write key = \"{}{}\"", key.string()?, first_inside(&spot.node.kind));
            return Err(error.with_hint(hint));
        }
        let mut covered = spot.node.places();
        let mut ways = vec![spot.way];
        if let Some(mirrored) = mirrored(key.string()?) {
            let other =
                Spot::at(self.entries, &mirrored).map_err(|(rule, hint)| refused(key, &rule, hint))?;
            covered.extend(other.node.places());
            ways.push(other.way);
        }
        let number = Self::number_at(key, spot.node)?;
        Self::target(key, &[(number, ways)], spot.part, &[spot.words.join("_")], covered)
    }

    /// Returns the target of a vector.
    pub(crate) fn vector(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        let elements = match &spot.node.kind {
            Kind::List(elements) if elements.len() == 3 => elements,
            _ => {
                let error = key.invalid("an array of three numbers: only a vector has a direction");
                return Err(error.with_hint("write key = \"start.spin.body\""));
            }
        };
        let number = |(k, element): (usize, &std::sync::Arc<Node>)| {
            let way = spot.way.iter().cloned().chain([Step::Element(k)]).collect();
            Ok((Self::number_at(key, element)?, vec![way]))
        };
        let numbers: Vec<_> = elements.iter().enumerate().map(number).collect::<Result<_, _>>()?;
        let words = ["x", "y", "z"].map(|axis| format!("{}_{axis}", spot.words.join("_")));
        Self::target(key, &numbers, spot.part, &words, spot.node.places())
    }

    /// Creates a target of numbers, each with its paths and words.
    fn target(
        key: &Value<'_>,
        numbers: &[((f64, Dimension), Vec<Way>)],
        part: Option<usize>,
        words: &[String],
        covered: Vec<usize>,
    ) -> Result<Target, FormatError> {
        let written = key.string()?;
        let dimension = numbers.first().map_or(Dimension::NONE, |((_, dimension), _)| *dimension);
        let described = |words: &String| {
            let axis = words.rsplit('_').next().unwrap_or_default();
            let description = match numbers.len() {
                1 => written.to_owned(),
                _ => format!("{written}, {axis}"),
            };
            column(words, dimension, description)
        };
        Ok(Target {
            key: written.to_owned(),
            place: key.span(),
            parts: part.into_iter().collect(),
            nominal: numbers.iter().map(|((value, _), _)| *value).collect(),
            columns: words.iter().map(described).collect(),
            dimension,
            covered,
            varied: Varied::Numbers(numbers.iter().map(|(_, ways)| ways.clone()).collect()),
        })
    }

    /// Returns the target of a rotation: an attitude, or the orientation of a part.
    pub(crate) fn rotation(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        let Some(Known::Rotation(quaternion)) = spot.node.known.get() else {
            let error = key.invalid("a rotation of the scenario");
            return Err(error.with_hint("write key = \"start.attitude\", or \"body.part[0].rotate\""));
        };
        let words = spot.words.join("_");
        let written = key.string()?;
        let components = ["w", "x", "y", "z"];
        let columns = components.map(|c| {
            column(&format!("{words}_{c}"), Dimension::NONE, format!("{written}, {c} of its quaternion"))
        });
        Ok(Target {
            key: written.to_owned(),
            place: key.span(),
            varied: Varied::Rotation(spot.way),
            parts: spot.part.into_iter().collect(),
            nominal: quaternion.to_vec(),
            columns: columns.to_vec(),
            dimension: Dimension::NONE,
            covered: spot.node.places(),
        })
    }

    /// Returns the target of the mass properties of the body, `body`, or of a part, `body.part[0]`;
    /// with the suffix `.inertia`, of the tensor alone.
    pub(crate) fn mass_properties(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let written = key.string()?;
        let (whole, tensor_only) = match written.strip_suffix(".inertia") {
            Some(whole) => (whole, true),
            None => (written, false),
        };
        let (part, words, way, name, properties) = if whole == "body" {
            let way = ["body", "part"].map(|key| Step::Key(key.into())).to_vec();
            (None, "body".to_owned(), way, "body".to_owned(), *self.nominal.body())
        } else {
            let spot = Spot::at(self.entries, whole).map_err(|(rule, hint)| refused(key, &rule, hint))?;
            let one_part = matches!(spot.node.kind, Kind::Table(_)) && spot.words.len() == 3;
            match (spot.part, spot.node.known.get().and_then(Known::get::<KnownPart>)) {
                (Some(k), Some(known)) if one_part => {
                    let (part, _) = &*known;
                    (Some(k), spot.words.join("_"), spot.way, part.name.clone(), part.properties)
                }
                _ => {
                    let error = key.invalid("the body, a part of it, or the inertia of either");
                    let hint = "write key = \"body\", \"body.inertia\", \"body.part[0]\" or \"body.part[0].inertia\"";
                    return Err(error.with_hint(hint));
                }
            }
        };
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = properties.inertia().matrix();
        let mut nominal = vec![xx, yy, zz, xy, xz, yz];
        let of = |what: &str| format!("{whole}, {what}");
        let mut columns: Vec<_> = ["xx", "yy", "zz", "xy", "xz", "yz"]
            .map(|ij| {
                let description = of(&format!("I{ij} about the centre of mass, body axes"));
                column(&format!("{words}_inertia_{ij}"), Dimension::INERTIA, description)
            })
            .to_vec();
        if !tensor_only {
            let place = ["x", "y", "z"].map(|c| {
                let description = of(&format!("centre of mass, {c}"));
                column(&format!("{words}_center_of_mass_{c}"), Dimension::LENGTH, description)
            });
            let mass = column(&format!("{words}_mass"), Dimension::MASS, of("mass"));
            columns = [vec![mass], place.to_vec(), columns].concat();
            let center = properties.center_of_mass().to_array();
            nominal = [vec![properties.mass()], center.to_vec(), nominal].concat();
        }
        Ok(Target {
            key: written.to_owned(),
            place: key.span(),
            varied: Varied::MassProperties(way, name, properties),
            parts: part.into_iter().collect(),
            nominal,
            columns,
            dimension: Dimension::NONE,
            covered: Vec::new(),
        })
    }

    fn spot(&self, key: &Value<'_>) -> Result<Spot<'_>, FormatError> {
        Spot::at(self.entries, key.string()?).map_err(|(rule, hint)| refused(key, &rule, hint))
    }

    fn number_at(key: &Value<'_>, node: &Node) -> Result<(f64, Dimension), FormatError> {
        match node.known.get() {
            Some(Known::Number(value, dimension)) => Ok((*value, *dimension)),
            _ => Err(key
                .invalid("a number of the scenario: words, formulas and counts cannot vary")
                .with_hint("if it is a constant formula, write the number without quotes, in SI units")),
        }
    }
}

fn refused(key: &Value<'_>, rule: &str, hint: Option<String>) -> FormatError {
    let error = key.invalid(rule);
    match hint {
        Some(hint) => error.with_hint(hint),
        None => error,
    }
}

fn column(words: &str, dimension: Dimension, description: String) -> TargetColumn {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let (unit, suffix) = dimension.unit();
    let name: String = words.chars().map(letter).collect();
    let name = if suffix.is_empty() { name } else { format!("{name}_{suffix}") };
    TargetColumn { name, unit, description }
}
