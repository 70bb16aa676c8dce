//! Joints that carry a body, and the inertia that their motors move.

use polhode::body::MassProperties;
use polhode::math::Body;

use super::tree::Above;
use crate::model::{JointKind, RobotModel, Span};
use crate::pose::{direction, dot};

/// Joint with one axis between a body and its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Name of the joint.
    pub joint: String,
    /// Position of the joint in the model's text.
    pub span: Span,
    /// True for a sliding joint, false for a rotating one.
    pub slides: bool,
    /// Moment of inertia of the body about the joint axis, kg·m²; for a sliding joint its mass, kg.
    pub inertia: f64,
    /// Reflected inertia of the rotor, kg·m² or kg; NaN if the file's number cannot be read.
    pub armature: f64,
}

/// Returns the joints that carry a body, in file order. The body's frame is the frame of the
/// joints' child.
///
/// I_a = n·I_c n + m |n × (c − p)|² about the axis through p along n. Joints whose axis is zero are
/// skipped.
pub(super) fn drives(model: &RobotModel, above: &Above, body: &MassProperties<Body>) -> Vec<Drive> {
    let drive = |joint: &crate::model::Joint| {
        let slides = match joint.kind {
            JointKind::Revolute => false,
            JointKind::Prismatic => true,
            JointKind::Fixed | JointKind::Free | JointKind::Other => return None,
        };
        let inertia = if slides {
            body.mass()
        } else {
            let n = direction(joint.axis)?;
            let center = body.center_of_mass().to_array();
            let d = [0, 1, 2].map(|k| center[k] - joint.anchor[k]);
            let along = dot(n, d);
            let aside = [0, 1, 2].map(|k| d[k] - along * n[k]);
            dot(n, body.inertia().matrix().map(|row| dot(row, n))) + body.mass() * dot(aside, aside)
        };
        let armature = joint.coordinate.armature;
        let armature = if armature >= 0.0 && armature.is_finite() { armature } else { f64::NAN };
        Some(Drive { joint: joint.name.text.clone(), span: joint.span.clone(), slides, inertia, armature })
    };
    above.joints(model).filter_map(drive).collect()
}
