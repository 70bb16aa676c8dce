//! Rotor inertias (armature) that are negative or not numbers: `joint.armature`.

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;

pub(super) fn check(model: &RobotModel, findings: &mut Vec<Finding>) {
    for joint in &model.joints {
        let armature = joint.coordinate.armature;
        if armature >= 0.0 && armature.is_finite() {
            continue;
        }
        let message = "the inertia of its rotor is negative or not a finite number".to_owned();
        let rule = "a rotor adds inertia to its joint: kg·m², or kg if it slides";
        let (name, span) = (&joint.name.text, joint.span.clone());
        findings.push(Finding::new("joint.armature", Severity::Suspect, name, span, message, rule));
    }
}
