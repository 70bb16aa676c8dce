//! Links joined to one body: groups joined by fixed joints, the whole robot at given joint values,
//! or a subtree.
//!
//! The pose of a link in its parent's frame, with the joint displaced by q from rest, is
//!
//! T_parent_child(q) = T_joint · M(q),   M: x ↦ a + R(n, q)(x − a) for a rotation,   x ↦ x + q n
//! for a translation,
//!
//! with axis n and anchor a in the child's frame. Several joints between the same two links are
//! applied in sequence: T · M₁ · M₂ ….
//! [`polhode::body::assemble`] forms the composite: it sums masses and moments by the parallel-axis
//! theorem about a local point.

mod drive;
mod position;
mod tree;

use std::collections::HashSet;

use polhode::body::{BodyError, MassProperties, PlacedPart, assemble};
use polhode::math::{Body, Rotation};

use self::drive::drives;
use self::position::Positions;
pub(crate) use self::tree::{Above, Tree};
use crate::body::{LinkMass, link_mass};
use crate::link_error::{LinkError, suggested};
use crate::model::{Joint, JointKind, Link, ModelFormat, Name, Pose, RobotModel, Span, UnreadBodies};
use crate::placement::Placement;

pub use self::drive::Drive;
pub use self::position::{JointPosition, PositionBy, slides};

/// Selection of the links that are joined to one body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lumping<'a> {
    /// Links joined by fixed joints: one body for each group, in the frame of its first link, the
    /// nearest to the root.
    Fixed,
    /// All links: one body, in the frame of the model. In URDF this is the frame of the root link.
    All,
    /// Subtree: a link and all its descendants as one body, in the frame of that link.
    Subtree(&'a str),
}

/// Links joined to one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Lump {
    /// Link whose frame is the reference frame; `None` for the frame of the model.
    pub frame: Option<String>,
    /// Links with mass, from the root outwards.
    pub links: Vec<String>,
    /// Links without mass.
    pub massless: Vec<String>,
    /// Values of the joints between the links, and of the joints that lead these.
    pub positions: Vec<JointPosition>,
    /// Movable joints between the links that take no value, such as floating and ball joints. They
    /// are held at the pose in the file.
    pub held: Vec<String>,
    /// Joints that carry the body, with the inertia that their motors move. Only for
    /// [`Lumping::Subtree`].
    pub drives: Vec<Drive>,
    /// Links without usable mass properties, which [`lump_valid`] leaves out, with the reasons; those
    /// of groups without any other link are in the first body.
    pub left_out: Vec<LinkError>,
    /// Largest correction that made the tensor of a link physical, kg·m²; see
    /// [`LinkBody::rounding`](crate::body::LinkBody::rounding). Usually zero.
    pub rounding: f64,
    /// Mass properties of the joined links.
    pub properties: MassProperties<Body>,
}

/// Joins the links of a model to one body, or to one body for each group of fixed joints.
///
/// `positions` are joint values by name, rad or m. The value of a coupled joint follows from its
/// leader; it cannot be given. Any other joint without a value is at rest: at zero, or at `ref` in
/// MJCF, as the file draws it. Groups without mass are omitted.
///
/// ```
/// use polhode_robot::{lump::{Lumping, lump}, read::{ReadOptions, read_text}};
/// let inertial = r#"<inertial><mass value="2"/>
///     <inertia ixx="0.2" ixy="0" ixz="0" iyy="0.3" iyz="0" izz="0.4"/></inertial>"#;
/// let text = format!(r#"<robot><link name="palm">{inertial}</link>
///     <link name="left">{inertial}</link><link name="right">{inertial}</link>
///     <joint name="l" type="prismatic"><parent link="palm"/><child link="left"/><axis xyz="0 1 0"/></joint>
///     <joint name="r" type="prismatic"><parent link="palm"/><child link="right"/><axis xyz="0 1 0"/>
///         <mimic joint="l" multiplier="-0.5"/></joint></robot>"#);
/// let model = read_text(&text, "gripper.urdf".as_ref(), &ReadOptions::default())?;
/// let whole = lump(&model, Lumping::All, &[("l".to_owned(), 0.6)]).unwrap().remove(0);
/// assert!((whole.properties.center_of_mass().to_array()[1] - (0.6 - 0.3) / 3.0).abs() < 1e-15);
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
///
/// # Errors
/// [`LinkError`] if a link has unphysical mass properties, if bodies are not read, if the joints do
/// not form a tree, or if a given value has no joint, moves nothing, or is not determined.
pub fn lump(
    model: &RobotModel,
    lumping: Lumping<'_>,
    positions: &[(String, f64)],
) -> Result<Vec<Lump>, LinkError> {
    lump_valid(model, lumping, positions)?
        .into_iter()
        .map(|mut lump| if lump.left_out.is_empty() { Ok(lump) } else { Err(lump.left_out.swap_remove(0)) })
        .collect()
}

/// Joins the links that have usable mass properties, as [`lump`] does; the others are in
/// [`Lump::left_out`], and their mass is missing in the result.
///
/// # Errors
/// [`LinkError`] as for [`lump`], except for links without usable mass properties; if no other link
/// has mass, the error of the first one.
pub fn lump_valid(
    model: &RobotModel,
    lumping: Lumping<'_>,
    positions: &[(String, f64)],
) -> Result<Vec<Lump>, LinkError> {
    let mut positions = Positions::of(model, positions)?;
    let tree = Tree::of(model)?;
    let (root, frame) = match lumping {
        Lumping::Fixed => (None, None),
        Lumping::All => (None, common_frame(model, &tree)?),
        Lumping::Subtree(name) => (Some(link_named(model, name)?), Some(name.to_owned())),
    };
    let mut groups: Vec<Group> = Vec::new();
    // For each link: its group, and its pose in the group's frame.
    let mut places: Vec<Option<(usize, Place)>> = match lumping {
        Lumping::Fixed => rigid(model, &tree)?,
        Lumping::All | Lumping::Subtree(_) => vec![None; model.links.len()],
    };
    let mut moving = Vec::new();
    for &k in &tree.order {
        let (Some(link), Some(above)) = (model.links.get(k), tree.above.get(k)) else { continue };
        let parent = above.parent.and_then(|parent| places.get(parent).copied().flatten());
        let (group, place) = match (lumping, parent) {
            (Lumping::Subtree(_), _) if root == Some(k) => (0, Place::identity()),
            (Lumping::Subtree(_), None) => continue,
            (Lumping::Fixed, _) => {
                let Some(own) = places.get(k).copied().flatten() else { continue };
                own
            }
            (Lumping::All | Lumping::Subtree(_), _) => {
                moving.extend(&above.joints);
                let at_rest = match parent {
                    Some((_, parent)) => parent.then(at_rest(model, link, above)?),
                    None => in_model(model, link, above)?,
                };
                (0, moved(at_rest, model, above, &mut positions)?)
            }
        };
        if groups.len() <= group {
            let own = || Some(link.name.text.clone());
            groups.push(Group::new(if lumping == Lumping::Fixed { own() } else { frame.clone() }));
        }
        if let Some(slot) = places.get_mut(k) {
            *slot = Some((group, place));
        }
        if let Some(group) = groups.get_mut(group) {
            group.add(model.format, link, place)?;
        }
    }
    let subtree = match lumping {
        Lumping::Subtree(name) => Some(name),
        Lumping::Fixed | Lumping::All => None,
    };
    let joined = model.links.iter().zip(&places).filter(|(_, place)| place.is_some());
    let joined: HashSet<&str> = joined.map(|(link, _)| link.name.text.as_str()).collect();
    require_bodies(model, subtree.map(|_| &joined))?;
    let held: Vec<String> = held(model, &moving);
    let positions = positions.of_joints(moving.into_iter(), subtree)?;
    let empty = groups.iter_mut().filter(|group| group.parts.is_empty());
    let mut left_out: Vec<LinkError> = empty.flat_map(|group| std::mem::take(&mut group.left_out)).collect();
    let lumps = groups
        .into_iter()
        .filter(|group| !group.parts.is_empty())
        .map(|group| group.joined(&positions, &held));
    let mut lumps = lumps.collect::<Result<Vec<_>, _>>()?;
    if let (Some(lump), Some(above)) = (lumps.first_mut(), root.and_then(|root| tree.above.get(root))) {
        lump.drives = drives(model, above, &lump.properties);
    }
    match lumps.first_mut() {
        Some(first) => first.left_out.append(&mut left_out),
        None => return Err(left_out.into_iter().next().unwrap_or_else(|| LinkError::massless(subtree))),
    }
    Ok(lumps)
}

/// Returns for each link the number of its group of fixed joints, and its pose in the frame of the
/// group's first link. Groups are numbered in the order of their first links, from the root
/// outwards.
pub(crate) fn rigid(model: &RobotModel, tree: &Tree) -> Result<Vec<Option<(usize, Place)>>, LinkError> {
    let mut places: Vec<Option<(usize, Place)>> = vec![None; model.links.len()];
    let mut count = 0;
    for &k in &tree.order {
        let (Some(link), Some(above)) = (model.links.get(k), tree.above.get(k)) else { continue };
        let parent = above.parent.and_then(|parent| places.get(parent).copied().flatten());
        let own = match parent.filter(|_| above.joints(model).all(|joint| joint.kind == JointKind::Fixed)) {
            Some((group, parent)) => (group, parent.then(at_rest(model, link, above)?)),
            None => {
                count += 1;
                (count - 1, Place::identity())
            }
        };
        if let Some(slot) = places.get_mut(k) {
            *slot = Some(own);
        }
    }
    Ok(places)
}

/// Returns an error if these links contain bodies that are not read. `None` means all links and the
/// world.
pub(crate) fn require_bodies(model: &RobotModel, links: Option<&HashSet<&str>>) -> Result<(), LinkError> {
    let is_in = |unread: &&UnreadBodies| match (links, &unread.link) {
        (None, _) => true,
        (Some(links), Some(link)) => links.contains(link.as_str()),
        (Some(_), None) => false,
    };
    match model.unread_bodies.iter().find(is_in) {
        Some(UnreadBodies { element, span, .. }) => {
            let message = format!("the bodies of <{element}> are not read, so their mass would be missing");
            let hint = "save the compiled model (MuJoCo: mj_saveLastXML), and use that file";
            Err(LinkError::new(message, hint).at(span))
        }
        None => Ok(()),
    }
}

/// Returns the names of the movable joints among these that take no value, in file order.
fn held(model: &RobotModel, joints: &[usize]) -> Vec<String> {
    let mut joints = joints.to_vec();
    joints.sort_unstable();
    let joints = joints.into_iter().filter_map(|k| model.joints.get(k));
    let held = joints.filter(|joint| matches!(joint.kind, JointKind::Free | JointKind::Other));
    held.map(|joint| joint.name.text.clone()).collect()
}

/// Returns the index of a link by its name.
pub(crate) fn link_named(model: &RobotModel, name: &str) -> Result<usize, LinkError> {
    let names = || model.links.iter().map(|link| link.name.text.as_str());
    names().position(|link| link == name).ok_or_else(|| {
        let meant = polhode_source::nearest(name, names());
        let hint = suggested(meant, "its links are", &links_by_use(model));
        LinkError::new(format!("unknown link {name:?}"), hint)
    })
}

/// Returns the names of the links, those with an inertial first.
fn links_by_use(model: &RobotModel) -> Vec<&str> {
    let (with, without): (Vec<&Link>, Vec<&Link>) =
        model.links.iter().partition(|link| link.inertial.is_some() || link.computed.is_some());
    with.into_iter().chain(without).map(|link| link.name.text.as_str()).collect()
}

/// Pose of a link in its group's frame.
pub(crate) type Place = Placement<Body, Body>;

/// Lump under construction.
#[derive(Debug)]
struct Group {
    frame: Option<String>,
    links: Vec<String>,
    massless: Vec<String>,
    left_out: Vec<LinkError>,
    rounding: f64,
    parts: Vec<PlacedPart>,
}

impl Group {
    const fn new(frame: Option<String>) -> Self {
        Self {
            frame,
            links: Vec::new(),
            massless: Vec::new(),
            left_out: Vec::new(),
            rounding: 0.0,
            parts: Vec::new(),
        }
    }

    fn add(&mut self, format: ModelFormat, link: &Link, place: Place) -> Result<(), LinkError> {
        let name = &link.name.text;
        match link_mass(format, link) {
            Err(error) => self.left_out.push(error.of_link(name)),
            Ok(LinkMass::None) => self.massless.push(name.clone()),
            Ok(LinkMass::Body(body)) => {
                let rotation = place.rotation * Rotation::identity();
                let part = PlacedPart::new(body.properties, place.position, rotation);
                self.parts.push(part.map_err(|error| not_joined(name, &error))?);
                self.links.push(name.clone());
                self.rounding = self.rounding.max(body.rounding);
            }
        }
        Ok(())
    }

    fn joined(self, positions: &[JointPosition], held: &[String]) -> Result<Lump, LinkError> {
        let Self { frame, links, massless, left_out, rounding, parts } = self;
        let properties = assemble(&parts).map_err(|error| {
            // First link that cannot be joined to the first one; otherwise the last link of a sum
            // that overflows.
            let fails =
                |part: &&PlacedPart| parts.first().is_some_and(|first| assemble(&[*first, **part]).is_err());
            let culprit = parts.iter().skip(1).position(|part| fails(&part)).map_or(links.len(), |k| k + 2);
            let link = links.get(culprit.saturating_sub(1)).map_or("", String::as_str);
            not_joined(link, &error)
        })?;
        let (positions, held) = (positions.to_vec(), held.to_vec());
        Ok(Lump {
            frame,
            links,
            massless,
            left_out,
            positions,
            held,
            drives: Vec::new(),
            rounding,
            properties,
        })
    }
}

/// Returns the error for a link that is physical but cannot be joined to the others.
fn not_joined(link: &str, error: &BodyError) -> LinkError {
    let message = format!("the link {link:?} cannot be lumped with the others: {error}");
    LinkError::new(message, "check the units of its mass and of the poses above it")
}

/// Returns the link whose frame is the model's frame: the only root of a URDF, unless it is
/// attached to the world.
fn common_frame(model: &RobotModel, tree: &Tree) -> Result<Option<String>, LinkError> {
    let hangs = |k: &usize| tree.above.get(*k).is_some_and(|above| !above.joints.is_empty());
    if model.format != ModelFormat::Urdf || tree.roots().all(|k| hangs(&k)) {
        return Ok(None);
    }
    let mut roots = tree.roots().filter_map(|k| model.links.get(k));
    match (roots.next(), roots.next()) {
        (Some(first), Some(second)) => {
            let [a, b] = [first, second].map(|link| &link.name.text);
            let message =
                format!("{a:?} and {b:?} both have no parent, so their relative position is unknown");
            let hint = "connect them by a joint, or use --lump fixed, which needs no common frame";
            Err(LinkError::new(message, hint).at(&second.name.span))
        }
        (first, _) => Ok(first.map(|link| link.name.text.clone())),
    }
}

/// Returns the pose of a root in the model's frame with its joints at rest.
pub(crate) fn in_model(model: &RobotModel, link: &Link, above: &Above) -> Result<Place, LinkError> {
    match model.format {
        // These languages state the pose in the joint only.
        ModelFormat::Urdf | ModelFormat::Osim => at_rest(model, link, above),
        ModelFormat::Sdf | ModelFormat::Mjcf | ModelFormat::Usd => pose(&link.pose, &link.name.text, link),
    }
}

/// Returns the pose of a link in its parent's frame with its joints at rest.
pub(crate) fn at_rest(model: &RobotModel, link: &Link, above: &Above) -> Result<Place, LinkError> {
    match above.joints(model).next() {
        Some(joint) => pose(&joint.pose, &joint.name.text, link),
        None => Ok(Place::identity()),
    }
}

/// Applies the motions of the joints to a pose.
fn moved(
    place: Place,
    model: &RobotModel,
    above: &Above,
    positions: &mut Positions<'_>,
) -> Result<Place, LinkError> {
    above.joints.iter().try_fold(place, |place, &k| {
        let Some(joint) = model.joints.get(k) else { return Ok(place) };
        require_known(joint, "choose the subtree of its child, or single links")?;
        Ok(place.then(motion(joint, positions.displacement(k)?)?))
    })
}

/// Returns an error if the rest position of a joint's child is unknown.
pub(crate) fn require_known(joint: &Joint, hint: &str) -> Result<(), LinkError> {
    let Some(why) = &joint.coordinate.unread else { return Ok(()) };
    let Name { text, span } = &joint.name;
    let message = format!("the position of the child of joint {text:?} is unknown: {why}");
    Err(LinkError::new(message, hint).at(span))
}

/// Returns the motion of a joint's child by q from rest, rad or m.
pub(crate) fn motion(joint: &Joint, q: f64) -> Result<Place, LinkError> {
    Place::motion(joint, q).ok_or_else(|| no_pose(&joint.name.text, &joint.span))
}

/// Returns the placement of a pose; an error if one of its numbers cannot be read.
fn pose(pose: &Pose, subject: &str, link: &Link) -> Result<Place, LinkError> {
    let wrong = || no_pose(subject, pose.span.as_ref().unwrap_or(&link.span));
    if !pose.unreadable.is_empty() {
        return Err(wrong());
    }
    Place::of(pose).map_err(|_: BodyError| wrong())
}

pub(crate) fn no_pose(subject: &str, span: &Span) -> LinkError {
    let message = format!("the pose or axis of {subject:?} is invalid");
    LinkError::new(message, "write finite numbers, and an axis of nonzero length").at(span)
}
