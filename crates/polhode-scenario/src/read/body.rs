//! `[body]`: its parts and its pivot.

use std::sync::Arc;

use polhode::body::{BodyPart, Finding, MassProperties, PrincipalFrame, Severity, Symmetry};
use polhode::math::{Body, Position};
use polhode_shape::mesh::{AssumedMetres, longest_side};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::tree::{Known, Replacement};
use polhode_source::unit::Dimension;

use super::part::{assumes_metres, part};

/// All parts of a body, with the mass properties of the whole.
#[derive(Debug)]
pub(crate) struct Assembly<'a> {
    pub parts: Vec<BodyPart>,
    pub body: MassProperties<Body>,
    pub pivot: Option<Pivot<'a>>,
}

/// Fixed point of the body, with the value that gives it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivot<'a> {
    pub point: Position<Body>,
    pub value: Value<'a>,
}

impl<'a> Pivot<'a> {
    pub(crate) fn read(value: Value<'a>) -> Result<Self, FormatError> {
        Ok(Self { point: Position::from_array(value.quantities(Dimension::LENGTH)?), value })
    }
}

/// Reads `[body]` and its `[[body.part]]`s.
pub(crate) fn body<'a>(root: &Table<'a>, findings: &mut Vec<Finding>) -> Result<Assembly<'a>, FormatError> {
    const EXAMPLE: &str =
        "[[body.part]], and under it shape = \"sphere\", radius = \"20 mm\" and mass = \"12 g\", a line each";
    let table = root.require("body", EXAMPLE)?.table()?;
    table.allow(&["part", "pivot"])?;
    let list = table.require("part", EXAMPLE)?;
    let (mut parts, mut in_metres) = (Vec::new(), Vec::new());
    if let Some(Replacement::MassProperties(name, other)) = list.replacement() {
        parts.push(of_properties(name.clone(), *other));
    } else {
        for (k, part) in list.array_of_tables("body.part")?.into_iter().enumerate() {
            if let Some(Replacement::MassProperties(name, other)) = part.replacement() {
                parts.push(of_properties(name.clone(), *other));
                continue;
            }
            let table = part.table()?;
            in_metres.extend(assumes_metres(&table).map(|mass_given| (k, mass_given)));
            parts.push(known_part(&part, table, k, findings)?);
        }
    }
    if parts.is_empty() {
        return Err(table.missing("part", EXAMPLE));
    }
    findings.extend(in_metres.iter().filter_map(|(k, mass_given)| absurd_metres(&parts, *k, *mass_given)));
    let body = match (list.replacement(), list.known_as::<MassProperties<Body>>()) {
        (Some(Replacement::MassProperties(_, body)), _) => *body,
        (_, Some(body)) => *body,
        _ => {
            let placed: Vec<_> = parts.iter().map(|part| part.properties).collect();
            MassProperties::combined(&placed).map_err(|e| list.body(e))?
        }
    };
    list.keep(Known::Value(Arc::new(body)));
    let pivot = table.get("pivot").map(Pivot::read).transpose()?;
    Ok(Assembly { parts, body, pivot })
}

/// Returns a finding if part `k` is a mesh without a unit, and metres are implausible for its size
/// or next to the other parts.
fn absurd_metres(parts: &[BodyPart], k: usize, mass_given: bool) -> Option<Finding> {
    let part = parts.get(k)?;
    let others = parts.iter().enumerate().filter(|(other, _)| *other != k);
    let largest = others.map(|(_, part)| longest_side(&part.properties)).fold(0.0, f64::max);
    let assumed = AssumedMetres {
        properties: &part.properties,
        extent: part.extent,
        mass_given,
        others: Some(largest).filter(|largest| *largest > 0.0),
        remedy: "write unit = \"mm\", or unit = \"m\" if it is in metres",
    };
    assumed.finding(Some(format!("part \"{}\"", part.name)))
}

/// Part of the body without its display shape, which does not affect the motion, with the findings
/// on it.
pub(crate) type KnownPart = (BodyPart, Vec<Finding>);

/// Returns part `k`, from 0, from the cache if it has been read before.
fn known_part(
    value: &Value<'_>,
    table: Table<'_>,
    k: usize,
    findings: &mut Vec<Finding>,
) -> Result<BodyPart, FormatError> {
    if let (Some(known), false) = (value.known_as::<KnownPart>(), table.is_shown()) {
        let (part, noticed) = &*known;
        findings.extend_from_slice(noticed);
        return Ok(part.clone());
    }
    let mut noticed = Vec::new();
    let part = part(table, k + 1, &mut noticed)?;
    findings.extend_from_slice(&noticed);
    let known: KnownPart = (BodyPart { form: None, ..part.clone() }, noticed);
    value.keep(Known::Value(Arc::new(known)));
    Ok(part)
}

/// Creates a part with known mass properties only.
fn of_properties(name: String, properties: MassProperties<Body>) -> BodyPart {
    BodyPart {
        name,
        kind: "tensor",
        properties,
        extent: None,
        surface_area: None,
        particles: Vec::new(),
        form: None,
    }
}

/// Returns a finding for a body without inertia about some axis: it moves, but not all starts and
/// torques are valid.
pub(crate) fn thinness(principal: &PrincipalFrame<Body>) -> Option<Finding> {
    let (code, message) = match principal.symmetry() {
        Symmetry::Point => ("body.point", "all the mass is at one point: the body has no inertia of its own"),
        Symmetry::Rod => (
            "body.rod",
            "all the mass is on one line: the body has no inertia about this line, and a spin about it has no effect",
        ),
        _ => return None,
    };
    Some(Finding { code, severity: Severity::Info, message: message.to_owned(), place: None })
}
