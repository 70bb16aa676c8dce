//! The tree that joints make of links.

use std::collections::BTreeMap;

use crate::link_error::LinkError;
use crate::model::{Joint, Name, RobotModel};

/// What each link hangs on, and an order in which every link comes after that.
#[derive(Debug)]
pub(super) struct Tree {
    /// Of each link, in the order of the file.
    pub(super) above: Vec<Above>,
    /// Every link once, from the roots outwards.
    pub(super) order: Vec<usize>,
}

/// What a link hangs on.
#[derive(Clone, Debug, Default)]
pub(super) struct Above {
    /// The link; `None` if that is the world, or nothing.
    pub(super) parent: Option<usize>,
    /// The joints by their numbers, in the order of the file; none at a root that is free.
    pub(super) joints: Vec<usize>,
}

impl Above {
    /// The joints.
    pub(super) fn joints<'m>(&self, model: &'m RobotModel) -> impl Iterator<Item = &'m Joint> {
        self.joints.iter().filter_map(|&k| model.joints.get(k))
    }
}

impl Tree {
    /// The tree of a model: found without recursion, so that no chain of joints is too long.
    pub(super) fn of(model: &RobotModel) -> Result<Self, LinkError> {
        const SPELLING: &str = "check the spelling of the names";
        const ONE_PLACE: &str = "only a tree has a place for each link: leave out the joint that closes it";
        let mut links = BTreeMap::new();
        for (k, link) in model.links.iter().enumerate() {
            if links.insert(link.name.text.as_str(), k).is_some() {
                let message = format!("two links are called {:?}", link.name.text);
                return Err(LinkError::new(message, SPELLING).at(&link.name.span));
            }
        }
        let mut above: Vec<Option<Above>> = vec![None; model.links.len()];
        for (k, joint) in model.joints.iter().enumerate() {
            let find = |name: &Name| {
                links.get(name.text.as_str()).copied().ok_or_else(|| {
                    let (joint, link) = (&joint.name.text, &name.text);
                    let message = format!("the joint {joint:?} names {link:?}, and there is no such link");
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
                    "the link {:?} hangs on two others: the second time by the joint {:?}",
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
                let message = format!("the joints above the link {:?} run in a circle", link.name.text);
                Err(LinkError::new(message, ONE_PLACE).at(&link.name.span))
            }
            None => Ok(Self { above, order }),
        }
    }

    /// The links that hang on no other, in the order of the file.
    pub(super) fn roots(&self) -> impl Iterator<Item = usize> {
        self.above.iter().enumerate().filter(|(_, above)| above.parent.is_none()).map(|(k, _)| k)
    }
}

/// Every link that a root carries, each after what it hangs on.
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
