//! Inertials as attributes of USD prims, in the units of the layer.
//!
//! USD stores single precision, so the numbers have the digits that identify it. An attribute of
//! 0 means "not given", which no solid has for its mass and moments.

use std::collections::HashMap;

use polhode::body::MassProperties;
use polhode::math::Part;

use super::digits::{Digits, InertialDigits};
use super::element::{line_end, own_indent};
use crate::model::{Link, RobotModel, Span};
use crate::read::usd::MassSite;

/// Half of the unit in the last place of single precision, relative; its least value.
const SINGLE: f64 = 3e-8;

/// Rounding error of a unit quaternion.
const OF_AXES: f64 = 1e-14;

/// Returns the edits that write the inertial of a prim. The value of a kept mass is not edited.
///
/// # Errors
/// The reason in words why it cannot be written.
pub(super) fn edits(
    model: &RobotModel,
    sites: &HashMap<String, MassSite>,
    link: &Link,
    body: &MassProperties<Part>,
    digits: &InertialDigits,
    is_kept: bool,
) -> Result<Vec<(Span, String)>, String> {
    let Some(site) = sites.get(&link.name.text) else { return Err("its prim was not found".to_owned()) };
    let text = &model.text;
    let own = text.get(site.openings.1..site.next).unwrap_or_default();
    let end = line_end(text);
    let indent = own_indent(text, site.head.start).unwrap_or("");
    let mut edits = Vec::new();
    let mut lines = String::new();
    let [mass, center, moments, axes] = numbers(body, digits, site.units);
    let tuple = |numbers: &[String]| format!("({})", numbers.join(", "));
    let new = [
        ("float", mass.concat()),
        ("point3f", tuple(&center)),
        ("float3", tuple(&moments)),
        ("quatf", tuple(&axes)),
    ];
    for (k, ((name, old), (kind, value))) in site.values.iter().zip(new).enumerate() {
        match old {
            Some(_) if k == 0 && is_kept => {}
            Some(old) => edits.push((old.clone(), value)),
            None if own.contains(name) => return Err(format!("it has {name} without a single value")),
            None => lines += &format!("{end}{indent}    {kind} {name} = {value}"),
        }
    }
    if !lines.is_empty() {
        let at = site.openings.1;
        let rest = text.get(at..).unwrap_or_default();
        let is_alone = rest.split(['\n', '\r']).next().is_some_and(|rest| rest.trim().is_empty());
        edits.push((at..at, if is_alone { lines } else { lines + end + indent + "    " }));
    }
    edits.extend(schema(text, site, indent, end)?);
    Ok(edits)
}

/// Returns mass, centre, moments and axes in the units of a layer.
fn numbers(
    body: &MassProperties<Part>,
    digits: &InertialDigits,
    [metres, kilograms]: [f64; 2],
) -> [Vec<String>; 4] {
    let text = |x: f64, error: f64| Digits::within(x, error.max(SINGLE * x.abs())).text;
    let [mass, center, tensor] = digits.errors;
    let inertia = kilograms * metres * metres;
    let principal = body.principal();
    [
        vec![text(body.mass() / kilograms, mass / kilograms)],
        body.center_of_mass().to_array().map(|c| text(c / metres, center / metres)).to_vec(),
        principal.moments().map(|moment| text(moment / inertia, tensor / inertia)).to_vec(),
        principal.rotation().canonical_quaternion().map(|q| text(q, OF_AXES)).to_vec(),
    ]
}

/// Returns the edit that applies `PhysicsMassAPI`, unless it is applied.
fn schema(text: &str, site: &MassSite, indent: &str, end: &str) -> Result<Option<(Span, String)>, String> {
    const NAME: &str = "\"PhysicsMassAPI\"";
    if site.is_applied {
        return Ok(None);
    }
    let statement = format!("{end}{indent}    prepend apiSchemas = [{NAME}]");
    Ok(Some(match (&site.schemas, site.openings.0) {
        (Some(list), _) => {
            let inside = text.get(list.clone()).and_then(|list| list.strip_prefix('[')?.strip_suffix(']'));
            let Some(inside) = inside else { return Err("its apiSchemas are not a list".to_owned()) };
            let trimmed = inside.trim_end();
            let at = list.start + 1 + trimmed.len();
            let comma = if trimmed.trim().is_empty() || trimmed.ends_with(',') { "" } else { ", " };
            (at..at, format!("{comma}{NAME}"))
        }
        (None, Some(at)) => (at..at, statement),
        (None, None) => (site.head.end..site.head.end, format!(" ({statement}{end}{indent})")),
    }))
}
