//! Numbers that are missing, malformed or not finite: `number.missing`, `number.malformed`,
//! `number.not_finite`. Zero joint axes: `joint.axis`.

use std::collections::HashSet;

use super::finding;
use super::tree::Tree;
use super::written::complaint;
use crate::finding::{Finding, Repair, Severity};
use crate::model::{
    GeometryShape, JointKind, Link, ModelFormat, Name, Number, Pose, RobotModel, Slot, Tensor,
};
use crate::pose::direction;

pub(super) fn check(model: &RobotModel, link: &Link, tree: &Tree, k: usize, findings: &mut Vec<Finding>) {
    let Some(inertial) = &link.inertial else { return };
    slot(model, link, &inertial.mass, "mass", findings);
    if let Some(slots) = inertial.tensor.slots() {
        for (name, s) in super::body::NAMES.iter().zip(slots) {
            slot(model, link, s, name, findings);
        }
    }
    for unreadable in &inertial.pose.unreadable {
        number(&link.name.text, unreadable, "the inertial's position or attitude", findings);
    }
    // A frame without mass needs no tensor. SDF has defaults for missing numbers.
    let weighs = inertial.mass.finite().is_some_and(|m| m != 0.0);
    let is_computed = model.format == ModelFormat::Usd && matches!(link.computed, Some(Ok(_)));
    if let (Tensor::Missing(span), true) = (&inertial.tensor, weighs && !is_computed) {
        let moves = tree.moves(k) || model.format == ModelFormat::Urdf;
        let (severity, rule) = match model.format {
            ModelFormat::Sdf => {
                (Severity::Suspect, "in SDF a missing tensor is the identity: 1 kg·m² about each axis")
            }
            ModelFormat::Usd => (
                Severity::Note,
                "in USD the physics engine computes a missing tensor from the collision shapes",
            ),
            _ if moves => (Severity::Impossible, "a link with mass needs an inertia tensor"),
            _ => (Severity::Note, "a moving link needs an inertia tensor"),
        };
        let message = format!("mass {} kg, but no inertia tensor", inertial.mass.finite().unwrap_or(0.0));
        findings.push(finding("inertia.missing", severity, link, span.clone(), message, rule));
    }
}

/// Reports unreadable numbers of poses and sizes.
pub(super) fn elsewhere(model: &RobotModel, findings: &mut Vec<Finding>) {
    // One number may be part of the pose of a link, a joint and a shape. Binary USD has no places.
    let mut told: HashSet<usize> = findings.iter().map(|f| f.span.start).collect();
    let mut tell = |subject: &Name, pose: &Pose, what: &str| {
        for unreadable in &pose.unreadable {
            if told.insert(unreadable.span.start) || unreadable.span.is_empty() {
                number(&subject.text, unreadable, what, findings);
            }
        }
    };
    for link in &model.links {
        tell(&link.name, &link.pose, "the link's position or attitude");
        for geometry in &link.geometry {
            tell(&link.name, &geometry.pose, "a shape's position or attitude");
        }
    }
    for joint in &model.joints {
        tell(&joint.name, &joint.pose, "the joint's position or attitude");
    }
    for joint in &model.joints {
        let has_axis = matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic);
        if has_axis && direction(joint.axis).is_none() {
            let zero = joint.axis == [0.0; 3];
            let (severity, what) = match zero {
                true => (Severity::Suspect, "zero"),
                false => (Severity::Impossible, "not three finite numbers"),
            };
            let message = format!("its axis is {what}");
            let rule = "the axis of a joint is a vector of nonzero length";
            let (subject, span) = (&joint.name.text, joint.span.clone());
            findings.push(Finding::new("joint.axis", severity, subject, span, message, rule));
        }
    }
    // MuJoCo fits the sizes of primitives to meshes, and has defaults.
    let links = model.links.iter().filter(|_| model.format != ModelFormat::Mjcf);
    for link in links {
        for geometry in link.geometry.iter().filter(|g| !has_size(&g.shape)) {
            let message = "a size of a shape is missing, is not a number, or is negative".to_owned();
            let rule = "sizes are positive numbers, in metres";
            let severity = Severity::Suspect;
            findings.push(finding("geometry.size", severity, link, geometry.span.clone(), message, rule));
        }
    }
}

/// Returns true if the sizes are valid. Zero is valid, since some models use it for shapes without
/// extent. A zero scale of a mesh is not.
fn has_size(shape: &GeometryShape) -> bool {
    let sizes = |sizes: &[f64]| sizes.iter().all(|x| *x >= 0.0 && x.is_finite());
    match shape {
        GeometryShape::Box(edges) | GeometryShape::Ellipsoid(edges) => sizes(edges),
        GeometryShape::Sphere(radius) => sizes(&[*radius]),
        GeometryShape::Cylinder { radius, length }
        | GeometryShape::Capsule { radius, length }
        | GeometryShape::Cone { radius, length } => sizes(&[*radius, *length]),
        GeometryShape::Mesh { scale, .. } | GeometryShape::Inline { scale, .. } => {
            scale.iter().all(|x| *x != 0.0 && x.is_finite())
        }
        GeometryShape::Other(_) => true,
    }
}

fn slot(model: &RobotModel, link: &Link, slot: &Slot, what: &str, findings: &mut Vec<Finding>) {
    match slot {
        Slot::Given(given) => number(&link.name.text, given, what, findings),
        Slot::Missing { span, name } => {
            // SDF has defaults: 1 kg, 1 kg·m² about each axis, products zero.
            let (severity, rule) = match (model.format, what) {
                (ModelFormat::Sdf, "ixy" | "ixz" | "iyz") => return,
                (ModelFormat::Sdf, _) => (Severity::Suspect, "in SDF a missing number is 1"),
                _ => (Severity::Impossible, "an inertial has all its numbers"),
            };
            let message = format!("{name} is missing");
            let code = if what == "mass" { "mass.missing" } else { "number.missing" };
            findings.push(finding(code, severity, link, span.clone(), message, rule));
        }
    }
}

fn number(subject: &str, number: &Number, what: &str, findings: &mut Vec<Finding>) {
    let text = &number.text;
    let (code, message, repaired) = match number.value {
        Some(value) if value.is_finite() => return,
        Some(value) => {
            let why = if value.is_nan() { "not a number" } else { "too large for a double" };
            ("number.not_finite", format!("{what} = {text:?} is {why}"), None)
        }
        None => {
            let (why, meant) = complaint(text);
            // The unit kg applies only to a mass.
            let meant = meant.filter(|_| !text.ends_with("kg") || what == "mass");
            ("number.malformed", format!("{what} = {text:?} {why}"), meant)
        }
    };
    let rule = "numbers are finite decimals with a decimal point and without units";
    let repair = repaired.map(|meant| Repair {
        description: format!("{what} {text} → {meant}"),
        edits: vec![(number.span.clone(), meant)],
    });
    let found = Finding::new(code, Severity::Impossible, subject, number.span.clone(), message, rule);
    findings.push(Finding { repair, ..found });
}
