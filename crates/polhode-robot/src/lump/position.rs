//! The values of joints: those that are given, those that follow from others, and for the rest where the model is at rest.

use std::collections::HashMap;

use polhode_document::layout::printable;

use crate::link_error::{LinkError, suggested};
use crate::model::{Follows, Joint, JointKind, Name, RobotModel};

/// The value of a joint, and where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPosition {
    /// The joint.
    pub joint: String,
    /// rad, or m if it slides.
    pub value: f64,
    /// True if it slides, false if it turns.
    pub slides: bool,
    /// Who says so.
    pub by: PositionBy,
    /// The least and the greatest value that the model allows.
    pub limits: Option<[f64; 2]>,
}

/// Who says what value a joint has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PositionBy {
    /// The user.
    Given,
    /// The joint that leads it; `None` if the model holds it at a constant.
    Leader(Option<String>),
    /// Nobody: it is at rest.
    Rest,
}

impl JointPosition {
    /// Whether the model does not allow the value, rounding aside.
    pub fn is_outside(&self) -> bool {
        self.limits.is_some_and(|[lower, upper]| {
            let finite = |limit: f64| if limit.is_finite() { limit.abs() } else { 0.0 };
            let rounding = 1e-12 * (finite(lower) + finite(upper));
            self.value < lower - rounding || self.value > upper + rounding
        })
    }
}

/// Whether a joint takes a value.
pub(super) const fn takes_value(joint: &Joint) -> bool {
    matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic)
}

/// The joints of a model with what is given.
#[derive(Debug)]
pub(super) struct Positions<'a> {
    model: &'a RobotModel,
    /// By names of joints; of two with the same name none.
    numbers: HashMap<&'a str, Option<usize>>,
    /// Of each joint, what is given.
    given: Vec<Option<f64>>,
    /// Of each joint, what is known by now.
    known: Vec<Option<f64>>,
}

impl<'a> Positions<'a> {
    /// Values by name; of two under the same name the later counts.
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
                let message = format!("{other:?} and {name:?} are one joint, and each is given a value");
                return Err(LinkError::new(message, "leave one of them out"));
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

    /// The value of a joint: leaders are asked until one knows, and then the followers on the way back.
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
                let message = format!(
                    "the joint {:?} follows {leader:?}, and joints follow each other in a circle there",
                    own.name.text
                );
                return Err(
                    LinkError::new(message, "let one of them lead, and follow none").at(&follows.span)
                );
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

    /// How far a joint is from rest; zero if it takes no value.
    pub(super) fn displacement(&mut self, k: usize) -> Result<f64, LinkError> {
        let Some(joint) = self.model.joints.get(k) else { return Ok(0.0) };
        match (takes_value(joint), &joint.coordinate.follows) {
            (true, _) => Ok(self.value(k)? - joint.coordinate.at_rest),
            (false, Some(follows)) if joint.kind != JointKind::Fixed => {
                Err(lawless(&joint.name.text, follows, "it neither turns nor slides"))
            }
            (false, _) => Ok(0.0),
        }
    }

    /// The joint that a follower names.
    fn leader(&self, follower: &Joint, follows: &Follows) -> Result<usize, LinkError> {
        let Some(name) = &follows.leader else { return Err(unknown(self.model, &follower.name.text)) };
        let found = self.numbers.get(name.text.as_str()).copied();
        let takes = |k: &usize| self.model.joints.get(*k).is_some_and(takes_value);
        match found.flatten().filter(takes) {
            Some(k) => Ok(k),
            None => {
                let why = match found {
                    None => "and there is no such joint",
                    Some(_) => "which is not one joint that turns or slides",
                };
                let message = format!("the joint {:?} follows {:?}, {why}", follower.name.text, name.text);
                let hint = match meant(self.model, &name.text) {
                    Some(meant) => format!("did you mean {}?", printable(meant)),
                    None => "name a joint that turns or slides".to_owned(),
                };
                Err(LinkError::new(message, hint).at(&follows.span))
            }
        }
    }

    /// The positions of some joints and of those that lead them, in the order of the file.
    ///
    /// # Errors
    /// [`LinkError`] if a value is given that decides none of them.
    pub(super) fn of_joints(
        mut self,
        joints: impl Iterator<Item = usize>,
        subtree: Option<&str>,
    ) -> Result<Vec<JointPosition>, LinkError> {
        let mut decides = vec![false; self.model.joints.len()];
        for joint in joints {
            let mut next = Some(joint);
            // what is marked has marked its own leaders
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
                        Some(link) => format!("that hangs from the link {link:?}"),
                        None => "within what fixed joints hold together".to_owned(),
                    };
                    let message = format!("the joint {:?} moves nothing {what}", joint.name.text);
                    return Err(LinkError::new(message, "leave it out"));
                }
                _ => {}
            }
        }
        Ok(positions)
    }

    /// The value of a joint, and where it comes from; `None` if it takes none.
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

/// No joint of that name takes a value.
fn unknown(model: &RobotModel, name: &str) -> LinkError {
    let movable: Vec<&str> = movable(model).collect();
    let hint = match movable.as_slice() {
        [] => "no joint of this model takes a value".to_owned(),
        movable => suggested(meant(model, name), "those that take a value are", movable),
    };
    LinkError::new(format!("there is no joint {name:?} that takes a value"), hint)
}

/// Error of a value for a joint that follows another one, or is held at a constant.
fn follower(joint: &str, follows: &Follows) -> LinkError {
    let (message, hint) = match &follows.leader {
        Some(Name { text: leader, .. }) => (
            format!("the joint {joint:?} follows {leader:?}, and takes no value of its own"),
            format!("leave it out, and give a value to {}", printable(leader)),
        ),
        None => (
            format!("the joint {joint:?} is held at a constant, and takes no value"),
            "leave it out".to_owned(),
        ),
    };
    LinkError::new(message, hint).at(&follows.span)
}

/// Error of a joint that follows another one, or is held, in a way that is not known.
fn lawless(joint: &str, follows: &Follows, why: &str) -> LinkError {
    let message = match &follows.leader {
        Some(Name { text: leader, .. }) => {
            format!("the joint {joint:?} follows {leader:?}, but not in a way that is known: {why}")
        }
        None => format!("the joint {joint:?} is held at a value that is not known: {why}"),
    };
    LinkError::new(message, "write numbers, or take the coupling out of the file").at(&follows.span)
}

/// The joint that was probably meant.
fn meant<'a>(model: &'a RobotModel, name: &str) -> Option<&'a str> {
    polhode_source::nearest(name, movable(model))
}

/// The joints that take a value of their own.
fn movable(model: &RobotModel) -> impl Iterator<Item = &str> {
    let leads = |joint: &&Joint| takes_value(joint) && joint.coordinate.follows.is_none();
    model.joints.iter().filter(leads).map(|joint| joint.name.text.as_str())
}

/// The joint that takes a value under a name, its own or its coordinate's.
fn named(model: &RobotModel, name: &str) -> Result<usize, LinkError> {
    if let Some(twice) = model.joints.iter().filter(|joint| joint.name.text == name).nth(1) {
        let message = format!("two joints are called {name:?}");
        return Err(LinkError::new(message, "give each a name of its own").at(&twice.name.span));
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
                    format!("{} has that coordinate: name joints that have a name alone", printable(other))
                }
                None => "give each a name of its own".to_owned(),
            };
            let message = format!("the joints {a:?} and {b:?} both take a value as {name:?}");
            Err(LinkError::new(message, hint).at(&second.name.span))
        }
        (Some((k, _)), None) => Ok(k),
        (None, _) => Err(unknown(model, name)),
    }
}

/// Whether the joint that takes a value under a name, its own or its coordinate's, slides: the value is a length then, and otherwise an
/// angle.
///
/// # Errors
/// [`LinkError`] if no joint takes a value under that name, or several do.
pub fn slides(model: &RobotModel, name: &str) -> Result<bool, LinkError> {
    let joint = model.joints.get(named(model, name)?);
    Ok(joint.is_some_and(|joint| joint.kind == JointKind::Prismatic))
}
