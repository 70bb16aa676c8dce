//! Evidence for the position of one group in another: axes of the joints below, placement of the
//! geometry, centres of mass, and tensors.

use super::axis::Axis;
use super::mass::{Mass, length, vector, within};
use super::pairs::Pair;
use super::robot::{Member, Robot};
use crate::model::{Pose, Role};

/// Upper bound on the coordinates that are tried for one joint.
const MOST: usize = 8;

/// Points in the frame of a group, m.
type Points = Vec<[f64; 3]>;

/// Facts about two groups, each in its group's frame: of the first model, then of the second.
#[derive(Debug, Default)]
pub(super) struct Evidence {
    axes: Vec<(Axis, Axis)>,
    /// Origins of the shapes of a link.
    shapes: Vec<(Points, Points)>,
    masses: Vec<(Mass, Mass)>,
}

impl Evidence {
    pub(super) fn of(pair: &Pair, below: &[&Pair], a: &Robot<'_>, b: &Robot<'_>) -> Self {
        let placed =
            |robot: &Robot<'_>, group: usize| Some(robot.axis(group)?.placed(&robot.groups.get(group)?.pose));
        let axes = below.iter().filter_map(|child| placed(a, child.a).zip(placed(b, child.b)));
        let mut evidence = Self { axes: axes.collect(), ..Self::default() };
        for (one, other) in pair.members(a, b) {
            for role in [Role::Collision, Role::Visual] {
                let (one, other) = (shapes(a, one, role), shapes(b, other, role));
                if one.len() == other.len() && !one.is_empty() {
                    evidence.shapes.push((one, other));
                }
            }
        }
        if pair.has_same_masses(a, b) {
            let masses = pair.members(a, b).filter_map(|(a, b)| a.in_group().zip(b.in_group()));
            evidence.masses.extend(masses);
        } else {
            evidence.masses.extend(whole(a, pair.a).zip(whole(b, pair.b)));
        }
        evidence
    }

    /// Counts the facts that agree if `pose` is the pose of the first group in the second.
    pub(super) fn votes(&self, pose: &Pose, tolerance: f64, size: f64) -> usize {
        let axes = self.axes.iter().filter(|(a, b)| a.placed(pose).agrees(b, tolerance, size)).count();
        let is_near =
            |a: &[f64; 3], b: &[f64; 3]| within(length(vector(pose.placed(*a), *b)), tolerance * size);
        let is_placed = |(a, b): &&(Points, Points)| a.iter().zip(b).all(|(a, b)| is_near(a, b));
        let shapes = self.shapes.iter().filter(is_placed).count();
        let of_mass = |(a, b): &(Mass, Mass)| {
            let [_, _, tensor] = a.placed(pose).agrees(b, tolerance);
            usize::from(is_near(&a.center, &b.center)) + usize::from(tensor)
        };
        axes + shapes + self.masses.iter().map(of_mass).sum::<usize>()
    }

    /// Returns the coordinates of a joint above the groups that take one of the facts of the first
    /// group to that of the second, if `pose` is the pose at coordinate zero. Tensors determine
    /// none: the wrong sign of a product looks like half a turn.
    pub(super) fn coordinates(&self, axis: &Axis, pose: &Pose) -> Vec<f64> {
        let of_axes = self.axes.iter().filter_map(|(a, b)| axis.between(&a.placed(pose), b));
        let points = |a: &[f64; 3], b: &[f64; 3]| axis.between_points(pose.placed(*a), *b);
        let of_shapes = self.shapes.iter().flat_map(|(a, b)| a.iter().zip(b));
        let of_shapes = of_shapes.filter_map(|(a, b)| points(a, b));
        let of_masses = self.masses.iter().filter_map(|(a, b)| points(&a.center, &b.center));
        of_axes.chain(of_shapes).chain(of_masses).take(MOST).collect()
    }
}

/// Returns the sum of a group's masses, in its frame.
fn whole(robot: &Robot<'_>, group: usize) -> Option<Mass> {
    let masses: Vec<Mass> = robot.groups.get(group)?.members.iter().filter_map(Member::in_group).collect();
    Mass::sum(&masses)
}

/// Returns the origins of a link's shapes of a role, in the group's frame.
fn shapes(robot: &Robot<'_>, member: &Member, role: Role) -> Points {
    let shapes = robot.link(member).into_iter().flat_map(|link| &link.geometry);
    let of_role = shapes.filter(|shape| shape.role == role && shape.pose.unreadable.is_empty());
    of_role.map(|shape| member.pose.placed(shape.pose.position)).collect()
}
