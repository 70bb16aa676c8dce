//! Typed poses: position and attitude of an inner frame in an outer one.

use polhode::body::BodyError;
use polhode::math::{Direction, Frame, Position, Rotation};

use crate::model::{Joint, JointKind, Pose};

/// Pose of frame `B` in frame `A`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement<A: Frame, B: Frame> {
    /// Origin of B in frame A, m.
    pub(crate) position: Position<A>,
    /// Rotation R_AB.
    pub(crate) rotation: Rotation<A, B>,
}

impl<A: Frame, B: Frame> Placement<A, B> {
    /// Returns the identity: the frames coincide.
    pub(crate) fn identity() -> Self {
        Self { position: Position::from_array([0.0; 3]), rotation: Rotation::identity() }
    }

    /// Converts a pose, and checks that it is finite with a unit quaternion.
    pub(crate) fn of(pose: &Pose) -> Result<Self, BodyError> {
        let finite = |value: f64| {
            let error = BodyError::Parameter { what: "the pose", value, rule: "finite" };
            if value.is_finite() { Ok(()) } else { Err(error) }
        };
        pose.position.into_iter().try_for_each(finite)?;
        let length = pose.rotation.iter().map(|c| c * c).sum::<f64>().sqrt();
        let error = BodyError::Parameter {
            what: "the quaternion's length",
            value: length,
            rule: "positive and finite",
        };
        let rotation = Rotation::from_quaternion(pose.rotation).map_err(|_| error)?;
        Ok(Self { position: Position::from_array(pose.position), rotation })
    }

    /// Composes placements: T_AC = T_AB T_BC.
    pub(crate) fn then<C: Frame>(self, inner: Placement<B, C>) -> Placement<A, C> {
        Placement {
            position: self.position + self.rotation * inner.position,
            rotation: self.rotation * inner.rotation,
        }
    }
}

impl<F: Frame> Placement<F, F> {
    /// Returns the motion of the child frame by a joint at q (rad or m), in its axes at zero.
    /// Returns `None` if the joint axis is zero.
    ///
    /// Rotation: x ↦ a + R(n, q)(x − a). Translation: x ↦ x + q n.
    pub(crate) fn motion(joint: &Joint, q: f64) -> Option<Self> {
        if q == 0.0 {
            return Some(Self::identity());
        }
        let axis = Direction::<F>::from_array(joint.axis).direction()?;
        match joint.kind {
            JointKind::Revolute => {
                let anchor = Position::<F>::from_array(joint.anchor);
                let rotation = Rotation::from_axis_angle(axis, q).ok()?;
                Some(Self { position: anchor - rotation * anchor, rotation })
            }
            JointKind::Prismatic => {
                let way = Position::from_array(axis.to_array().map(|n| q * n));
                Some(Self { position: way, rotation: Rotation::identity() })
            }
            JointKind::Fixed | JointKind::Free | JointKind::Other => None,
        }
    }
}
