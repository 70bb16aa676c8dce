//! Limits of joints, and `PhysxMimicJointAPI`: q + gearing · q_reference + offset = 0.
//!
//! Angles are in degrees, lengths in the layer's unit. A gearing between an angle and a length is
//! not read, because the schema does not define its unit.

use super::Stage;
use super::layer::Prim;
use super::path::absolute;
use super::value::Value;
use crate::coordinate::{NO_NUMBER, limits};
use crate::model::{Coordinate, Follows, JointKind, Name};

/// Returns the limits and the coupling of a joint's value.
pub(super) fn of(stage: &Stage<'_>, prim: &Prim, kind: JointKind) -> Coordinate {
    let unit = match kind {
        JointKind::Revolute => 1_f64.to_radians(),
        JointKind::Prismatic => stage.units.metres,
        // A fixed joint does not move, even if it is coupled.
        JointKind::Fixed => return Coordinate::default(),
        JointKind::Free | JointKind::Other => f64::NAN,
    };
    let limit =
        |side: &str| number(prim.properties.get(&format!("physics:{side}Limit"))?).map(|limit| unit * limit);
    let mut mimics: Vec<Follows> =
        prim.properties.iter().filter_map(|(name, value)| follows(stage, prim, unit, name, value)).collect();
    mimics.sort_by_key(|mimic| (mimic.span.start, mimic.leader.as_ref().map(|leader| leader.text.clone())));
    let several = mimics.len() > 1;
    let follows = mimics.into_iter().next().map(|mimic| match several {
        true => Follows { coefficients: Err("it follows several joints".to_owned()), ..mimic },
        false => mimic,
    });
    // Schemas: `PhysxJointAPI`, and `PhysxJointAxisAPI` for its axis. Unit: kg·m², or kg for a
    // sliding joint.
    let (axis, unit) = match kind {
        JointKind::Revolute => ("angular", stage.units.kilograms * stage.units.metres * stage.units.metres),
        _ => ("linear", stage.units.kilograms),
    };
    let own = prim.properties.get(&format!("physxJointAxis:{axis}:armature"));
    let others = ["physxJoint:armature", "mjc:armature", "newton:armature"];
    let armature = own.or_else(|| others.iter().find_map(|name| prim.properties.get(*name)));
    let armature = armature.map_or(0.0, |value| number(value).map_or(f64::NAN, |armature| unit * armature));
    let limits = limits(limit("lower"), limit("upper"));
    Coordinate { limits, follows, armature, ..Coordinate::default() }
}

/// Returns the coupling to the reference joint, if this property names it.
fn follows(stage: &Stage<'_>, prim: &Prim, unit: f64, name: &str, value: &Value) -> Option<Follows> {
    let schema = name.strip_suffix(":referenceJoint").filter(|name| name.starts_with("physxMimicJoint:"))?;
    let path = absolute(value.words.first()?, &prim.path);
    let leader = stage.numbers.get(path.as_str()).and_then(|&k| stage.layer.prims.get(k));
    let term = |name: &str, default: f64| match prim.properties.get(&format!("{schema}:{name}")) {
        Some(value) => number(value).unwrap_or(f64::NAN),
        None => default,
    };
    let line = [-term("gearing", 1.0), -unit * term("offset", 0.0)];
    let same = leader.is_none_or(|leader| leader.kind == prim.kind);
    let coefficients = match line {
        _ if !same => Err("a gearing between a rotation and a translation is not read".to_owned()),
        [slope, offset] if slope.is_finite() && offset.is_finite() => Ok(vec![offset, slope]),
        _ => Err(NO_NUMBER.to_owned()),
    };
    let leader = Name { text: path, span: value.span.clone() };
    Some(Follows { span: value.span.clone(), leader: Some(leader), reference: 0.0, coefficients })
}

fn number(value: &Value) -> Option<f64> {
    value.numbers.first().and_then(|number| number.value)
}
