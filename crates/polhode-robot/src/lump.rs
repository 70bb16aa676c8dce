//! Links joined to one body: those that fixed joints hold together, or the whole robot in a position of its joints.
//!
//! The frame of a link in its parent's, with the joint at q, is
//!
//! T_parent_child(q) = T_joint · M(q),   M: x ↦ a + R(n, q)(x − a) of a turn,   x ↦ x + q n of a way,
//!
//! axis n and anchor a in the child's frame. Several joints between the same two links follow each other: T · M₁ · M₂ ….
//! The composite is [`polhode::body::assemble`]'s: masses and moments summed by parallel axes about a local point.

mod error;
mod tree;

use polhode::body::{BodyError, MassProperties, PlacedPart, assemble};
use polhode::math::{Body, Rotation};

pub use self::error::LumpError;
use self::tree::{Above, Tree};
use crate::body::{LinkMass, link_mass};
use crate::model::{Joint, JointKind, Link, ModelFormat, Pose, RobotModel};
use crate::placement::Placement;

/// Which links become one body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lumping {
    /// Those that fixed joints hold together: a body for each group, in the frame of its first link, the one nearest the root.
    Fixed,
    /// All of them: one body, in the frame of the model, which in URDF is that of the root link.
    All,
}

/// Links that are one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Lump {
    /// The link whose frame the numbers are in; `None` if that is the model's.
    pub frame: Option<String>,
    /// Its links with mass, from the root outwards.
    pub links: Vec<String>,
    /// Its links without.
    pub massless: Vec<String>,
    /// The largest change that brought a link's tensor over the edge of what is possible, kg·m²: see
    /// [`LinkBody::rounding`](crate::body::LinkBody::rounding). Zero for most.
    pub rounding: f64,
    /// Together.
    pub properties: MassProperties<Body>,
}

/// The links of a model as one body, or as few as its fixed joints make.
///
/// `positions` are values of joints by name, in rad or m; a joint that is not named is at zero. Groups without mass are left
/// out.
///
/// # Errors
/// [`LumpError`] if a link is no body, the joints are no tree, or a value has no joint.
pub fn lump(
    model: &RobotModel,
    lumping: Lumping,
    positions: &[(String, f64)],
) -> Result<Vec<Lump>, LumpError> {
    refuse_unknown(model, positions)?;
    let tree = Tree::of(model)?;
    let root = common_frame(model, &tree, lumping)?;
    let mut groups: Vec<Group> = Vec::new();
    // Of each link: its group, and where it stands in the group's frame.
    let mut places: Vec<Option<(usize, Place)>> = vec![None; model.links.len()];
    for &k in &tree.order {
        let (Some(link), Some(above)) = (model.links.get(k), tree.above.get(k)) else { continue };
        let parent = above.parent.and_then(|parent| places.get(parent).copied().flatten());
        let fixed = above.joints.iter().all(|joint| joint.kind == JointKind::Fixed);
        let (group, place) = match (lumping, parent) {
            (Lumping::All, None) => (0, moved(pose(&link.pose, &link.name.text, link)?, above, positions)?),
            (Lumping::All, Some((group, parent))) => (group, hung(parent, link, above, positions)?),
            (Lumping::Fixed, Some((group, parent))) if fixed => (group, hung(parent, link, above, &[])?),
            (Lumping::Fixed, _) => (groups.len(), Place::identity()),
        };
        if groups.len() <= group {
            let own = || Some(link.name.text.clone());
            groups.push(Group::new(if lumping == Lumping::All { root.clone() } else { own() }));
        }
        if let Some(slot) = places.get_mut(k) {
            *slot = Some((group, place));
        }
        if let Some(group) = groups.get_mut(group) {
            group.add(model.format, link, place)?;
        }
    }
    let lumps = groups.into_iter().filter(|group| !group.parts.is_empty()).map(Group::joined);
    let lumps = lumps.collect::<Result<Vec<_>, _>>()?;
    if lumps.is_empty() { Err(LumpError::Massless) } else { Ok(lumps) }
}

/// Where a link stands in its group's frame.
type Place = Placement<Body, Body>;

/// A lump in the making.
#[derive(Debug)]
struct Group {
    frame: Option<String>,
    links: Vec<String>,
    massless: Vec<String>,
    rounding: f64,
    parts: Vec<PlacedPart>,
}

impl Group {
    const fn new(frame: Option<String>) -> Self {
        Self { frame, links: Vec::new(), massless: Vec::new(), rounding: 0.0, parts: Vec::new() }
    }

    fn add(&mut self, format: ModelFormat, link: &Link, place: Place) -> Result<(), LumpError> {
        let name = &link.name.text;
        match link_mass(format, link).map_err(|error| LumpError::Link { link: name.clone(), error })? {
            LinkMass::None => self.massless.push(name.clone()),
            LinkMass::Body(body) => {
                let rotation = place.rotation * Rotation::identity();
                let part = PlacedPart::new(body.properties, place.position, rotation);
                self.parts.push(part.map_err(|error| LumpError::Joined { link: name.clone(), error })?);
                self.links.push(name.clone());
                self.rounding = self.rounding.max(body.rounding);
            }
        }
        Ok(())
    }

    fn joined(self) -> Result<Lump, LumpError> {
        let Self { frame, links, massless, rounding, parts } = self;
        let properties = assemble(&parts).map_err(|error| {
            // The first that the first cannot be joined to, or the last of a sum that is too large.
            let fails =
                |part: &&PlacedPart| parts.first().is_some_and(|first| assemble(&[*first, **part]).is_err());
            let culprit = parts.iter().skip(1).position(|part| fails(&part)).map_or(links.len(), |k| k + 2);
            let link = links.get(culprit.saturating_sub(1)).cloned().unwrap_or_default();
            LumpError::Joined { link, error }
        })?;
        Ok(Lump { frame, links, massless, rounding, properties })
    }
}

/// The name of the link whose frame is the model's: the only root of a URDF.
fn common_frame(model: &RobotModel, tree: &Tree<'_>, lumping: Lumping) -> Result<Option<String>, LumpError> {
    if lumping == Lumping::Fixed || model.format != ModelFormat::Urdf {
        return Ok(None);
    }
    let mut roots = tree.roots().filter_map(|k| model.links.get(k));
    match (roots.next(), roots.next()) {
        (Some(first), Some(second)) => Err(LumpError::TwoRoots {
            links: [first.name.text.clone(), second.name.text.clone()],
            span: second.name.span.clone(),
        }),
        (first, _) => Ok(first.map(|link| link.name.text.clone())),
    }
}

/// Where a link stands that hangs on another.
fn hung(
    parent: Place,
    link: &Link,
    above: &Above<'_>,
    positions: &[(String, f64)],
) -> Result<Place, LumpError> {
    let joint = match above.joints.first() {
        Some(joint) => pose(&joint.pose, &joint.name.text, link)?,
        None => Place::identity(),
    };
    moved(parent.then(joint), above, positions)
}

/// The place after the motions of the joints there.
fn moved(place: Place, above: &Above<'_>, positions: &[(String, f64)]) -> Result<Place, LumpError> {
    above.joints.iter().try_fold(place, |place, joint| {
        let q = positions.iter().rev().find(|(name, _)| *name == joint.name.text).map_or(0.0, |(_, q)| *q);
        let motion = Place::motion(joint, q)
            .ok_or_else(|| LumpError::Pose { subject: joint.name.text.clone(), span: joint.span.clone() })?;
        Ok(place.then(motion))
    })
}

/// The placement of a pose in which every number could be read.
fn pose(pose: &Pose, subject: &str, link: &Link) -> Result<Place, LumpError> {
    let wrong = || LumpError::Pose {
        subject: subject.to_owned(),
        span: pose.span.clone().unwrap_or_else(|| link.span.clone()),
    };
    if !pose.unreadable.is_empty() {
        return Err(wrong());
    }
    Place::of(pose).map_err(|_: BodyError| wrong())
}

/// Every value has a joint that takes it.
fn refuse_unknown(model: &RobotModel, positions: &[(String, f64)]) -> Result<(), LumpError> {
    let takes = |joint: &&Joint| matches!(joint.kind, JointKind::Revolute | JointKind::Prismatic);
    let movable = || model.joints.iter().filter(takes).map(|joint| joint.name.text.as_str());
    match positions.iter().find(|(name, q)| !q.is_finite() || !movable().any(|joint| joint == name)) {
        None => Ok(()),
        Some((joint, _)) => {
            Err(LumpError::Joint { joint: joint.clone(), movable: movable().map(str::to_owned).collect() })
        }
    }
}
