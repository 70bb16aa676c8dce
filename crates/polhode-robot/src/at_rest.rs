//! Poses of a model's links with all joints at zero.

use std::collections::HashMap;

use crate::model::{Joint, ModelFormat, Pose, RobotModel};

/// Poses of all links in the model's frame, with all joints at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct AtRest {
    /// Poses, in the order of the model's links.
    pub poses: Vec<Pose>,
    /// Links without a known pose: on a cycle, on a missing link, or beyond the range of f64. They
    /// are placed at the origin.
    pub unplaced: Vec<usize>,
}

impl AtRest {
    /// Returns the poses of a model, which need not be a tree.
    pub fn of(model: &RobotModel) -> Self {
        let is_finite = |pose: &Pose| pose.position.iter().chain(&pose.rotation).all(|x| x.is_finite());
        let poses = match model.format {
            ModelFormat::Urdf | ModelFormat::Osim => down_the_tree(model),
            // These formats give the poses of links directly.
            ModelFormat::Sdf | ModelFormat::Mjcf | ModelFormat::Usd => {
                model.links.iter().map(|link| Some(link.pose.clone())).collect()
            }
        };
        let mut unplaced = Vec::new();
        let poses = poses.into_iter().enumerate().map(|(k, pose)| {
            pose.filter(is_finite).unwrap_or_else(|| {
                unplaced.push(k);
                Pose::IDENTITY
            })
        });
        Self { poses: poses.collect(), unplaced }
    }
}

/// Returns the poses of links from the joints that carry them, the first if there are several;
/// `None` for links not connected to a root.
fn down_the_tree(model: &RobotModel) -> Vec<Option<Pose>> {
    let mut numbers: HashMap<&str, usize> = HashMap::with_capacity(model.links.len());
    for (k, link) in model.links.iter().enumerate() {
        numbers.entry(link.name.text.as_str()).or_insert(k);
    }
    let mut carried: Vec<Option<&Joint>> = vec![None; model.links.len()];
    for joint in &model.joints {
        let child = numbers.get(joint.child.text.as_str()).and_then(|&child| carried.get_mut(child));
        if let Some(slot @ None) = child {
            *slot = Some(joint);
        }
    }
    let mut carries: Vec<Vec<(usize, &Joint)>> = vec![Vec::new(); model.links.len()];
    let mut poses: Vec<Option<Pose>> = vec![None; model.links.len()];
    let mut reached = Vec::with_capacity(model.links.len());
    for (k, joint) in carried.into_iter().enumerate() {
        let root = match joint {
            None => Some(Pose::IDENTITY),
            Some(joint) => match joint.parent.as_ref() {
                None => Some(joint.pose.clone()),
                Some(parent) => {
                    let parent =
                        numbers.get(parent.text.as_str()).and_then(|&parent| carries.get_mut(parent));
                    parent.into_iter().for_each(|children| children.push((k, joint)));
                    None
                }
            },
        };
        if let (Some(pose), Some(slot)) = (root, poses.get_mut(k)) {
            *slot = Some(pose);
            reached.push(k);
        }
    }
    let mut next = 0;
    while let Some(&k) = reached.get(next) {
        next += 1;
        let Some(outer) = poses.get(k).cloned().flatten() else { continue };
        for &(child, joint) in carries.get(k).into_iter().flatten() {
            if let Some(slot) = poses.get_mut(child) {
                *slot = Some(outer.then(&joint.pose));
                reached.push(child);
            }
        }
    }
    poses
}
