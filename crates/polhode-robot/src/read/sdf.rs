//! SDFormat: models in worlds and models in models. Each element has a pose in a frame that it may
//! name.
//!
//! Every link, joint, frame and nested model is a frame in another one. The poses are composed
//! once, down from the root: the world of a world file, otherwise the model. Names of links in
//! nested models are joined by `::`.
//!
//! Source: sdformat.org/spec (1.11, which contains the elements of all versions since 1.4), and its
//! page "Pose frame semantics".

mod auto;
mod frames;
mod gather;

use std::path::Path;

use polhode_source::ContentError;

use crate::coordinate::limits;
use crate::finding::Severity;
use crate::geometry::Shapes;
use crate::model::{
    Coordinate, Follows, Geometry, GeometryShape, Inertial, Joint, JointKind, Link, Name, Note, Pose,
    RobotModel, Role, Tensor,
};
use crate::pose::of_roll_pitch_yaw;
use crate::read::files::ModelFiles;
use crate::read::pose::Reading;
use crate::read::unread;
use crate::read::uri::Roots;
use crate::read::xml::{Element, Written, child_slot, is_true};
use frames::Frames;
use gather::{gather, require_few, require_short};

/// Fills the model from the root element.
pub(super) fn read(
    root: Element<'_>,
    files: &ModelFiles,
    roots: &Roots<'_>,
    model: &mut RobotModel,
) -> Result<(), ContentError> {
    let mut frames = Frames::default();
    let most_name_bytes = files.most_name_bytes();
    let gathered = gather(root, &mut frames, model, most_name_bytes)?;
    frames.resolve(&mut model.notes);
    let (mut name_bytes, mut shapes) = (0, 0);
    let measured = Shapes::default().from_files(roots.files);
    for (element, scope, frame) in gathered.links {
        let folder = files.folder(element);
        let link = link(element, scope, frame, &frames, (roots, folder, &measured), &mut model.notes);
        shapes += link.geometry.len();
        name_bytes += link.geometry.iter().map(|geometry| geometry.shape.named_bytes()).sum::<usize>();
        require_few(shapes.max(model.notes.len()), element)?;
        require_short(name_bytes, most_name_bytes, element)?;
        model.links.push(link);
    }
    for (element, scope, frame) in gathered.joints {
        let joint = joint(element, scope, frame, &frames);
        name_bytes += joint.name.text.len() + joint.child.text.len();
        name_bytes += joint.parent.as_ref().map_or(0, |parent| parent.text.len());
        require_short(name_bytes, most_name_bytes, element)?;
        model.joints.push(joint);
    }
    Ok(())
}

/// Returns the pose of an element, and the frame that it names.
///
/// The pose has six numbers, the last three roll, pitch and yaw; or seven, the last four a
/// quaternion x, y, z, w.
fn pose<'a>(element: Element<'a>) -> (Pose, Option<&'a str>) {
    let Some(pose) = element.child("pose") else { return (Pose::IDENTITY, None) };
    // The attribute was `frame` until version 1.6.
    let relative_to = pose.word("relative_to").or_else(|| pose.word("frame")).filter(|name| !name.is_empty());
    let mut reading = Reading::default();
    let text = pose.text();
    reading.covers(&text.as_ref().map_or_else(|| pose.span(), |text| text.span.clone()));
    let (position, rotation) = if pose.word("rotation_format") == Some("quat_xyzw") {
        let [px, py, pz, x, y, z, w] = reading.numbers(text.as_ref(), [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        let unit = crate::pose::unit([w, x, y, z]);
        if let (None, Some(text)) = (unit, &text) {
            reading.refuse(text);
        }
        ([px, py, pz], unit.unwrap_or(Pose::IDENTITY.rotation))
    } else {
        let [px, py, pz, angles @ ..] = reading.numbers(text.as_ref(), [0.0; 6]);
        let angles = if pose.says_true("degrees") { angles.map(f64::to_radians) } else { angles };
        ([px, py, pz], of_roll_pitch_yaw(angles))
    };
    (reading.pose(position, rotation), relative_to)
}

fn link(
    element: Element<'_>,
    scope: usize,
    frame: usize,
    frames: &Frames<'_>,
    (roots, folder, measured): (&Roots<'_>, &Path, &Shapes<'_>),
    notes: &mut Vec<Note>,
) -> Link {
    let name = full_name(element, scope, frames);
    unread::sdf(element, &name.text, notes);
    let given = element.child("inertial");
    let automatic = given.is_some_and(|inertial| inertial.says_true("auto"));
    let unclear = given.and_then(auto::unclear);
    let own = frames.in_root(frame);
    let mut geometry = Vec::new();
    for child in element.children() {
        let role = match child.name() {
            "visual" => Role::Visual,
            "collision" => Role::Collision,
            _ => continue,
        };
        let (pose, relative_to) = pose(child);
        let pose = match relative_to.map(|frame| frames.lookup(scope, frame)) {
            None => pose,
            Some(Some(other)) => own.inverse().then(&frames.in_root(other)).then(&pose),
            Some(None) => {
                notes.push(frames::unknown(relative_to.unwrap_or(""), &name.text, child.span()));
                pose
            }
        };
        geometry.push(Geometry { span: child.span(), role, pose, shape: shape(child, (roots, folder)) });
    }
    let mut link = Link {
        span: element.span(),
        inertial: given.filter(|_| !automatic && unclear.is_none()).map(inertial),
        geometry,
        pose: Pose { unreadable: frames.unreadable(frame).to_vec(), ..own },
        is_static: frames.scope(scope).is_static,
        from_geometry: automatic,
        computed: None,
        name,
    };
    if let Some(why) = unclear {
        let note = Note::new("inertia.computed", &link.name.text, link.span.clone(), why.clone());
        notes.push(Note { severity: Severity::Impossible, ..note });
        link.computed = Some(Err(why));
    }
    if let Some(inertial) = given.filter(|_| automatic) {
        auto::compute(&mut link, inertial, element, measured, notes);
    }
    link
}

/// Returns the name of an element, prefixed with the names of its enclosing models.
fn full_name(element: Element<'_>, scope: usize, frames: &Frames<'_>) -> Name {
    let start = element.span().start;
    let own = element
        .attribute("name")
        .map_or(Name { text: String::new(), span: start..start }, |name| name.name());
    Name { text: format!("{}{}", frames.scope(scope).prefix, own.text), span: own.span }
}

fn inertial(element: Element<'_>) -> Inertial {
    Inertial {
        span: element.span(),
        mass: child_slot(element, "mass"),
        pose: pose(element).0,
        tensor: match element.child("inertia") {
            Some(inertia) => Tensor::Six(Box::new(
                ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map(|name| child_slot(inertia, name)),
            )),
            None => Tensor::Missing(element.span()),
        },
    }
}

fn shape(element: Element<'_>, (roots, folder): (&Roots<'_>, &Path)) -> GeometryShape {
    let Some(shape) = element.child("geometry").and_then(|geometry| geometry.children().next()) else {
        return GeometryShape::Other("no geometry".to_owned());
    };
    let size = |name: &str| shape.child_text(name);
    let number = |name: &str| size(name).and_then(|text| text.array()).map_or(f64::NAN, |[value]| value);
    let three = |name: &str| size(name).and_then(|text| text.array()).unwrap_or([f64::NAN; 3]);
    match shape.name() {
        "box" => GeometryShape::Box(three("size")),
        "sphere" => GeometryShape::Sphere(number("radius")),
        "cylinder" => GeometryShape::Cylinder { radius: number("radius"), length: number("length") },
        "capsule" => GeometryShape::Capsule { radius: number("radius"), length: number("length") },
        "cone" => GeometryShape::Cone { radius: number("radius"), length: number("length") },
        "ellipsoid" => GeometryShape::Ellipsoid(three("radii")),
        "mesh" if shape.child("submesh").is_some() => GeometryShape::Other("part of a mesh".to_owned()),
        "mesh" => {
            let start = shape.span().start;
            let uri = size("uri").map_or(Name { text: String::new(), span: start..start }, |uri| uri.name());
            let path = roots.resolve(&uri.text, folder);
            let scale = size("scale").map_or([1.0; 3], |scale| scale.array().unwrap_or([f64::NAN; 3]));
            GeometryShape::Mesh { uri, path, scale }
        }
        other => GeometryShape::Other(other.to_owned()),
    }
}

fn joint(element: Element<'_>, scope: usize, frame: usize, frames: &Frames<'_>) -> Joint {
    // Link, or frame that is fixed to a link.
    let end = |side: &str| {
        let written = element.child_text(side);
        let span = written
            .as_ref()
            .map_or_else(|| element.span().start..element.span().start, |text| text.span.clone());
        let name = written.map_or("", |text| text.value);
        let link = frames.lookup(scope, name).and_then(|frame| frames.link_of(frame));
        let text = link
            .map_or_else(|| format!("{}{name}", frames.scope(scope).prefix), |link| frames.full_name(link));
        (name, link, Name { text, span })
    };
    let (parent_name, parent_link, parent) = end("parent");
    let (_, child_link, child) = end("child");
    let in_root = |link: Option<usize>| link.map_or(Pose::IDENTITY, |link| frames.in_root(link));
    let (in_parent, in_child) = (in_root(parent_link), in_root(child_link));
    // Pose of the joint's frame in the child's frame.
    let place = in_child.inverse().then(&frames.in_root(frame));
    let axis = element.child("axis");
    let xyz = axis.and_then(|axis| axis.child("xyz"));
    let written =
        xyz.and_then(Element::text).map_or([0.0, 0.0, 1.0], |xyz| xyz.array().unwrap_or([f64::NAN; 3]));
    let old_way = axis.and_then(|axis| axis.child_text("use_parent_model_frame"));
    let expressed_in = match xyz.and_then(|xyz| xyz.word("expressed_in")) {
        None | Some("") => old_way.filter(|flag| is_true(flag.value)).map(|_| "__model__"),
        named => named,
    };
    let frame_of_axis = expressed_in.and_then(|name| frames.lookup(scope, name));
    let axes = frame_of_axis.map_or(place.clone(), |other| in_child.inverse().then(&frames.in_root(other)));
    Joint {
        name: full_name(element, scope, frames),
        span: element.span(),
        kind: match element.word("type") {
            Some("fixed") => JointKind::Fixed,
            Some("revolute" | "continuous") => JointKind::Revolute,
            Some("prismatic") => JointKind::Prismatic,
            _ => JointKind::Other,
        },
        parent: (parent_name != "world").then_some(parent),
        child,
        pose: Pose { unreadable: frames.unreadable(frame).to_vec(), ..in_parent.inverse().then(&in_child) },
        axis: axes.turned(written),
        anchor: place.position,
        coordinate: coordinates(element, &frames.scope(scope).prefix),
    }
}

const KINDS: [&str; 9] =
    ["fixed", "revolute", "continuous", "prismatic", "ball", "universal", "screw", "gearbox", "revolute2"];

/// Returns the coordinate of a joint. The second axis is not read; if it follows another joint, the
/// value is unknown.
fn coordinates(joint: Element<'_>, prefix: &str) -> Coordinate {
    let mut own = joint.child("axis").map_or_else(Coordinate::default, |axis| coordinate(axis, prefix));
    if let Some(follows) = joint.child("axis2").and_then(|axis| coordinate(axis, prefix).follows) {
        let coefficients = Err("its second axis is coupled, which is not read".to_owned());
        own.follows = Some(Follows { coefficients, ..follows });
    }
    // Extension of Drake: gear² I.
    let number = |name: &str| joint.child_text(name).map(|text| text.number().value.unwrap_or(f64::NAN));
    let gear = number("drake_gear_ratio").unwrap_or(1.0);
    own.armature = number("drake_rotor_inertia").map_or(0.0, |inertia| gear * gear * inertia);
    let kind = joint.word("type").unwrap_or_default();
    own.unread = (!KINDS.contains(&kind)).then(|| format!("type {kind:?} is not a joint type"));
    own
}

/// Returns the limits of an axis and its coupling: `<mimic joint="…">` since 1.10.
fn coordinate(axis: Element<'_>, prefix: &str) -> Coordinate {
    let number = |written: Written<'_>| written.number().value.unwrap_or(f64::NAN);
    let limit = |side: &str| {
        let written = axis.child("limit").and_then(|limit| limit.child_text(side))?;
        // The default, ±1e16, means no limit.
        Some(number(written)).filter(|limit| limit.abs() < 1e16)
    };
    let follows = axis.child("mimic").map(|mimic| {
        let start = mimic.span().start;
        let leader = mimic
            .attribute("joint")
            .map_or(Name { text: String::new(), span: start..start }, |name| name.name());
        let leader = Name { text: format!("{prefix}{}", leader.text), ..leader };
        // The specification requires a multiplier; its default, zero, is not useful.
        let numbers = [("multiplier", f64::NAN), ("offset", 0.0), ("reference", 0.0)]
            .map(|(name, default)| mimic.child_text(name).map_or(default, number));
        let follows = Follows::line(mimic.span(), leader, numbers);
        match mimic.word("axis") {
            None | Some("" | "axis") => follows,
            Some(_) => Follows {
                coefficients: Err("it follows a second axis, which is not read".to_owned()),
                ..follows
            },
        }
    });
    Coordinate { limits: limits(limit("lower"), limit("upper")), follows, ..Coordinate::default() }
}
