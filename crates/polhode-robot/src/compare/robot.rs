//! Model as rigid groups: links joined by fixed joints, with one moving joint above each group.

use polhode_source::Failure;

use super::axis::Axis;
use super::mass::{Mass, length, vector};
use crate::line_index::{FilePlace, Places};
use crate::link_error::LinkError;
use crate::lump::{Place, Tree, at_rest, in_model, motion, no_pose, require_bodies, require_known, rigid};
use crate::model::{Joint, JointKind, Link, Pose, RobotModel, Span};

/// Number of the group of links that are fixed to the world. Its frame is the model's frame.
pub(super) const WORLD: usize = 0;

/// Model with its rigid groups.
#[derive(Debug)]
pub(super) struct Robot<'m> {
    pub(super) model: &'m RobotModel,
    /// Groups, each after its parent. The first is the world's; it may be empty.
    pub(super) groups: Vec<Group>,
    /// Length that distances are relative to: the largest distance of a frame or a centre of mass
    /// from its root, m.
    pub(super) size: f64,
    places: Places<'m>,
}

/// Links joined by fixed joints.
#[derive(Debug)]
pub(super) struct Group {
    /// Moving joint above the group; `None` for the world and for a root without a joint.
    pub(super) joint: Option<usize>,
    /// Group above that joint; `None` for a root, which may be free.
    pub(super) parent: Option<usize>,
    /// Pose of the group's frame in the parent's frame, or in the model's frame for a root, with
    /// all joint values zero. The joint's axis is stated in the group's frame.
    pub(super) pose: Pose,
    pub(super) members: Vec<Member>,
}

/// Link of a group.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub(super) link: usize,
    /// Pose of the link's frame in the group's frame.
    pub(super) pose: Pose,
    /// Mass properties in the link's frame; `None` for a frame without mass.
    pub(super) mass: Option<Mass>,
}

impl Member {
    /// Returns the mass properties in the group's frame.
    pub(super) fn in_group(&self) -> Option<Mass> {
        self.mass.as_ref().map(|mass| mass.placed(&self.pose))
    }
}

impl<'m> Robot<'m> {
    /// Divides a model into groups.
    ///
    /// # Errors
    /// [`Failure`] with its place, if the joints do not form a tree, or if a number cannot be used.
    pub(super) fn of(model: &'m RobotModel) -> Result<Self, Failure> {
        let places = Places::of(model);
        let groups = groups(model).map_err(|error| error.in_model(model))?;
        let size = size(&groups);
        Ok(Self { model, groups, size, places })
    }

    /// Returns the joint above a group.
    pub(super) fn joint(&self, group: usize) -> Option<&'m Joint> {
        self.model.joints.get(self.groups.get(group)?.joint?)
    }

    /// Returns the axis of the joint above a group, in the frame of that group.
    pub(super) fn axis(&self, group: usize) -> Option<Axis> {
        Axis::of(self.joint(group)?)
    }

    pub(super) fn link(&self, member: &Member) -> Option<&'m Link> {
        self.model.links.get(member.link)
    }

    /// Returns the name of a link.
    pub(super) fn name(&self, link: usize) -> &'m str {
        self.model.links.get(link).map_or("", |link| link.name.text.as_str())
    }

    /// Returns the place of a position in the text.
    pub(super) fn place(&self, span: &Span) -> FilePlace<'m> {
        self.places.place(span)
    }

    /// Returns the number of joints that are not fixed.
    pub(super) fn moving(&self) -> usize {
        self.model.joints.iter().filter(|joint| joint.kind != JointKind::Fixed).count()
    }

    /// Returns the sum of all masses, kg.
    pub(super) fn mass(&self) -> f64 {
        self.groups.iter().flat_map(|group| &group.members).filter_map(|m| m.mass).map(|m| m.mass).sum()
    }
}

/// Returns the groups.
fn groups(model: &RobotModel) -> Result<Vec<Group>, LinkError> {
    let tree = Tree::of(model)?;
    require_bodies(model, None)?;
    let rigid = rigid(model, &tree)?;
    let mut groups = vec![Group { joint: None, parent: None, pose: Pose::IDENTITY, members: Vec::new() }];
    let mut group_of = vec![WORLD; model.links.len()];
    let mut frames: Vec<Pose> = vec![Pose::IDENTITY; model.links.len()];
    // For each rigid group of the model: its number here, and the pose of its first link's frame.
    let mut known: Vec<Option<(usize, Pose)>> = vec![None; model.links.len()];
    for &k in &tree.order {
        let (Some(link), Some(above)) = (model.links.get(k), tree.above.get(k)) else { continue };
        let Some((number, place)) = rigid.get(k).copied().flatten() else { continue };
        let (group, base) = match known.get(number).cloned().flatten() {
            Some(known) => known,
            None => {
                let parent = above.parent.and_then(|p| Some((*group_of.get(p)?, frames.get(p)?)));
                let rest = match parent {
                    Some((_, frame)) => frame.then(&pose(at_rest(model, link, above)?)),
                    None => pose(in_model(model, link, above)?),
                };
                let parent = parent.map(|(group, _)| group);
                let joints: Vec<usize> = above.joints.clone();
                let first = hang(model, &mut groups, parent, rest, &joints)?;
                known.get_mut(number).into_iter().for_each(|slot| *slot = Some(first.clone()));
                first
            }
        };
        let frame = base.then(&pose(place));
        let mass = Mass::of(model.format, link).map_err(|error| error.of_link(&link.name.text))?;
        if let Some(group) = groups.get_mut(group) {
            group.members.push(Member { link: k, pose: frame.clone(), mass });
        }
        if let (Some(own), Some(slot)) = (group_of.get_mut(k), frames.get_mut(k)) {
            (*own, *slot) = (group, frame);
        }
    }
    Ok(groups)
}

/// Adds the groups below a parent, one for each of its joints to the same link, and returns the last
/// with the pose of that link in it.
fn hang(
    model: &RobotModel,
    groups: &mut Vec<Group>,
    parent: Option<usize>,
    rest: Pose,
    joints: &[usize],
) -> Result<(usize, Pose), LinkError> {
    let joints_above = joints.iter().filter_map(|&k| Some((k, model.joints.get(k)?)));
    let moving: Vec<_> = joints_above.filter(|(_, joint)| joint.kind != JointKind::Fixed).collect();
    if moving.is_empty() {
        if parent.is_none() && !joints.is_empty() {
            return Ok((WORLD, rest));
        }
        groups.push(Group { joint: None, parent: None, pose: rest, members: Vec::new() });
        return Ok((groups.len() - 1, Pose::IDENTITY));
    }
    let (mut above, mut place) = (parent.unwrap_or(WORLD), rest);
    for (k, joint) in moving {
        require_known(joint, "write the pose of its child at zero, or remove the joint from both models")?;
        if matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic) {
            if Axis::of(joint).is_none() || !joint.anchor.iter().all(|c| c.is_finite()) {
                return Err(no_pose(&joint.name.text, &joint.span));
            }
            place = place.then(&pose(motion(joint, -joint.coordinate.at_rest)?));
        }
        let is_free = joint.kind == JointKind::Free && parent.is_none();
        let parent = Some(above).filter(|_| !is_free);
        let own = std::mem::replace(&mut place, Pose::IDENTITY);
        groups.push(Group { joint: Some(k), parent, pose: own, members: Vec::new() });
        above = groups.len() - 1;
    }
    Ok((above, Pose::IDENTITY))
}

fn pose(place: Place) -> Pose {
    Pose::new(place.position.to_array(), place.rotation.quaternion())
}

/// Returns the largest distance of a frame or a centre of mass from its root along the tree, m; for
/// a single link at its root, the radius of gyration.
fn size(groups: &[Group]) -> f64 {
    let mut reaches: Vec<f64> = Vec::with_capacity(groups.len());
    let (mut size, mut gyration) = (0.0, 0.0);
    // The place of a base in the world does not count.
    let origin = |k: usize| groups.get(k).and_then(|group| group.members.first()).map(|m| m.pose.position);
    for (k, group) in groups.iter().enumerate() {
        let reach = group.parent.map_or(0.0, |parent| {
            let from = if parent == WORLD { origin(WORLD).unwrap_or(group.pose.position) } else { [0.0; 3] };
            reaches.get(parent).copied().unwrap_or(0.0) + length(vector(from, group.pose.position))
        });
        let from = if k == WORLD { origin(WORLD).unwrap_or_default() } else { [0.0; 3] };
        for member in &group.members {
            let center = member.in_group().map(|mass| mass.center);
            for point in std::iter::once(member.pose.position).chain(center) {
                size = f64::max(size, reach + length(vector(from, point)));
            }
            let own = member.mass.map_or(0.0, |mass| Mass { center: [0.0; 3], ..mass }.reach());
            gyration = f64::max(gyration, own);
        }
        reaches.push(reach);
    }
    f64::max(size, gyration)
}
