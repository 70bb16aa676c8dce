//! The `[body]`: its parts, and the point that is held.

use polhode::{Body, BodyPart, Finding, MassProperties, Position, Severity, Symmetry};

use super::part::part;
use super::reader::{Table, Value};
use crate::error::{FormatError, FormatErrorKind};
use crate::unit::Dimension;

/// All parts of a body, alone and together.
#[derive(Debug)]
pub(crate) struct Assembly<'a> {
    pub(crate) parts: Vec<BodyPart>,
    pub(crate) body: MassProperties<Body>,
    pub(crate) pivot: Option<Pivot<'a>>,
}

/// The point of the body that is held fixed, and the value that says so.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivot<'a> {
    pub(crate) point: Position<Body>,
    pub(crate) value: Value<'a>,
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
    let mut parts = Vec::new();
    for (k, table) in list.tables("body.part")?.into_iter().enumerate() {
        parts.push(part(table, k + 1, findings)?);
    }
    if parts.is_empty() {
        return Err(table.missing("part", EXAMPLE));
    }
    let placed: Vec<_> = parts.iter().map(|part| part.properties).collect();
    let body = MassProperties::combined(&placed).map_err(|e| list.error(FormatErrorKind::Body(e)))?;
    let pivot = table.get("pivot").map(Pivot::read).transpose()?;
    findings.extend(thinness(&body));
    Ok(Assembly { parts, body, pivot })
}

/// A body without inertia about some axis moves, but not every start and torque make sense.
fn thinness(body: &MassProperties<Body>) -> Option<Finding> {
    let (code, message) = match body.principal().symmetry() {
        Symmetry::Point => ("body.point", "all the mass is at one point: the body has no inertia of its own"),
        Symmetry::Rod => (
            "body.rod",
            "all the mass is on one line: the body has no inertia about it, and a spin about it means nothing",
        ),
        _ => return None,
    };
    Some(Finding { code, severity: Severity::Info, message: message.to_owned(), place: None })
}
