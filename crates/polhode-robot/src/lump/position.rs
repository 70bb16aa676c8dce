//! The values of joints: those that are given, those that follow from others, and for the rest where the model is at rest.

use std::collections::HashMap;

use super::error::LumpError;
use crate::model::{Follows, Joint, JointKind, RobotModel};

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
    pub(super) fn of(model: &'a RobotModel, given: &[(String, f64)]) -> Result<Self, LumpError> {
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
                return Err(LumpError::GivenTwice { names: [other.to_owned(), name.clone()] });
            }
            if let Some(Joint { coordinate, name, .. }) = model.joints.get(k)
                && let Some(follows) = &coordinate.follows
            {
                let (joint, span) = (name.text.clone(), follows.span.clone());
                let leader = follows.leader.as_ref().map(|leader| leader.text.clone());
                return Err(LumpError::Follower { joint, leader, span });
            }
            for slots in [&mut positions.given, &mut positions.known] {
                slots.get_mut(k).into_iter().for_each(|slot| *slot = Some(*value));
            }
        }
        Ok(positions)
    }

    /// The value of a joint: leaders are asked until one knows, and then the followers on the way back.
    pub(super) fn value(&mut self, joint: usize) -> Result<f64, LumpError> {
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
                return Err(LumpError::FollowCircle {
                    joint: own.name.text.clone(),
                    leader: follows.leader.as_ref().map(|leader| leader.text.clone()).unwrap_or_default(),
                    span: follows.span.clone(),
                });
            }
            chain.push((at, follows));
            match &follows.leader {
                Some(_) => at = self.leader(own, follows)?,
                None => break 0.0,
            }
        };
        for (follower, follows) in chain.into_iter().rev() {
            value = follows.value(value).map_err(|why| {
                let name = self.model.joints.get(follower).map(|joint| joint.name.text.clone());
                LumpError::Law {
                    joint: name.unwrap_or_default(),
                    leader: follows.leader.as_ref().map(|leader| leader.text.clone()),
                    why: why.to_owned(),
                    span: follows.span.clone(),
                }
            })?;
            self.known.get_mut(follower).into_iter().for_each(|slot| *slot = Some(value));
        }
        Ok(value)
    }

    /// How far a joint is from rest; zero if it takes no value.
    pub(super) fn displacement(&mut self, k: usize) -> Result<f64, LumpError> {
        let Some(joint) = self.model.joints.get(k) else { return Ok(0.0) };
        match (takes_value(joint), &joint.coordinate.follows) {
            (true, _) => Ok(self.value(k)? - joint.coordinate.at_rest),
            (false, Some(follows)) if joint.kind != JointKind::Fixed => Err(LumpError::Law {
                joint: joint.name.text.clone(),
                leader: follows.leader.as_ref().map(|leader| leader.text.clone()),
                why: "it neither turns nor slides".to_owned(),
                span: follows.span.clone(),
            }),
            (false, _) => Ok(0.0),
        }
    }

    /// The joint that a follower names.
    fn leader(&self, follower: &Joint, follows: &Follows) -> Result<usize, LumpError> {
        let Some(name) = &follows.leader else { return Err(unknown(self.model, &follower.name.text)) };
        let found = self.numbers.get(name.text.as_str()).copied();
        let takes = |k: &usize| self.model.joints.get(*k).is_some_and(takes_value);
        match found.flatten().filter(takes) {
            Some(k) => Ok(k),
            None => Err(LumpError::Leader {
                joint: follower.name.text.clone(),
                leader: name.text.clone(),
                is_there: found.is_some(),
                meant: meant(self.model, &name.text).map(str::to_owned),
                span: follows.span.clone(),
            }),
        }
    }

    /// The positions of some joints and of those that lead them, in the order of the file.
    ///
    /// # Errors
    /// [`LumpError::Idle`] if a value is given that decides none of them.
    pub(super) fn of_joints(
        mut self,
        joints: impl Iterator<Item = usize>,
        subtree: Option<&str>,
    ) -> Result<Vec<JointPosition>, LumpError> {
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
                    let joint = joint.name.text.clone();
                    return Err(LumpError::Idle { joint, subtree: subtree.map(str::to_owned) });
                }
                _ => {}
            }
        }
        Ok(positions)
    }

    /// The value of a joint, and where it comes from; `None` if it takes none.
    fn position(&mut self, k: usize) -> Result<Option<JointPosition>, LumpError> {
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
fn unknown(model: &RobotModel, name: &str) -> LumpError {
    let movable = movable(model).map(str::to_owned).collect();
    LumpError::Joint { joint: name.to_owned(), meant: meant(model, name).map(str::to_owned), movable }
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
fn named(model: &RobotModel, name: &str) -> Result<usize, LumpError> {
    if let Some(twice) = model.joints.iter().filter(|joint| joint.name.text == name).nth(1) {
        return Err(LumpError::TwoJoints { joint: name.to_owned(), span: twice.name.span.clone() });
    }
    let is_it = |joint: &Joint| {
        let coordinate = joint.coordinate.name.as_ref().is_some_and(|own| own.text == name);
        takes_value(joint) && (coordinate || joint.name.text == name)
    };
    let mut found = model.joints.iter().enumerate().filter(|(_, joint)| is_it(joint));
    match (found.next(), found.next()) {
        (Some((_, first)), Some((_, second))) => Err(LumpError::Ambiguous {
            name: name.to_owned(),
            joints: [first.name.text.clone(), second.name.text.clone()],
            span: second.name.span.clone(),
        }),
        (Some((k, _)), None) => Ok(k),
        (None, _) => Err(unknown(model, name)),
    }
}

/// Whether the joint that takes a value under a name, its own or its coordinate's, slides: the value is a length then, and otherwise an
/// angle.
///
/// # Errors
/// [`LumpError`] if no joint takes a value under that name, or several do.
pub fn slides(model: &RobotModel, name: &str) -> Result<bool, LumpError> {
    let joint = model.joints.get(named(model, name)?);
    Ok(joint.is_some_and(|joint| joint.kind == JointKind::Prismatic))
}
