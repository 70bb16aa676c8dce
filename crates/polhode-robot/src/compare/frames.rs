//! Pose of each group of the first model in its group of the second.
//!
//! The pose follows from the joints, from the root outwards:
//!
//! T_child = M(−q₀) X_B⁻¹ T_parent X_A
//!
//! with the poses X of the child's frame in its parent's frame at joint value zero, and the motion M
//! of the second model's joint. q₀ is the value of the second model's joint at the zero of the
//! first's. It is zero unless the evidence below the joint fits better with another value.

use super::axis::Axis;
use super::evidence::Evidence;
use super::mass::{length, vector, within};
use super::pairs::{Pair, Pairs};
use super::robot::{Group, Robot};
use crate::model::{JointKind, Pose};

/// Upper bound on the shared links whose frames are tried for a root.
const MOST: usize = 4;

/// Pose of a group in its partner, and the state of the joints above them.
#[derive(Clone, Debug)]
pub(super) struct Alignment {
    /// Pose of the first model's group in the second model's group.
    pub(super) pose: Pose,
    /// Value q₀ of the second model's joint at the zero of the first's, rad or m; zero if equal.
    pub(super) zero: f64,
    pub(super) joints: Joints,
}

/// Comparison of the joints above two groups.
#[derive(Clone, Debug)]
pub(super) enum Joints {
    /// Same joint, or two roots.
    Same,
    /// Joints of different types.
    Kind,
    /// Axes that differ, both in the parent's frame of the second model: first and second model.
    Axis(Axis, Axis),
    /// Groups that hang at different groups, or only one of which is a root.
    Place,
    /// Ball or other joints with another anchor, or another pose of the child.
    Rest,
}

/// Models with the correspondence of their groups.
#[derive(Debug)]
pub(super) struct Aligned<'r, 'm> {
    pub(super) a: &'r Robot<'m>,
    pub(super) b: &'r Robot<'m>,
    pub(super) pairs: &'r Pairs,
    pub(super) tolerance: f64,
    /// Length that distances are relative to, m.
    pub(super) size: f64,
}

impl Aligned<'_, '_> {
    /// Returns the alignment of each pair.
    pub(super) fn alignments(&self) -> Vec<Alignment> {
        let below = self.pairs.below(self.a, self.b);
        let mut known: Vec<Alignment> = Vec::with_capacity(self.pairs.list.len());
        for (k, pair) in self.pairs.list.iter().enumerate() {
            let children = below.get(k).into_iter().flatten();
            let children: Vec<&Pair> = children.filter_map(|&child| self.pairs.list.get(child)).collect();
            let evidence = Evidence::of(pair, &children, self.a, self.b);
            let above = self.pairs.above(pair, self.a, self.b).and_then(|above| known.get(above));
            let alignment = self.alignment(pair, above.map(|above| &above.pose), &evidence);
            known.push(alignment);
        }
        known
    }

    fn alignment(&self, pair: &Pair, parent: Option<&Pose>, evidence: &Evidence) -> Alignment {
        let (Some(a), Some(b)) = (self.a.groups.get(pair.a), self.b.groups.get(pair.b)) else {
            return Alignment { pose: Pose::IDENTITY, zero: 0.0, joints: Joints::Same };
        };
        let own = self.own_frames(pair);
        let kinds = (self.kind(self.a, pair.a), self.kind(self.b, pair.b));
        let Some(parent) = parent.filter(|_| kinds != (Some(JointKind::Free), Some(JointKind::Free))) else {
            let is_loose = |group: &Group, kind| group.parent.is_none() || kind == Some(JointKind::Free);
            let joints = match (is_loose(a, kinds.0), is_loose(b, kinds.1)) {
                (true, true) => Joints::Same,
                _ => Joints::Place,
            };
            let candidates = own.into_iter().chain([b.pose.inverse().then(&a.pose)]);
            return Alignment { pose: self.best(candidates, evidence), zero: 0.0, joints };
        };
        let kinematic = b.pose.inverse().then(&parent.then(&a.pose));
        let kinematic = self.snapped(kinematic, &own);
        let axes = self.a.axis(pair.a).zip(self.b.axis(pair.b));
        let axes = axes.map(|(a, b)| (a.placed(&kinematic), b));
        match axes {
            _ if kinds.0 != kinds.1 => {
                let candidates = [kinematic].into_iter().chain(own);
                Alignment { pose: self.best(candidates, evidence), zero: 0.0, joints: Joints::Kind }
            }
            Some((from, to)) if from.agrees(&to, self.tolerance, self.size) => {
                self.with_zero(&kinematic, &to, &own, evidence)
            }
            Some((from, to)) => {
                let turned = from.onto(&to).then(&kinematic);
                let candidates = [kinematic, turned].into_iter().chain(own);
                let joints = Joints::Axis(from.placed(&b.pose), to.placed(&b.pose));
                Alignment { pose: self.best(candidates, evidence), zero: 0.0, joints }
            }
            None => {
                let pose = self.best([kinematic.clone()].into_iter().chain(own), evidence);
                let anchors = self.a.joint(pair.a).zip(self.b.joint(pair.b));
                let is_anchored = anchors.is_none_or(|(a, b)| {
                    let apart = length(vector(kinematic.placed(a.anchor), b.anchor));
                    within(apart, self.tolerance * self.size)
                });
                let is_same = is_anchored && self.is_near(&pose, &kinematic);
                let joints = if is_same { Joints::Same } else { Joints::Rest };
                Alignment { pose, zero: 0.0, joints }
            }
        }
    }

    /// Returns the alignment of groups whose joints have the same axis, in the frame of the second
    /// model's group.
    fn with_zero(&self, pose: &Pose, axis: &Axis, own: &[Pose], evidence: &Evidence) -> Alignment {
        let votes = |pose: &Pose| evidence.votes(pose, self.tolerance, self.size);
        let unit = if axis.slides { self.size } else { 1.0 };
        let mut best = (votes(pose), 0.0, pose.clone());
        for way in evidence.coordinates(axis, pose) {
            if within(way.abs(), self.tolerance * unit) {
                continue;
            }
            let moved = self.snapped(axis.motion(way).then(pose), own);
            let count = votes(&moved);
            if count > best.0 {
                best = (count, -way, moved);
            }
        }
        let (_, zero, pose) = best;
        Alignment { pose, zero, joints: Joints::Same }
    }

    /// Returns the candidate with which most of the evidence agrees; the first of several.
    fn best(&self, candidates: impl Iterator<Item = Pose>, evidence: &Evidence) -> Pose {
        let mut best: Option<(usize, Pose)> = None;
        for candidate in candidates {
            let votes = evidence.votes(&candidate, self.tolerance, self.size);
            if best.as_ref().is_none_or(|(most, _)| votes > *most) {
                best = Some((votes, candidate));
            }
        }
        best.map_or(Pose::IDENTITY, |(_, pose)| pose)
    }

    /// Returns the poses of the first group in the second at which a shared link has the same frame.
    fn own_frames(&self, pair: &Pair) -> Vec<Pose> {
        let members = pair.members(self.a, self.b).take(MOST);
        members.map(|(a, b)| b.pose.then(&a.pose.inverse())).collect()
    }

    /// Returns the pose at which a shared link has the same frame in both models if it differs from
    /// this one only within the tolerance. Rounding of the poses above does not accumulate then.
    fn snapped(&self, pose: Pose, own: &[Pose]) -> Pose {
        own.iter().find(|own| self.is_near(&pose, own)).cloned().unwrap_or(pose)
    }

    /// Returns true if two poses agree within the tolerance.
    pub(super) fn is_near(&self, one: &Pose, other: &Pose) -> bool {
        let apart = one.inverse().then(other);
        let [w, x, y, z] = apart.rotation;
        let angle = 2.0 * libm::atan2(length([x, y, z]), w.abs());
        within(angle, self.tolerance) && within(length(apart.position), self.tolerance * self.size)
    }

    fn kind(&self, robot: &Robot<'_>, group: usize) -> Option<JointKind> {
        robot.joint(group).map(|joint| joint.kind)
    }
}
