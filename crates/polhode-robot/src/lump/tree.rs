//! Kinematic tree of the links.

use std::collections::BTreeMap;

use crate::link_error::LinkError;
use crate::model::{Joint, Name, RobotModel};

/// Parent of each link, and a topological order of the links.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Parent and joints of each link, in file order.
    pub(crate) above: Vec<Above>,
    /// All links, each once, from the roots outwards.
    pub(crate) order: Vec<usize>,
}

/// Connection of a link to its parent.
#[derive(Clone, Debug, Default)]
pub(crate) struct Above {
    /// Parent link; `None` if the parent is the world or the link has none.
    pub(crate) parent: Option<usize>,
    /// Indices of the joints, in file order; empty for a free root.
    pub(crate) joints: Vec<usize>,
}

impl Above {
    /// Returns the joints to the parent.
    pub(crate) fn joints<'m>(&self, model: &'m RobotModel) -> impl Iterator<Item = &'m Joint> {
        self.joints.iter().filter_map(|&k| model.joints.get(k))
    }
}

impl Tree {
    /// Builds the tree of a model. It does not recurse, so the length of a chain is not limited.
    pub(crate) fn of(model: &RobotModel) -> Result<Self, LinkError> {
        const SPELLING: &str = "check the spelling of the names";
        const ONE_PLACE: &str =
            "the position of each link is defined only in a tree: delete the joint that closes the loop";
        let mut links = BTreeMap::new();
        for (k, link) in model.links.iter().enumerate() {
            if links.insert(link.name.text.as_str(), k).is_some() {
                let message = format!("two links have the name {:?}", link.name.text);
                return Err(LinkError::new(message, SPELLING).at(&link.name.span));
            }
        }
        let mut above: Vec<Option<Above>> = vec![None; model.links.len()];
        for (k, joint) in model.joints.iter().enumerate() {
            let find = |name: &Name| {
                links.get(name.text.as_str()).copied().ok_or_else(|| {
                    let (joint, link) = (&joint.name.text, &name.text);
                    let message =
                        format!("the joint {joint:?} names the link {link:?}, which does not exist");
                    LinkError::new(message, SPELLING).at(&name.span)
                })
            };
            let parent = joint.parent.as_ref().map(find).transpose()?;
            let child = find(&joint.child)?;
            let Some(slot) = above.get_mut(child) else { continue };
            let own = slot.get_or_insert_with(|| Above { parent, joints: Vec::new() });
            if own.parent != parent {
                let Joint { name, child, .. } = joint;
                let message = format!(
                    "the link {:?} has two parents: the second by the joint {:?}",
                    child.text, name.text
                );
                return Err(LinkError::new(message, ONE_PLACE).at(&child.span));
            }
            own.joints.push(k);
        }
        let above: Vec<Above> = above.into_iter().map(Option::unwrap_or_default).collect();
        let order = order(&above);
        let mut reached = vec![false; above.len()];
        order.iter().for_each(|&k| reached.get_mut(k).into_iter().for_each(|reached| *reached = true));
        match model.links.iter().zip(&reached).find(|(_, reached)| !**reached) {
            Some((link, _)) => {
                let message = format!("the joints above the link {:?} form a cycle", link.name.text);
                Err(LinkError::new(message, ONE_PLACE).at(&link.name.span))
            }
            None => Ok(Self { above, order }),
        }
    }

    /// Returns the links without a parent link, in file order.
    pub(crate) fn roots(&self) -> impl Iterator<Item = usize> {
        self.above.iter().enumerate().filter(|(_, above)| above.parent.is_none()).map(|(k, _)| k)
    }
}

/// Returns every link that is reachable from a root, each after its parent.
fn order(above: &[Above]) -> Vec<usize> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); above.len()];
    let mut order = Vec::with_capacity(above.len());
    for (k, above) in above.iter().enumerate() {
        match above.parent.and_then(|parent| children.get_mut(parent)) {
            Some(siblings) => siblings.push(k),
            None => order.push(k),
        }
    }
    let mut next = 0;
    while let Some(&k) = order.get(next) {
        order.extend(children.get(k).into_iter().flatten());
        next += 1;
    }
    order
}
