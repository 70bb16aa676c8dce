//! What can differ from reading to reading: a number of a scenario, three that are a vector, a rotation, mass properties.

use std::ops::Range;

use polhode::{Body, MassProperties, Scenario};

use super::again::{Found, Number};
use super::reader::Value;
use super::suggestion::nearest;
use super::tree::{Entries, Kind, Node};
use crate::error::FormatError;
use crate::unit::Dimension;

/// What can differ from reading to reading, by its key: a number, three that are a vector, a rotation, mass properties.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Its key, as the file has it.
    pub(crate) key: String,
    /// Where the key stands.
    pub(crate) place: Range<usize>,
    pub(crate) varied: Varied,
    /// The part of the body, from 0, to which it belongs.
    pub(crate) part: Option<usize>,
    /// The values as they are written, SI.
    nominal: Vec<f64>,
    columns: Vec<TargetColumn>,
    dimension: Dimension,
    /// The places of all values of the file that it takes the place of.
    covered: Vec<usize>,
}

/// One number of a target, as a table has it.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetColumn {
    /// The key as a name, and the unit: `start_spin_body_x_rad_s`.
    pub name: String,
    /// The unit in SI: `rad/s`; empty if there is none.
    pub unit: String,
    /// What it is.
    pub description: String,
}

/// Where the values go.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Varied {
    /// Numbers of the file, by their places; an element of a symmetric matrix has two.
    Numbers(Vec<Vec<Range<usize>>>),
    /// A rotation of the file, by its place.
    Rotation(usize),
    /// Of the body, or of its part; what is not among the values is as it was.
    MassProperties(MassProperties<Body>),
}

impl Target {
    /// Its key, as the file has it.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The values as they are written, SI: one for each column.
    pub fn nominal(&self) -> &[f64] {
        &self.nominal
    }

    /// Its numbers, as a table has them.
    pub fn columns(&self) -> &[TargetColumn] {
        &self.columns
    }

    /// The mass properties as they are written, of a target that is mass properties.
    pub const fn mass_properties(&self) -> Option<&MassProperties<Body>> {
        match &self.varied {
            Varied::MassProperties(nominal) => Some(nominal),
            _ => None,
        }
    }

    /// What each of its numbers measures; a plain number where they differ.
    pub(crate) const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// True if the same number would vary by both.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        let is_made = |target: &Self| matches!(target.varied, Varied::MassProperties(_));
        match (is_made(self), is_made(other)) {
            (false, false) => self.covered.iter().any(|place| other.covered.contains(place)),
            // Of a part, or of all parts together, what is dispersed is made anew.
            (true, true) => self.part.is_none() || other.part.is_none() || self.part == other.part,
            (true, false) => other.part.is_some() && (self.part.is_none() || self.part == other.part),
            (false, true) => other.overlaps(self),
        }
    }
}

/// What a scenario has, to be looked up by keys.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Catalogue<'a> {
    pub(crate) entries: &'a Entries,
    pub(crate) found: &'a Found,
    pub(crate) nominal: &'a Scenario,
}

/// A place in the tree.
struct Spot<'a> {
    node: &'a Node,
    /// The words of its name.
    words: Vec<String>,
    part: Option<usize>,
}

impl Catalogue<'_> {
    /// One number.
    pub(crate) fn number(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        if let Kind::List(_) | Kind::Table(_) = spot.node.kind {
            let inside = match &spot.node.kind {
                Kind::Table(entries) => entries.keys().next().map(|inner| format!(".{inner}")),
                _ => Some("[0]".to_owned()),
            };
            let error = key.invalid("one number of the scenario, not several");
            let hint = format!("write key = \"{}{}\"", key.string()?, inside.unwrap_or_default());
            return Err(error.with_hint(hint));
        }
        let number = self.number_at(key, spot.node)?;
        let mut places = vec![number.span.clone()];
        if let Some(mirrored) = mirrored(key.string()?) {
            let other = spot_at(self.entries, &mirrored).map_err(|(rule, hint)| refused(key, &rule, hint))?;
            places.push(self.number_at(key, other.node)?.span.clone());
        }
        let words = spot.words.join("_");
        Self::target(key, &[(number, places)], spot.part, &[words])
    }

    /// Three numbers that are a vector.
    pub(crate) fn vector(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        let elements = match &spot.node.kind {
            Kind::List(elements) if elements.len() == 3 => elements,
            _ => {
                let error = key.invalid("an array of three numbers: only a vector has a direction");
                return Err(error.with_hint("write key = \"start.spin.body\""));
            }
        };
        let number = |element| self.number_at(key, element).map(|number| (number, vec![number.span.clone()]));
        let numbers: Vec<_> = elements.iter().map(number).collect::<Result<_, _>>()?;
        let words = ["x", "y", "z"].map(|axis| format!("{}_{axis}", spot.words.join("_")));
        Self::target(key, &numbers, spot.part, &words)
    }

    /// Numbers, each with its places, of which each has its words.
    fn target(
        key: &Value<'_>,
        numbers: &[(&Number, Vec<Range<usize>>)],
        part: Option<usize>,
        words: &[String],
    ) -> Result<Target, FormatError> {
        let written = key.string()?;
        let dimension = numbers.first().map_or(Dimension::NONE, |(number, _)| number.dimension);
        let described = |words: &String| {
            let axis = words.rsplit('_').next().unwrap_or_default();
            let description = match numbers.len() {
                1 => written.to_owned(),
                _ => format!("{written}, {axis}"),
            };
            column(words, dimension, description)
        };
        let places: Vec<Vec<Range<usize>>> = numbers.iter().map(|(_, places)| places.clone()).collect();
        Ok(Target {
            key: written.to_owned(),
            place: key.span(),
            part,
            nominal: numbers.iter().map(|(number, _)| number.value).collect(),
            columns: words.iter().map(described).collect(),
            dimension,
            covered: places.iter().flatten().map(|place| place.start).collect(),
            varied: Varied::Numbers(places),
        })
    }

    /// A rotation: an attitude, or how a part is turned.
    pub(crate) fn rotation(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let spot = self.spot(key)?;
        let place = spot.node.span.start;
        let Some(quaternion) = self.found.rotations.get(&place) else {
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
            varied: Varied::Rotation(place),
            part: spot.part,
            nominal: quaternion.to_vec(),
            columns: columns.to_vec(),
            dimension: Dimension::NONE,
            covered: spot.node.places(),
        })
    }

    /// The mass properties of the body, `body`, or of a part, `body.part[0]`; with `.inertia` behind it the tensor alone.
    pub(crate) fn mass_properties(&self, key: &Value<'_>) -> Result<Target, FormatError> {
        let written = key.string()?;
        let (whole, tensor_only) = match written.strip_suffix(".inertia") {
            Some(whole) => (whole, true),
            None => (written, false),
        };
        let (part, words, properties) = if whole == "body" {
            (None, "body".to_owned(), self.nominal.body)
        } else {
            let spot = spot_at(self.entries, whole).map_err(|(rule, hint)| refused(key, &rule, hint))?;
            let one_part = matches!(spot.node.kind, Kind::Table(_)) && spot.words.len() == 3;
            match spot.part.and_then(|k| Some((k, self.found.parts.get(k)?))) {
                Some((k, (part, _))) if one_part => (Some(k), spot.words.join("_"), part.properties),
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
            varied: Varied::MassProperties(properties),
            part,
            nominal,
            columns,
            dimension: Dimension::NONE,
            covered: Vec::new(),
        })
    }

    fn spot(&self, key: &Value<'_>) -> Result<Spot<'_>, FormatError> {
        spot_at(self.entries, key.string()?).map_err(|(rule, hint)| refused(key, &rule, hint))
    }

    fn number_at(&self, key: &Value<'_>, node: &Node) -> Result<&Number, FormatError> {
        let number = self.found.numbers.get(&node.span.start);
        number.ok_or_else(|| {
            key.invalid("a number of the scenario: words, formulas and whole numbers do not vary")
                .with_hint("a formula may stand for a number: write that number without quotes, in SI")
        })
    }
}

fn refused(key: &Value<'_>, rule: &str, hint: Option<String>) -> FormatError {
    let error = key.invalid(rule);
    match hint {
        Some(hint) => error.with_hint(hint),
        None => error,
    }
}

/// The key of the element beyond the diagonal of a tensor, which is the same number.
fn mirrored(key: &str) -> Option<String> {
    let (rest, j) = key.strip_suffix(']')?.rsplit_once('[')?;
    let (matrix, i) = rest.strip_suffix(']')?.rsplit_once('[')?;
    (matrix.ends_with(".inertia") && i != j).then(|| format!("{matrix}[{j}][{i}]"))
}

/// Why there is nothing at a key: the rule that it breaks, and a hint.
type Nowhere = (String, Option<String>);

/// Goes along a key such as `body.part[0].size[2]` or `torque["wind"].from`.
fn spot_at<'a>(entries: &'a Entries, key: &str) -> Result<Spot<'a>, Nowhere> {
    let mut rest = key;
    let mut table = Some(entries);
    let mut spot: Option<Spot<'a>> = None;
    while !rest.is_empty() {
        let done = &key[..key.len() - rest.len()];
        if let Some(inside) = rest.strip_prefix('[') {
            let Some((index, after)) = inside.split_once(']') else {
                return Err((format!("a key, but its bracket is not closed after {done}"), None));
            };
            let from =
                spot.take().ok_or_else(|| ("a key that begins with a table's name".to_owned(), None))?;
            spot = Some(element(from, done, index)?);
            rest = after;
        } else {
            let rest_of = if done.is_empty() { Some(rest) } else { rest.strip_prefix('.') };
            let Some(word_on) = rest_of else {
                return Err((format!("a key: write a dot or a bracket after {done}"), None));
            };
            let end = word_on.find(['.', '[']).unwrap_or(word_on.len());
            let (word, after) = word_on.split_at(end);
            let here = if done.is_empty() { "the scenario".to_owned() } else { done.to_owned() };
            let known = || table.into_iter().flatten().map(|(key, _)| key.as_str());
            let Some(entry) = table.and_then(|table| table.get(word)) else {
                let keys = known().filter(|key| *key != "sweep").collect::<Vec<_>>().join(", ");
                let hint = match (nearest(word, known()), keys.is_empty()) {
                    (Some(near), _) => Some(format!(
                        "did you mean \"{done}{}{near}{after}\"?",
                        if done.is_empty() { "" } else { "." }
                    )),
                    (None, false) => {
                        Some(format!("the keys of {here} are {keys}; what varies has to stand there"))
                    }
                    (None, true) => None,
                };
                return Err((format!("a key of the scenario, but {here} has no \"{word}\""), hint));
            };
            let mut words = spot.as_ref().map_or_else(Vec::new, |spot| spot.words.clone());
            words.push(word.to_owned());
            spot = Some(Spot { node: &entry.node, words, part: spot.and_then(|spot| spot.part) });
            rest = after;
        }
        table = match spot.as_ref().map(|spot| &spot.node.kind) {
            Some(Kind::Table(entries)) => Some(entries),
            _ => None,
        };
    }
    spot.ok_or_else(|| {
        ("a key of the scenario".to_owned(), Some("write key = \"start.spin.body[0]\"".to_owned()))
    })
}

/// The element of an array by its index, from 0, or by its `name`.
fn element<'a>(from: Spot<'a>, done: &str, index: &str) -> Result<Spot<'a>, Nowhere> {
    let Kind::List(elements) = &from.node.kind else {
        return Err((format!("a key of the scenario, but {done} is not an array"), None));
    };
    let name_of = |node: &'a Node| match &node.kind {
        Kind::Table(entries) => match &entries.get("name")?.node.kind {
            Kind::Text(name) => Some(name.as_str()),
            _ => None,
        },
        _ => None,
    };
    let quoted = index.trim().strip_prefix(['"', '\'']).and_then(|name| name.strip_suffix(['"', '\'']));
    let k = match quoted {
        Some(name) => {
            let names = || elements.iter().filter_map(name_of);
            elements.iter().position(|node| name_of(node) == Some(name)).ok_or_else(|| {
                let hint = match nearest(name, names()) {
                    Some(near) => format!("did you mean {done}[\"{near}\"]?"),
                    None => format!("write {done}[0], or give it a name = \"...\""),
                };
                (format!("a key of the scenario, but no {done} is named \"{name}\""), Some(hint))
            })?
        }
        None => index.trim().parse::<usize>().ok().filter(|k| *k < elements.len()).ok_or_else(|| {
            let hint = format!("{done} has {} elements, from {done}[0]", elements.len());
            (format!("a key of the scenario, but there is no {done}[{index}]"), Some(hint))
        })?,
    };
    let node = elements.get(k).unwrap_or(from.node);
    let Spot { mut words, part, .. } = from;
    let is_part = words == ["body", "part"];
    let axis = match (elements.len(), &node.kind) {
        (3, _) => ["x", "y", "z"].get(k),
        (4, Kind::List(_)) => None,
        (4, _) => ["w", "x", "y", "z"].get(k),
        _ => None,
    };
    match (&node.kind, axis) {
        (Kind::Table(_), _) | (_, None) => words.push(quoted.map_or_else(|| k.to_string(), str::to_owned)),
        // The element xy of a matrix.
        (_, Some(axis)) if words.last().is_some_and(|last| ["x", "y", "z"].contains(&last.as_str())) => {
            words.last_mut().into_iter().for_each(|last| last.push_str(axis));
        }
        (_, Some(axis)) => words.push((*axis).to_owned()),
    }
    Ok(Spot { node, words, part: if is_part { Some(k) } else { part } })
}

fn column(words: &str, dimension: Dimension, description: String) -> TargetColumn {
    let letter = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let (unit, suffix) = dimension.unit();
    let name: String = words.chars().map(letter).collect();
    let name = if suffix.is_empty() { name } else { format!("{name}_{suffix}") };
    TargetColumn { name, unit, description }
}
