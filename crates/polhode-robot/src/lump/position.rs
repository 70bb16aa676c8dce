//! Joint values: given, coupled to other joints, or at rest by default.

use std::collections::HashMap;

use polhode_document::layout::printable;

use crate::link_error::{LinkError, suggested};
use crate::model::{Follows, Joint, JointKind, Name, RobotModel};

/// Value of a joint, and its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPosition {
    /// Name of the joint.
    pub joint: String,
    /// Value, rad; m for a sliding joint.
    pub value: f64,
    /// True for a sliding joint, false for a rotating one.
    pub slides: bool,
    /// Origin of the value.
    pub by: PositionBy,
    /// Lower and upper limit in the model.
    pub limits: Option<[f64; 2]>,
}

/// Origin of a joint value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PositionBy {
    /// Value given by the user.
    Given,
    /// Value coupled to the leading joint; `None` if the model fixes it at a constant.
    Leader(Option<String>),
    /// Default: the joint is at rest.
    Rest,
}

impl JointPosition {
    /// Returns true if the value is outside the limits by more than rounding.
    pub fn is_outside(&self) -> bool {
        self.limits.is_some_and(|[lower, upper]| {
            let finite = |limit: f64| if limit.is_finite() { limit.abs() } else { 0.0 };
            let rounding = 1e-12 * (finite(lower) + finite(upper));
            self.value < lower - rounding || self.value > upper + rounding
        })
    }
}

/// Returns true if a joint takes a value: it rotates or slides.
pub(super) const fn takes_value(joint: &Joint) -> bool {
    matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic)
}

/// Joint values of a model.
#[derive(Debug)]
pub(super) struct Positions<'a> {
    model: &'a RobotModel,
    /// Joint index by name; `None` if two joints have the same name.
    numbers: HashMap<&'a str, Option<usize>>,
    /// Given value of each joint.
    given: Vec<Option<f64>>,
    /// Known value of each joint so far.
    known: Vec<Option<f64>>,
}

impl<'a> Positions<'a> {
    /// Sets the given values by name. If a name occurs twice, the later value counts.
    pub(super) fn of(model: &'a RobotModel, given: &[(String, f64)]) -> Result<Self, LinkError> {
        let mut numbers = HashMap::new();
        for (k, joint) in model.joints.iter().enumerate() {
            numbers.entry(joint.name.text.as_str()).and_modify(|number| *number = None).or_insert(Some(k));
        }
        let nothing = || vec![None; model.joints.len()];
        let mut positions = Self { model, numbers, given: nothing(), known: nothing() };
        let mut names: HashMap<usize, &str> = HashMap::new();
        for (name, value) in given {
            let k = named(model, name)?;
            if !value.is_finite() {
                return Err(unknown(model, name));
            }
            if let Some(other) = names.insert(k, name).filter(|other| other != name) {
                let message = format!("{other:?} and {name:?} are the same joint, but both have a value");
                return Err(LinkError::new(message, "delete one of the two"));
            }
            if let Some(Joint { coordinate, name, .. }) = model.joints.get(k)
                && let Some(follows) = &coordinate.follows
            {
                return Err(follower(&name.text, follows));
            }
            for slots in [&mut positions.given, &mut positions.known] {
                slots.get_mut(k).into_iter().for_each(|slot| *slot = Some(*value));
            }
        }
        Ok(positions)
    }

    /// Returns the value of a joint. It follows the leaders until one is known, then evaluates the
    /// followers on the way back.
    pub(super) fn value(&mut self, joint: usize) -> Result<f64, LinkError> {
        let mut chain: Vec<(usize, &'a Follows)> = Vec::new();
        let mut at = joint;
        let mut value = loop {
            if let Some(known) = self.known.get(at).copied().flatten() {
                break known;
            }
            let Some(own) = self.model.joints.get(at) else { break 0.0 };
            let Some(follows) = &own.coordinate.follows else {
                break own.coordinate.at_rest;
            };
            if chain.len() > self.model.joints.len() {
                let leader = follows.leader.as_ref().map_or("", |leader| &leader.text);
                let message =
                    format!("the joint {:?} follows {leader:?} in a cycle of coupled joints", own.name.text);
                return Err(LinkError::new(
                    message,
                    "remove the coupling of one of them, which then leads the others",
                )
                .at(&follows.span));
            }
            chain.push((at, follows));
            match &follows.leader {
                Some(_) => at = self.leader(own, follows)?,
                None => break 0.0,
            }
        };
        for (follower, follows) in chain.into_iter().rev() {
            value = follows.value(value).map_err(|why| {
                let joint = self.model.joints.get(follower).map_or("", |joint| &joint.name.text);
                lawless(joint, follows, why)
            })?;
            self.known.get_mut(follower).into_iter().for_each(|slot| *slot = Some(value));
        }
        Ok(value)
    }

    /// Returns the displacement of a joint from rest; zero if it takes no value.
    pub(super) fn displacement(&mut self, k: usize) -> Result<f64, LinkError> {
        let Some(joint) = self.model.joints.get(k) else { return Ok(0.0) };
        match (takes_value(joint), &joint.coordinate.follows) {
            (true, _) => Ok(self.value(k)? - joint.coordinate.at_rest),
            (false, Some(follows)) if joint.kind != JointKind::Fixed => {
                Err(lawless(&joint.name.text, follows, "it neither rotates nor slides"))
            }
            (false, _) => Ok(0.0),
        }
    }

    /// Returns the leading joint that a follower names.
    fn leader(&self, follower: &Joint, follows: &Follows) -> Result<usize, LinkError> {
        let Some(name) = &follows.leader else { return Err(unknown(self.model, &follower.name.text)) };
        let found = self.numbers.get(name.text.as_str()).copied();
        let takes = |k: &usize| self.model.joints.get(*k).is_some_and(takes_value);
        match found.flatten().filter(takes) {
            Some(k) => Ok(k),
            None => {
                let why = match found {
                    None => "which does not exist",
                    Some(_) => "which is not a single rotating or sliding joint",
                };
                let message = format!("the joint {:?} follows {:?}, {why}", follower.name.text, name.text);
                let hint = match meant(self.model, &name.text) {
                    Some(meant) => format!("did you mean {}?", printable(meant)),
                    None => "name a joint that rotates or slides".to_owned(),
                };
                Err(LinkError::new(message, hint).at(&follows.span))
            }
        }
    }

    /// Returns the values of some joints and of the joints that lead them, in file order.
    ///
    /// # Errors
    /// [`LinkError`] if a given value determines none of these joints.
    pub(super) fn of_joints(
        mut self,
        joints: impl Iterator<Item = usize>,
        subtree: Option<&str>,
    ) -> Result<Vec<JointPosition>, LinkError> {
        let mut decides = vec![false; self.model.joints.len()];
        for joint in joints {
            let mut next = Some(joint);
            // A marked joint has marked its own leaders.
            while let Some((k, mark)) = next.and_then(|k| Some((k, decides.get_mut(k)?)))
                && !*mark
            {
                *mark = true;
                let own = self.model.joints.get(k);
                let follows = own.and_then(|own| Some((own, own.coordinate.follows.as_ref()?)));
                let leader = follows.filter(|(_, follows)| follows.leader.is_some());
                next = leader.map(|(own, follows)| self.leader(own, follows)).transpose()?;
            }
        }
        let mut positions = Vec::new();
        for (k, joint) in self.model.joints.iter().enumerate() {
            let is_given = self.given.get(k).copied().flatten().is_some();
            match decides.get(k) {
                Some(true) => positions.extend(self.position(k)?),
                _ if is_given => {
                    let what = match subtree {
                        Some(link) => format!("below the link {link:?}"),
                        None => "within a group of links fixed together".to_owned(),
                    };
                    let message = format!("the joint {:?} moves nothing {what}", joint.name.text);
                    return Err(LinkError::new(message, "leave it out"));
                }
                _ => {}
            }
        }
        Ok(positions)
    }

    /// Returns the value of a joint and its origin; `None` if it takes none.
    fn position(&mut self, k: usize) -> Result<Option<JointPosition>, LinkError> {
        let Some(joint) = self.model.joints.get(k).filter(|joint| takes_value(joint)) else {
            return Ok(None);
        };
        let value = self.value(k)?;
        let by = match &joint.coordinate.follows {
            Some(follows) => PositionBy::Leader(follows.leader.as_ref().map(|leader| leader.text.clone())),
            None if self.given.get(k).copied().flatten().is_some() => PositionBy::Given,
            None => PositionBy::Rest,
        };
        Ok(Some(JointPosition {
            joint: joint.name.text.clone(),
            value,
            slides: joint.kind == JointKind::Prismatic,
            by,
            limits: joint.coordinate.limits,
        }))
    }
}

/// Returns the error for a name under which no joint takes a value.
fn unknown(model: &RobotModel, name: &str) -> LinkError {
    let movable: Vec<&str> = movable(model).collect();
    let hint = match movable.as_slice() {
        [] => "this model has no joint that takes a value".to_owned(),
        movable => suggested(meant(model, name), "the joints that take a value are", movable),
    };
    LinkError::new(format!("unknown joint {name:?}, or it takes no value"), hint)
}

/// Returns the error for a given value of a joint that is coupled or constant.
fn follower(joint: &str, follows: &Follows) -> LinkError {
    let (message, hint) = match &follows.leader {
        Some(Name { text: leader, .. }) => (
            format!("the joint {joint:?} follows {leader:?} and takes no value of its own"),
            format!("set a value for {} instead", printable(leader)),
        ),
        None => {
            (format!("the joint {joint:?} is constrained to a constant value"), "leave it out".to_owned())
        }
    };
    LinkError::new(message, hint).at(&follows.span)
}

/// Returns the error for a coupled or constant joint whose law is unknown.
fn lawless(joint: &str, follows: &Follows, why: &str) -> LinkError {
    let message = match &follows.leader {
        Some(Name { text: leader, .. }) => {
            format!("the joint {joint:?} follows {leader:?}, but the relation cannot be read: {why}")
        }
        None => format!("the joint {joint:?} is constrained to a value that cannot be read: {why}"),
    };
    LinkError::new(message, "write numbers, or delete the coupling from the file").at(&follows.span)
}

/// Returns the joint name nearest to a misspelled one.
fn meant<'a>(model: &'a RobotModel, name: &str) -> Option<&'a str> {
    polhode_source::nearest(name, movable(model))
}

/// Returns the joints that take an independent value.
fn movable(model: &RobotModel) -> impl Iterator<Item = &str> {
    let leads = |joint: &&Joint| takes_value(joint) && joint.coordinate.follows.is_none();
    model.joints.iter().filter(leads).map(|joint| joint.name.text.as_str())
}

/// Returns the joint that takes a value under its own name or its coordinate's name.
fn named(model: &RobotModel, name: &str) -> Result<usize, LinkError> {
    if let Some(twice) = model.joints.iter().filter(|joint| joint.name.text == name).nth(1) {
        let message = format!("two joints have the name {name:?}");
        return Err(LinkError::new(message, "rename one of them").at(&twice.name.span));
    }
    let is_it = |joint: &Joint| {
        let coordinate = joint.coordinate.name.as_ref().is_some_and(|own| own.text == name);
        takes_value(joint) && (coordinate || joint.name.text == name)
    };
    let mut found = model.joints.iter().enumerate().filter(|(_, joint)| is_it(joint));
    match (found.next(), found.next()) {
        (Some((_, first)), Some((_, second))) => {
            let joints = [first, second].map(|joint| joint.name.text.as_str());
            let [a, b] = joints;
            let hint = match joints.into_iter().find(|joint| *joint != name) {
                Some(other) => {
                    format!("{} has that coordinate: use names that only one joint has", printable(other))
                }
                None => "rename one of them".to_owned(),
            };
            let message = format!("the joints {a:?} and {b:?} both take a value by the name {name:?}");
            Err(LinkError::new(message, hint).at(&second.name.span))
        }
        (Some((k, _)), None) => Ok(k),
        (None, _) => Err(unknown(model, name)),
    }
}

/// Returns true if the joint with this name, or this coordinate name, slides. Its value is then a
/// length, otherwise an angle.
///
/// # Errors
/// [`LinkError`] if no joint takes a value under that name, or if several do.
pub fn slides(model: &RobotModel, name: &str) -> Result<bool, LinkError> {
    let joint = model.joints.get(named(model, name)?);
    Ok(joint.is_some_and(|joint| joint.kind == JointKind::Prismatic))
}
