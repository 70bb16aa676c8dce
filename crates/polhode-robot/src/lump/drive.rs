//! Joints that carry a body, and the inertia that their motors have to move.

use polhode::body::MassProperties;
use polhode::math::Body;

use super::tree::Above;
use crate::model::{JointKind, RobotModel, Span};
use crate::pose::{direction, dot};

/// A joint with one axis between a body and what it hangs on.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Name of the joint.
    pub joint: String,
    /// Place of the joint in the model's text.
    pub span: Span,
    /// True if it slides, false if it turns.
    pub slides: bool,
    /// Moment of inertia of the body about the joint's axis, kg·m²; its mass in kg if the joint slides.
    pub inertia: f64,
    /// Inertia that the rotor adds, kg·m² or kg: reflected by its gear; NaN if the file's number cannot be read.
    pub armature: f64,
}

/// The joints that carry a body whose frame is theirs, in the order of the file.
///
/// I_a = n·I_c n + m |n × (c − p)|² about the axis through p along n; only axes with a direction.
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
