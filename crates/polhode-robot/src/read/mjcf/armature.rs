//! Reflected rotor inertia of joints: the `armature` of the joint and of its actuators.
//!
//! I = I_joint + Σ gear₁² I_actuator
//!
//! Source: mujoco.readthedocs.io, XML Reference, `joint/armature` and `actuator/general/armature`.
//! Tendons are not included, because their contribution depends on the positions of other joints.

use std::collections::HashMap;

use crate::model::{Joint, JointKind};
use crate::read::xml::Element;

use super::context::Context;
use super::equality::{Origin, chain};

/// Adds the actuators' armatures to the joints; `of_joints` gives the origin of each joint.
pub(super) fn add(contexts: &[Context<'_>], origins: &[Origin], of_joints: &[usize], joints: &mut [Joint]) {
    let rotors: Vec<_> = contexts.iter().map(rotors).collect();
    if rotors.iter().all(HashMap::is_empty) {
        return;
    }
    let has_one_value = |joint: &Joint| matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic);
    for (joint, &origin) in joints.iter_mut().zip(of_joints).filter(|(joint, _)| has_one_value(joint)) {
        // One actuator may be reached through two origins that do not change names.
        let mut seen = Vec::new();
        for origin in chain(origins, origin) {
            let Some(own) = origin.own(&joint.name.text) else { continue };
            for (element, inertia) in
                rotors.get(origin.context).and_then(|all| all.get(own)).into_iter().flatten()
            {
                if !seen.contains(&element.span().start) {
                    seen.push(element.span().start);
                    joint.coordinate.armature += inertia;
                }
            }
        }
    }
}

/// Returns the actuators of a model with an armature, by joint: gear² I, NaN if it cannot be read.
fn rotors<'a>(context: &Context<'a>) -> HashMap<&'a str, Vec<(Element<'a>, f64)>> {
    let mut rotors: HashMap<&str, Vec<_>> = HashMap::new();
    for element in context.root.named("actuator").flat_map(Element::children) {
        let Some(joint) = element.word("joint").or_else(|| element.word("jointinparent")) else { continue };
        let source = context.classes.actuator(element);
        let Some(inertia) = source.number("armature").filter(|inertia| *inertia != 0.0) else { continue };
        let gear = source.values("gear").first().copied().unwrap_or(1.0);
        rotors.entry(joint).or_default().push((element, gear * gear * inertia));
    }
    rotors
}
