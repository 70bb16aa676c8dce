//! Rotor inertias (armature) that are negative or not numbers: `joint.armature`.

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;

pub(super) fn check(model: &RobotModel, findings: &mut Vec<Finding>) {
    for joint in &model.joints {
        let armature = joint.coordinate.armature;
        if armature >= 0.0 && armature.is_finite() {
            continue;
        }
        let message = "its rotor inertia is negative or not finite".to_owned();
        let rule = "the rotor inertia of a joint is at least 0, in kg·m², or in kg for a sliding joint";
        let (name, span) = (&joint.name.text, joint.span.clone());
        findings.push(Finding::new("joint.armature", Severity::Suspect, name, span, message, rule));
    }
}
