//! Masses of links: by density, by material, kept, or a total that is distributed by volume.

use polhode::body::shape::Substance;
use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_document::number::number;
use polhode_shape::PartSubstance;
use polhode_source::{Failure, nearest};

use super::choice::{Chosen, name};
use super::digits::Digits;
use super::request::InertialsRequest;
use super::selection::matches;
use crate::geometry::{SolidPiece, Volume};
use crate::link_error::suggested;
use crate::model::{Geometry, Link, ModelFormat, RobotModel, Slot};
use crate::read::xml::with_root;

/// Solid of a link that gets an inertial.
pub(super) struct Weighed<'m> {
    pub(super) link: &'m Link,
    pub(super) chosen: Chosen,
}

/// Body of a link, with the origin of its mass in words.
pub(super) struct LinkBody {
    pub(super) properties: MassProperties<Part>,
    /// Origin of the mass: `kept`, `2700 kg/m³`.
    pub(super) mass_by: String,
    /// Text of a kept mass.
    pub(super) kept: Option<Digits>,
}

/// Substances that a request states.
pub(super) struct Substances<'r> {
    common: Option<Substance>,
    /// Substances of links, by pattern.
    links: Vec<&'r PartSubstance>,
    /// Substances of shapes and mesh parts, by pattern.
    parts: Vec<&'r PartSubstance>,
    /// Density of the links without substance if the total mass is given, kg/m³.
    of_total: Option<f64>,
}

impl<'r> Substances<'r> {
    /// Resolves the patterns of a request, and distributes a total mass.
    ///
    /// # Errors
    /// [`Failure`] if options contradict each other, or if a pattern matches nothing.
    pub(super) fn of(
        model: &RobotModel,
        request: &'r InertialsRequest,
        solids: &[Weighed<'_>],
        unusable: Option<&str>,
    ) -> Result<Self, Failure> {
        let usage = |message: String, hint: String| Failure::usage(message, hint).in_file(&model.path);
        let given: Vec<&PartSubstance> = request.part.iter().map(|given| &given.value).collect();
        let is_link =
            |part: &&&PartSubstance| model.links.iter().any(|link| matches(&part.name, &link.name.text));
        let links: Vec<&PartSubstance> = given.iter().filter(is_link).copied().collect();
        let parts: Vec<&PartSubstance> = given.iter().filter(|part| !is_link(part)).copied().collect();
        let common = request.substance.substance()?;
        let mut substances = Self { common, links, parts, of_total: None };
        for part in &substances.links {
            let own = solids.iter().filter(|solid| matches(&part.name, &solid.link.name.text)).count();
            if own > 1 && matches!(part.substance, Substance::Mass(_)) {
                let message = format!("--part {} gives one mass to {own} links", part.name);
                return Err(usage(message, "name one link, or give a density or material".to_owned()));
            }
        }
        for solid in solids {
            substances.of_link(solid.link).map_err(|twice| {
                let message =
                    format!("{twice} for the link {:?} contradict each other", solid.link.name.text);
                usage(message, "leave one of them out".to_owned())
            })?;
        }
        let mut names = Vec::new();
        for solid in solids.iter().filter(|_| !substances.parts.is_empty()) {
            for piece in &solid.chosen.solid.pieces {
                let all = components(model, solid, piece).into_iter().flatten();
                names.extend(all.map(|name| format!("{}/{name}", solid.link.name.text)));
            }
        }
        for part in &substances.parts {
            if names.iter().any(|name| matches(&part.name, name)) {
                continue;
            }
            let known: Vec<&str> = model
                .links
                .iter()
                .map(|link| link.name.text.as_str())
                .chain(names.iter().map(String::as_str))
                .collect();
            let message = format!("--part: no link, shape or mesh part is named {:?}", part.name);
            let hint = suggested(nearest(&part.name, known.iter().copied()), "the names are", &known);
            return Err(usage(message, hint));
        }
        if let Some(Substance::Mass(total)) = common {
            if let Some(link) = unusable {
                let message =
                    format!("the total mass cannot be distributed: the link {link:?} has no usable solid");
                return Err(usage(message, "choose links by --link, or give a density".to_owned()));
            }
            let rest = substances.rest(model, solids)?;
            if !(rest > 0.0) {
                let message = "--mass has no effect: every link has its own --part".to_owned();
                return Err(usage(message, "leave --mass out".to_owned()));
            }
            substances.of_total = Some(total / rest);
        }
        Ok(substances)
    }

    /// Returns the volume of all pieces without a substance of their own or of their link, m³.
    fn rest(&self, model: &RobotModel, solids: &[Weighed<'_>]) -> Result<f64, Failure> {
        let mut volume = 0.0;
        for solid in solids {
            if self.of_link(solid.link).is_ok_and(|own| own.is_some()) {
                continue;
            }
            for piece in &solid.chosen.solid.pieces {
                let own = self.of_piece(model, solid, piece);
                let own = own.map_err(|why| Failure::usage(why, "").in_file(&model.path))?;
                if own.is_none() {
                    volume += piece.volume.volume;
                }
            }
        }
        Ok(volume)
    }

    /// Returns the substance that a `--part` states for a link.
    ///
    /// # Errors
    /// The options in words, if several state different ones.
    fn of_link(&self, link: &Link) -> Result<Option<Substance>, String> {
        one(self.links.iter().filter(|part| matches(&part.name, &link.name.text)).copied())
    }

    /// Returns the substance that a `--part` states for a piece.
    ///
    /// # Errors
    /// The reason in words, if its shapes have different ones.
    fn of_piece(
        &self,
        model: &RobotModel,
        solid: &Weighed<'_>,
        piece: &SolidPiece,
    ) -> Result<Option<Substance>, String> {
        if self.parts.is_empty() {
            return Ok(None);
        }
        let mut own: Option<Option<Substance>> = None;
        for names in components(model, solid, piece) {
            let is_own = |part: &&&PartSubstance| {
                names.iter().any(|name| matches(&part.name, &format!("{}/{name}", solid.link.name.text)))
            };
            let found = one(self.parts.iter().filter(is_own).copied())
                .map_err(|twice| format!("{twice} contradict each other"))?;
            if own.is_some_and(|own| own != found) {
                return Err("shapes that overlap have different substances, so their common region has none"
                    .to_owned());
            }
            own = Some(found);
        }
        Ok(own.flatten())
    }

    /// Returns the body of a link.
    ///
    /// # Errors
    /// The reason in words why it has no mass.
    pub(super) fn body(&self, model: &RobotModel, solid: &Weighed<'_>) -> Result<LinkBody, String> {
        let pieces = &solid.chosen.solid.pieces;
        let own: Vec<Option<Substance>> =
            pieces.iter().map(|piece| self.of_piece(model, solid, piece)).collect::<Result<_, _>>()?;
        let mass_of = |(piece, own): (&SolidPiece, &Option<Substance>)| own.map(|own| mass(own, piece));
        let known: f64 = pieces.iter().zip(&own).filter_map(mass_of).sum();
        let rest: f64 = pieces
            .iter()
            .zip(&own)
            .filter(|(_, own)| own.is_none())
            .map(|(piece, _)| piece.volume.volume)
            .sum();
        let parts = if known > 0.0 && rest > 0.0 { ", and its parts' own substances" } else { "" };
        let stated = self.of_link(solid.link)?;
        let given = stated.or(self.common.filter(|common| matches!(common, Substance::Density(_))));
        // Amount of the rest, its origin in words, and the text of a kept mass.
        let (amount, mass_by, kept) = match (given, self.of_total) {
            (Some(Substance::Density(density)), _) => (Amount::Density(density), in_density(density), None),
            (Some(Substance::Mass(mass)), _) => (remainder(mass, known, rest)?, "given".to_owned(), None),
            (Some(Substance::AreaDensity(_) | Substance::LineDensity(_)), _) => {
                return Err("a density per area or length is not that of a solid".to_owned());
            }
            (None, Some(density)) => {
                let words = format!("share of the total, {}", in_density(density));
                (Amount::Density(density), words, None)
            }
            (None, None) if rest == 0.0 => {
                (Amount::Density(0.0), "its parts' own substances".to_owned(), None)
            }
            (None, None) => {
                let Some((mass, kept)) = kept(model, solid.link) else {
                    let why =
                        "it has no mass: give its density or mass by --density, --material, --part or --mass";
                    return Err(why.to_owned());
                };
                (remainder(mass, known, rest)?, "kept".to_owned(), Some(kept))
            }
        };
        let body = |(piece, own): (&SolidPiece, &Option<Substance>)| {
            let volume = piece.volume.volume;
            let rest = || match amount {
                Amount::Density(density) => density * volume,
                Amount::Mass(mass) => mass * (volume / rest),
            };
            of_volume(&piece.volume, mass_of((piece, own)).unwrap_or_else(rest))
        };
        let bodies = pieces.iter().zip(&own).map(body).collect::<Result<Vec<_>, _>>();
        let properties =
            bodies.and_then(|bodies| MassProperties::combined(&bodies)).map_err(|error| error.to_string())?;
        Ok(LinkBody { properties, mass_by: mass_by + parts, kept })
    }
}

/// Returns the mass of a piece, kg. Options state masses and densities per volume only.
fn mass(substance: Substance, piece: &SolidPiece) -> f64 {
    match substance {
        Substance::Mass(mass) => mass,
        Substance::Density(density) | Substance::AreaDensity(density) | Substance::LineDensity(density) => {
            density * piece.volume.volume
        }
    }
}

/// Amount of the pieces without their own substance.
#[derive(Clone, Copy)]
enum Amount {
    /// Density of each piece, kg/m³.
    Density(f64),
    /// Mass of all of them, kg.
    Mass(f64),
}

/// Returns what a given mass leaves for the rest of a link.
fn remainder(mass: f64, known: f64, rest: f64) -> Result<Amount, String> {
    let left = mass - known;
    if rest > 0.0 && left > 0.0 {
        return Ok(Amount::Mass(left));
    }
    let [mass, known] = [mass, known].map(|mass| number(mass, 6));
    Err(match rest > 0.0 {
        true => format!("its mass is {mass} kg, but its parts with their own substance have {known} kg"),
        false => format!(
            "its mass is {mass} kg, but all of its parts have their own substance, {known} kg in total"
        ),
    })
}

fn in_density(density: f64) -> String {
    format!("{} kg/m³", number(density, 6))
}

/// Returns the mass that a model states, kg, and its text; or the mass that the language computes.
fn kept(model: &RobotModel, link: &Link) -> Option<(f64, Digits)> {
    if let Some(Ok(computed)) = &link.computed {
        let mass = Some(computed.mass).filter(|mass| *mass > 0.0)?;
        return Some((mass, Digits::within(mass, 0.0)));
    }
    let Slot::Given(number) = &link.inertial.as_ref()?.mass else { return None };
    let value = number.value.filter(|mass| *mass > 0.0 && mass.is_finite())?;
    let text = if model.is_si { number.text.clone() } else { Digits::within(value, 0.0).text };
    Some((value, Digits { text, value }))
}

fn of_volume(volume: &Volume, mass: f64) -> Result<MassProperties<Part>, BodyError> {
    let density = mass / volume.volume;
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] =
        volume.tensor_per_density.map(|row| row.map(|x| density * x));
    let tensor = InertiaTensor::<Part>::with_negative_products([xx, yy, zz], [xy, xz, yz])?;
    MassProperties::new(mass, Position::from_array(volume.centroid), tensor)
}

/// Returns the substance of options that state the same; the options in words otherwise.
fn one<'p>(mut parts: impl Iterator<Item = &'p PartSubstance>) -> Result<Option<Substance>, String> {
    let Some(first) = parts.next() else { return Ok(None) };
    match parts.find(|other| other.substance != first.substance) {
        Some(other) => Err(format!("--part {} and --part {}", first.name, other.name)),
        None => Ok(Some(first.substance)),
    }
}

/// Returns the names of each component of a piece: of a shape, its name in the file and its number
/// (`visual 2`); of a mesh part, also its own name.
fn components(model: &RobotModel, solid: &Weighed<'_>, piece: &SolidPiece) -> Vec<Vec<String>> {
    let role = solid.chosen.role;
    let of_shape = |shape: &usize| {
        let before = solid.link.geometry.iter().take(*shape).filter(|geometry| geometry.role == role).count();
        let own = solid.link.geometry.get(*shape).and_then(|geometry| own_name(model, geometry));
        own.into_iter().chain([format!("{} {}", name(role), before + 1)]).collect::<Vec<_>>()
    };
    let shapes = piece.shapes.iter().map(of_shape);
    match (piece.shapes.as_slice(), piece.parts.is_empty()) {
        (_, true) => shapes.collect(),
        ([shape], false) => {
            let of_part = |part: &String| [part.clone()].into_iter().chain(of_shape(shape)).collect();
            piece.parts.iter().map(of_part).collect()
        }
        (_, false) => shapes.chain(piece.parts.iter().map(|part| vec![part.clone()])).collect(),
    }
}

/// Returns the name that the file gives a shape.
fn own_name(model: &RobotModel, geometry: &Geometry) -> Option<String> {
    let text = model.text.get(geometry.span.clone())?;
    if model.format == ModelFormat::Usd {
        return text.rsplit('"').nth(1).map(str::to_owned);
    }
    let mut name = None;
    with_root(text, |root| {
        name = root.word("name").map(str::to_owned);
        Ok(())
    })
    .ok()?;
    name.filter(|name| !name.is_empty())
}
