//! Axes of joints: their agreement, and the coordinate that takes one to another.

use super::mass::{length, vector, within};
use crate::model::{Joint, JointKind, Pose};
use crate::pose::{about_axis, cross, direction, dot, sum};

/// Directions whose sine of the angle to an axis is smaller do not determine a rotation about it.
const OBLIQUE: f64 = 1e-3;

/// Axis of a joint that rotates or slides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// Unit vector along the axis.
    pub(super) direction: [f64; 3],
    /// Point on the axis, m. It has no meaning for a sliding joint.
    pub(super) point: [f64; 3],
    pub(super) slides: bool,
}

impl Axis {
    /// Returns the axis in the frame of the joint's child; `None` for other joints and for the zero
    /// vector.
    pub(super) fn of(joint: &Joint) -> Option<Self> {
        let slides = match joint.kind {
            JointKind::Revolute => false,
            JointKind::Prismatic => true,
            JointKind::Fixed | JointKind::Free | JointKind::Other => return None,
        };
        Some(Self { direction: direction(joint.axis)?, point: joint.anchor, slides })
    }

    /// Returns the axis in the outer frame of a pose.
    pub(super) fn placed(&self, pose: &Pose) -> Self {
        Self { direction: pose.turned(self.direction), point: pose.placed(self.point), ..*self }
    }

    /// Returns the angle to another axis, rad, and the distance of its point from this line, m; zero
    /// for a sliding joint.
    pub(super) fn apart(&self, other: &Self) -> (f64, f64) {
        let (a, b) = (self.direction, other.direction);
        let angle = libm::atan2(length(cross(a, b)), dot(a, b));
        let away = if self.slides { 0.0 } else { length(cross(a, vector(self.point, other.point))) };
        (angle, away)
    }

    /// Returns true if both axes are the same line with the same direction; `size` is the length
    /// that distances are relative to.
    pub(super) fn agrees(&self, other: &Self, tolerance: f64, size: f64) -> bool {
        let (angle, away) = self.apart(other);
        self.slides == other.slides && within(angle, tolerance) && within(away, tolerance * size)
    }

    /// Returns the motion about or along this axis by q, rad or m.
    pub(super) fn motion(&self, q: f64) -> Pose {
        if self.slides {
            return Pose::new(self.direction.map(|n| q * n), Pose::IDENTITY.rotation);
        }
        let turn = Pose::new([0.0; 3], about_axis(self.direction, q).unwrap_or(Pose::IDENTITY.rotation));
        Pose { position: vector(turn.turned(self.point), self.point), ..turn }
    }

    /// Returns the coordinate q of this joint at which `from` is taken to `to`, if these two points
    /// determine one.
    pub(super) fn between_points(&self, from: [f64; 3], to: [f64; 3]) -> Option<f64> {
        let n = self.direction;
        if self.slides {
            return Some(dot(n, vector(from, to)));
        }
        let [from, to] = [from, to].map(|point| self.aside(vector(self.point, point)));
        let is_off = length(from) > 0.0 && length(to) > 0.0;
        is_off.then(|| libm::atan2(dot(n, cross(from, to)), dot(from, to)))
    }

    /// Returns the coordinate q of this joint at which the axis `from` is taken to the axis `to`, if
    /// these two determine one.
    pub(super) fn between(&self, from: &Self, to: &Self) -> Option<f64> {
        let n = self.direction;
        if self.slides {
            // Only the part of n across the line moves the line.
            let d = to.direction;
            let across = vector(d.map(|c| dot(n, d) * c), n);
            let square = dot(across, across);
            let is_open = !to.slides && square > OBLIQUE * OBLIQUE;
            return is_open.then(|| dot(across, vector(from.point, to.point)) / square);
        }
        let [u, v] = [from, to].map(|axis| self.aside(axis.direction));
        if length(u) > OBLIQUE && length(v) > OBLIQUE {
            return Some(libm::atan2(dot(n, cross(u, v)), dot(u, v)));
        }
        if to.slides { None } else { self.between_points(from.point, to.point) }
    }

    /// Returns the smallest motion that takes this axis to another.
    pub(super) fn onto(&self, other: &Self) -> Pose {
        let (angle, _) = self.apart(other);
        let normal = cross(self.direction, other.direction);
        let turn = Pose::new([0.0; 3], about_axis(normal, angle).unwrap_or(Pose::IDENTITY.rotation));
        if self.slides {
            return turn;
        }
        let shift = other.aside(vector(self.point, other.point));
        Pose { position: vector(turn.turned(self.point), sum(self.point, shift)), ..turn }
    }

    /// Returns the part of a vector that is perpendicular to the axis.
    fn aside(&self, v: [f64; 3]) -> [f64; 3] {
        let along = dot(self.direction, v);
        std::array::from_fn(|k| v[k] - along * self.direction[k])
    }
}
