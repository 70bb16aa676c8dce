//! Rigid bodies: their pose, and their mass properties from UsdPhysics' `MassAPI`.
//!
//! Values that `MassAPI` omits, or states as zero (−inf for the centre), are computed from the
//! colliders ([`super::mass`]). Without colliders they are missing.

use super::layer::Prim;
use super::unit::in_si;
use super::value::Value;
use super::{Stage, applies, changing};
use crate::finding::Severity;
use crate::model::{Inertial, Link, Note, Number, Pose, Slot, Tensor};
use crate::pose::unit;

pub(super) const MASS: &str = "physics:mass";
pub(super) const CENTER: &str = "physics:centerOfMass";
pub(super) const MOMENTS: &str = "physics:diagonalInertia";
pub(super) const AXES: &str = "physics:principalAxes";

/// All attributes that state mass properties.
pub(super) const ATTRIBUTES: [&str; 5] = [MASS, CENTER, MOMENTS, AXES, "physics:density"];

/// Returns true if a prim states mass properties.
pub(super) fn has_mass(prim: &Prim) -> bool {
    if prim.kind == "Material" || applies(prim, "PhysicsMaterialAPI") {
        return false; // its density is that of the colliders that it is bound to
    }
    applies(prim, "PhysicsMassAPI")
        || ATTRIBUTES.iter().any(|name| prim.properties.contains_key(*name))
        || changing::of_mass(prim, &ATTRIBUTES, &mut Vec::new()).is_some()
}

/// Reports a mass that UsdPhysics ignores, because `PhysicsMassAPI` is not applied.
pub(super) fn unapplied(prim: &Prim, notes: &mut Vec<Note>) {
    if !applies(prim, "PhysicsMassAPI") {
        ignoring(prim, "PhysicsMassAPI is not applied to the prim", notes);
    }
}

/// Reports a mass that UsdPhysics ignores, because its prim is not a body or collider.
pub(super) fn ignored(prim: &Prim, notes: &mut Vec<Note>) {
    ignoring(prim, "the prim is neither a rigid body nor a collider", notes);
}

fn ignoring(prim: &Prim, why: &str, notes: &mut Vec<Note>) {
    let named = ATTRIBUTES.iter().find_map(|name| prim.properties.get(*name).map(|value| (name, value)));
    let Some((name, value)) = named else { return };
    let message = format!("UsdPhysics ignores {name}: {why}");
    let note = Note::new("read.unknown", &prim.path, value.span.clone(), message);
    notes.push(Note { severity: Severity::Suspect, ..note });
}

/// Returns the link of a body, and true if what it does not state may be computed. Its shapes are
/// added later.
pub(super) fn link(stage: &Stage<'_>, k: usize, prim: &Prim, notes: &mut Vec<Note>) -> (Link, bool) {
    let place = stage.place(k);
    let scaled = place.scaled_pose();
    let pose = scaled
        .as_ref()
        .map_or(Pose { unreadable: place.unreadable.clone(), ..Pose::IDENTITY }, |(_, pose)| pose.clone());
    let name = crate::model::Name { text: prim.path.clone(), ..prim.name.clone() };
    let is_scaled = place.is_scaled();
    let mut link = Link {
        name,
        span: prim.span.clone(),
        inertial: None,
        geometry: Vec::new(),
        pose,
        is_static: prim.is_off("physics:rigidBodyEnabled"),
        from_geometry: false,
        computed: None,
    };
    let changing = changing::of_mass(prim, &ATTRIBUTES, notes);
    let too_many = too_many(prim, notes);
    let is_computable = changing.is_none() && too_many.is_none() && scaled.is_some();
    let Some(mass) = prim.properties.get(MASS).filter(|mass| mass.is_given()) else {
        let why = || "it is missing: the physics engine computes it from the collision shapes".to_owned();
        link.from_geometry = true;
        link.computed = Some(Err(changing.or(too_many).unwrap_or_else(why)));
        return (link, is_computable);
    };
    if prim.properties.contains_key("physics:density") {
        let message = "both a mass and a density: the mass is used".to_owned();
        notes.push(Note::new("read.left_out", &prim.path, mass.span.clone(), message));
    }
    let (inertial, has_center) = inertial(stage, prim, mass);
    if is_scaled {
        link.computed =
            Some(Err("its prim is scaled, and physics engines apply the scale differently".to_owned()));
    } else if !has_center {
        let why = "its centre of mass is missing: the physics engine computes it from the collision shapes";
        link.computed = Some(Err(why.to_owned()));
    }
    if let Some(why) = changing.or(too_many) {
        link.computed = Some(Err(why));
    }
    link.inertial = Some(inertial);
    (link, is_computable)
}

/// Reports attributes with too many numbers, and returns the reason why the body has no mass
/// properties.
fn too_many(prim: &Prim, notes: &mut Vec<Note>) -> Option<String> {
    let mut first = None;
    for (name, count) in [(MASS, 1), (CENTER, 3), (MOMENTS, 3), (AXES, 4)] {
        let Some(value) = prim.properties.get(name).filter(|value| value.numbers.len() > count) else {
            continue;
        };
        let message = format!("{name} has {} numbers instead of {count}", value.numbers.len());
        let note = Note::new("read.numbers", &prim.path, value.span.clone(), message.clone());
        notes.push(Note { severity: Severity::Suspect, ..note });
        first.get_or_insert(message);
    }
    first
}

/// Returns the inertial, and true if it states its centre.
fn inertial(stage: &Stage<'_>, prim: &Prim, mass: &Value) -> (Inertial, bool) {
    let units = stage.units;
    let mut pose = Pose::IDENTITY;
    let center = prim.properties.get(CENTER).filter(|center| !is_left_out(center));
    if let Some(center) = center {
        match super::xform::numbers::<3>(center) {
            Some(center) => pose.position = center.map(|c| units.metres * c),
            None => pose.unreadable.push(first_wrong(center)),
        }
        pose.span = Some(center.span.clone());
    }
    let axes = prim.properties.get(AXES);
    if let Some(axes) = axes.filter(|axes| axes.is_given()) {
        match super::xform::numbers::<4>(axes).and_then(unit) {
            Some(rotation) => pose.rotation = rotation,
            None => pose.unreadable.push(first_wrong(axes)),
        }
        pose.span = Some(axes.span.clone());
    }
    let moments = prim.properties.get(MOMENTS);
    let moments = moments.filter(|moments| moments.is_given());
    let tensor = match moments {
        None => Tensor::Missing(prim.span.clone()),
        Some(moments) => {
            let unit = units.kilograms * units.metres * units.metres;
            Tensor::Diagonal(Box::new([0, 1, 2].map(|k| slot(moments, k, unit, "diagonalInertia"))))
        }
    };
    let mass = slot(mass, 0, units.kilograms, "mass");
    (Inertial { span: prim.span.clone(), mass, pose, tensor }, center.is_some())
}

/// Returns true for a centre with −inf, the value that requests computation.
pub(super) fn is_left_out(center: &Value) -> bool {
    center.numbers.iter().any(|number| number.value == Some(f64::NEG_INFINITY))
}

fn slot(value: &Value, k: usize, unit: f64, name: &str) -> Slot {
    match value.numbers.get(k) {
        // A text in place of a number.
        _ if !value.words.is_empty() => {
            Slot::Given(Number { text: value.text(), span: value.span.clone(), value: None })
        }
        Some(number) => Slot::Given(in_si(number, unit)),
        None => Slot::Missing { span: value.span.clone(), name: format!("{name} {}", k + 1) },
    }
}

/// Returns the first unreadable number, or all of them if their count is wrong.
fn first_wrong(value: &Value) -> Number {
    let wrong = value.numbers.iter().find(|number| !number.value.is_some_and(f64::is_finite));
    let all = || Number { text: value.text(), span: value.span.clone(), value: None };
    wrong.cloned().unwrap_or_else(all)
}
