//! Links that need a mass and have none: `mass.not_positive`, `mass.missing`,
//! `mass.massless_collision`.
//!
//! A link without mass is a frame, such as that of a camera, a tool or a foot. Frames are common
//! and are not reported. Three cases are reported. A link that is moved by a joint needs mass, its
//! own or that of its descendants. A tensor without mass is unphysical. A link with collision
//! geometry has mass. Defaults depend on the language: in MJCF the geoms have mass, in SDF the mass
//! is 1 kg.

use super::finding;
use super::tree::Tree;
use super::written::short;
use crate::finding::{Finding, Severity};
use crate::model::{Inertial, Link, ModelFormat, RobotModel, Role, Slot};

const NEEDED: &str = "a moving link or one of its descendants has positive mass";

pub(super) fn check(model: &RobotModel, tree: &Tree, k: usize, findings: &mut Vec<Finding>) {
    let Some(link) = model.links.get(k).filter(|link| !link.is_static) else { return };
    match &link.inertial {
        Some(inertial) => given(model, tree, k, link, inertial, findings),
        None => nothing(model, tree, k, link, findings),
    }
}

fn given(
    model: &RobotModel,
    tree: &Tree,
    k: usize,
    link: &Link,
    inertial: &Inertial,
    findings: &mut Vec<Finding>,
) {
    let Some(mass) = inertial.mass.finite().filter(|m| *m <= 0.0) else { return };
    let mut tell = |code, severity, message, rule| {
        let mut found = finding(code, severity, link, inertial.mass.span(), message, rule);
        found.numbers = vec![("mass", mass)];
        findings.push(found);
    };
    if mass < 0.0 {
        let message = format!("mass {} kg is negative", short(mass, 6));
        return tell("mass.not_positive", Severity::Impossible, message, "mass is positive");
    }
    let tensor = inertial.tensor.slots().into_iter().flatten().filter_map(Slot::finite).find(|x| *x != 0.0);
    if let Some(moment) = tensor {
        let message = format!("mass 0 kg, but a moment of inertia of {} kg·m²", short(moment, 6));
        // A link fixed to another one, a base, and a single link at rest need neither mass nor
        // tensor.
        let still = tree.is_carried(k) || tree.is_base(k) || tree.len() == 1;
        let severity =
            if still && model.format == ModelFormat::Urdf { Severity::Suspect } else { Severity::Impossible };
        return tell("mass.not_positive", severity, message, "a link without mass has no inertia");
    }
    if model.format == ModelFormat::Sdf {
        let message = "mass 0 kg on a link that is not static".to_owned();
        return tell(
            "mass.not_positive",
            Severity::Impossible,
            message,
            "SDF requires a positive mass for every link that can move",
        );
    }
    if tree.moves_itself(k) && !tree.has_mass_below(k) {
        let message =
            "mass 0 kg on a link that a joint moves, and none of its descendants has mass".to_owned();
        // A model without any mass is a drawing: it can be posed, but not simulated.
        let severity = if tree.has_mass() { Severity::Impossible } else { Severity::Suspect };
        return tell("mass.not_positive", severity, message, NEEDED);
    }
    touched(tree, k, link, findings);
}

fn nothing(model: &RobotModel, tree: &Tree, k: usize, link: &Link, findings: &mut Vec<Finding>) {
    let mut tell = |code, severity, message: &str, rule| {
        findings.push(finding(code, severity, link, link.name.span.clone(), message.to_owned(), rule));
    };
    match model.format {
        // MuJoCo rejects a body with a joint if neither it nor a body welded to it has mass.
        ModelFormat::Mjcf => {
            if tree.moves_itself(k) && !tree.has_welded_mass(k) && !tree.is_bounded() {
                let message = "no inertial and no geom on a body with a joint";
                tell(
                    "mass.missing",
                    Severity::Impossible,
                    message,
                    "a body with a joint, or a child fixed to it, has mass",
                );
            }
        }
        ModelFormat::Sdf => {
            if has_collision(link) && !link.from_geometry {
                let message = "no inertial: SDF assumes 1 kg and 1 kg·m² about each axis";
                tell("mass.missing", Severity::Suspect, message, "a link that can move states its mass");
            }
        }
        // A USD body without mass takes it from its shapes.
        ModelFormat::Usd => {}
        ModelFormat::Urdf | ModelFormat::Osim => {
            if has_collision(link) {
                touched(tree, k, link, findings);
            } else if tree.moves_itself(k)
                && !tree.has_mass_below(k)
                && tree.is_weighed()
                && !link.geometry.is_empty()
            {
                tell("mass.missing", Severity::Suspect, "no inertial on a link that a joint moves", NEEDED);
            }
        }
    }
}

/// Reports a link without mass that has collision geometry.
fn touched(tree: &Tree, k: usize, link: &Link, findings: &mut Vec<Finding>) {
    if !has_collision(link) {
        return;
    }
    let (severity, more, rule) = if tree.is_carried(k) && tree.is_held_by_mass(k) {
        let rule = "programs lump links that are fixed together, so the mass is that of the other links";
        (Severity::Note, ": it is fixed to a link with mass", rule)
    } else if tree.is_base(tree.group(k)) && !tree.is_held_by_mass(k) {
        // In URDF, a massless base link fixes the robot to the world.
        let rule = "a base without mass cannot move; this is right for a robot fixed to the world";
        (Severity::Note, "", rule)
    } else if !tree.is_weighed() && tree.len() > 1 {
        // A model without any mass is a drawing.
        (Severity::Note, "", "a link with collision geometry has mass")
    } else {
        (Severity::Suspect, "", "a link with collision geometry has mass")
    };
    let message = format!("collision geometry, but no mass{more}");
    findings.push(finding("mass.massless_collision", severity, link, link.name.span.clone(), message, rule));
}

fn has_collision(link: &Link) -> bool {
    link.geometry.iter().any(|g| g.role == Role::Collision)
}
