//! URDF: a list of links and joints; lengths in metres, angles in radians, attitudes as roll,
//! pitch, yaw.
//!
//! Source: wiki.ros.org/urdf/XML, and the urdfdom parser for details.

use std::collections::HashMap;
use std::path::Path;

use polhode_source::{ContentError, ContentErrorKind};

use crate::coordinate::limits;
use crate::finding::Severity;
use crate::model::{
    Coordinate, Follows, Geometry, GeometryShape, Inertial, Joint, JointKind, Link, Name, Note, Pose,
    RobotModel, Role, Slot, Span, Tensor,
};
use crate::pose::of_roll_pitch_yaw;
use crate::read::pose::Reading;
use crate::read::unread;
use crate::read::uri::Roots;
use crate::read::xml::{Element, Written, slot};

/// Fills the model from the root element.
pub(super) fn read(root: Element<'_>, roots: &Roots<'_>, model: &mut RobotModel) -> Result<(), ContentError> {
    if let Some(span) = macros(root) {
        return Err(xacro(&model.path, span));
    }
    if let Some(span) = semantics(root) {
        let what = "SRDF: groups and poses of a URDF, without its links";
        let error = ContentErrorKind::unsupported(what).at(span);
        return Err(error.hint("check the URDF to which it belongs"));
    }
    model.name = root.word("name").map(str::to_owned);
    for child in root.children() {
        match child.name() {
            "link" => {
                let link = link(child, roots, &mut model.notes);
                model.links.push(link);
            }
            "joint" => {
                let joint = joint(child);
                unread::origin(child, &joint.name.text, &mut model.notes);
                if let Some(why) = &joint.coordinate.unread {
                    let start = child.span().start;
                    let span = child.attribute("type").map_or(start..start + 1, |written| written.span);
                    let note = Note::new("read.unknown", &joint.name.text, span, why.clone());
                    model.notes.push(Note { severity: Severity::Suspect, ..note });
                }
                model.joints.push(joint);
            }
            _ => {}
        }
    }
    hang_on_world(model);
    reflect_rotors(root, model);
    Ok(())
}

/// Adds the reflected inertia gear² I of rotors to their joints, from Drake's `drake:gear_ratio`
/// and `drake:rotor_inertia` in a `<transmission>`. URDF itself has no key for a rotor's inertia,
/// so `<mechanicalReduction>` alone adds nothing.
fn reflect_rotors(root: Element<'_>, model: &mut RobotModel) {
    let value = |actuator: Element<'_>, name: &str| {
        let written = actuator.child(name).map(|child| child.attribute("value"));
        written.map(|written| written.and_then(|written| written.number().value).unwrap_or(f64::NAN))
    };
    let mut rotors: HashMap<&str, f64> = HashMap::new();
    for transmission in root.named("transmission") {
        let Some((joint, actuator)) = transmission.child("joint").zip(transmission.child("actuator")) else {
            continue;
        };
        let (Some(name), Some(inertia)) = (joint.word("name"), value(actuator, "drake_rotor_inertia")) else {
            continue;
        };
        let gear = value(actuator, "drake_gear_ratio").unwrap_or(1.0);
        *rotors.entry(name).or_default() += gear * gear * inertia;
    }
    for joint in &mut model.joints {
        joint.coordinate.armature += rotors.get(joint.name.text.as_str()).copied().unwrap_or(0.0);
    }
}

/// Treats the parent `world` as the world itself if no link has this name, as Drake does. Other
/// programs reject it.
fn hang_on_world(model: &mut RobotModel) {
    if model.links.iter().any(|link| link.name.text == WORLD) {
        return;
    }
    for joint in &mut model.joints {
        if let Some(parent) = joint.parent.take_if(|parent| parent.text == WORLD) {
            let message = "its parent is \"world\", which is not a link: Drake takes it as the world, other programs need \
                           <link name=\"world\"/>"
                .to_owned();
            model.notes.push(Note::new("read.world", &joint.name.text, parent.span, message));
        }
    }
}

const WORLD: &str = "world";

/// Returns the position that shows that a text is SRDF, whose root element has the same name.
fn semantics(root: Element<'_>) -> Option<Span> {
    const OF_GROUPS: [&str; 5] =
        ["group", "group_state", "virtual_joint", "end_effector", "disable_collisions"];
    let first = root.children().find(|child| OF_GROUPS.contains(&child.name()))?;
    root.child("link").is_none().then(|| first.span())
}

/// Returns the position of an unexpanded xacro macro, if there is one.
fn macros(root: Element<'_>) -> Option<Span> {
    let mut waiting = vec![root];
    while let Some(element) = waiting.pop() {
        if element.name().starts_with("xacro_") {
            return Some(element.span());
        }
        waiting.extend(element.children());
    }
    // An expanded file may still declare the prefix; only an expression proves an unexpanded macro.
    let text = root.document();
    let expression = || ["${", "$("].iter().filter_map(|opening| text.find(opening)).min();
    let start = root.has_prefix("xacro").then(expression).flatten()?;
    Some(start..start + 2)
}

/// Returns the error for a xacro file, with the command that expands it.
fn xacro(path: &Path, span: Span) -> ContentError {
    let what = "xacro: this file generates a model and is not itself a model";
    let file = path.file_name().map_or_else(|| "robot.urdf.xacro".into(), |name| name.to_string_lossy());
    let stem = file.split('.').next().unwrap_or("robot");
    let out = if *file == *format!("{stem}.urdf") {
        format!("{stem}-expanded.urdf")
    } else {
        format!("{stem}.urdf")
    };
    ContentErrorKind::unsupported(what)
        .at(span)
        .hint(format!("expand it first: xacro {file} > {out}, or use --xacro"))
}

fn link(element: Element<'_>, roots: &Roots<'_>, notes: &mut Vec<Note>) -> Link {
    let name = name(element, "name");
    unread::urdf(element, &name.text, notes);
    let inertial = element.child("inertial").map(inertial);
    let geometry = element.children().filter_map(|child| {
        let role = match child.name() {
            "visual" => Role::Visual,
            "collision" => Role::Collision,
            _ => return None,
        };
        let shape = shape(child, roots);
        Some(Geometry { span: child.span(), role, pose: origin(child), shape })
    });
    Link {
        geometry: geometry.collect(),
        name,
        span: element.span(),
        inertial,
        pose: Pose::IDENTITY,
        is_static: false,
        from_geometry: false,
        computed: None,
    }
}

/// Returns an attribute as a name. If it is missing, the name is empty, at the element's position.
fn name(element: Element<'_>, attribute: &str) -> Name {
    let start = element.span().start;
    element
        .attribute(attribute)
        .map_or(Name { text: String::new(), span: start..start }, |written| written.name())
}

fn inertial(element: Element<'_>) -> Inertial {
    let missing = |name: &str| Slot::Missing { span: element.span(), name: name.to_owned() };
    Inertial {
        span: element.span(),
        mass: element.child("mass").map_or_else(|| missing("mass"), |mass| slot(mass, "value")),
        pose: origin(element),
        tensor: match element.child("inertia") {
            Some(inertia) => Tensor::Six(Box::new(
                ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map(|name| slot(inertia, name)),
            )),
            None => Tensor::Missing(element.span()),
        },
    }
}

/// Returns the pose `<origin xyz="…" rpy="…"/>` of an element; the identity if it is missing.
fn origin(element: Element<'_>) -> Pose {
    let Some(origin) = element.child("origin") else { return Pose::IDENTITY };
    let mut reading = Reading::default();
    reading.covers(&origin.span());
    let position = reading.numbers(origin.attribute("xyz").as_ref(), [0.0; 3]);
    let angles = reading.numbers(origin.attribute("rpy").as_ref(), [0.0; 3]);
    reading.pose(position, of_roll_pitch_yaw(angles))
}

fn shape(element: Element<'_>, roots: &Roots<'_>) -> GeometryShape {
    let Some(shape) = element.child("geometry").and_then(|geometry| geometry.children().next()) else {
        return GeometryShape::Other("no geometry".to_owned());
    };
    let size = |name: &str| {
        shape.attribute(name).and_then(|written| written.array()).map_or(f64::NAN, |[size]| size)
    };
    match shape.name() {
        "box" => {
            GeometryShape::Box(shape.attribute("size").and_then(|size| size.array()).unwrap_or([f64::NAN; 3]))
        }
        "sphere" => GeometryShape::Sphere(size("radius")),
        "cylinder" => GeometryShape::Cylinder { radius: size("radius"), length: size("length") },
        "capsule" => GeometryShape::Capsule { radius: size("radius"), length: size("length") },
        "mesh" => {
            let uri = name(shape, "filename");
            let folder = roots.folder().as_deref().unwrap_or(Path::new(""));
            let path = roots.resolve(&uri.text, folder);
            let scale =
                shape.attribute("scale").map_or([1.0; 3], |scale| scale.array().unwrap_or([f64::NAN; 3]));
            GeometryShape::Mesh { uri, path, scale }
        }
        other => GeometryShape::Other(other.to_owned()),
    }
}

fn joint(element: Element<'_>) -> Joint {
    let end = |side: &str| {
        let start = element.span().start;
        let nowhere = Name { text: String::new(), span: start..start };
        element.child(side).map_or(nowhere, |end| name(end, "link"))
    };
    let axis = element.child("axis").and_then(|axis| axis.attribute("xyz"));
    Joint {
        name: name(element, "name"),
        span: element.span(),
        kind: match element.word("type") {
            Some("fixed") => JointKind::Fixed,
            Some("revolute" | "continuous") => JointKind::Revolute,
            Some("prismatic") => JointKind::Prismatic,
            Some("floating") => JointKind::Free,
            _ => JointKind::Other,
        },
        parent: Some(end("parent")),
        child: end("child"),
        pose: origin(element),
        axis: axis.map_or([1.0, 0.0, 0.0], |axis| axis.array().unwrap_or([f64::NAN; 3])),
        anchor: [0.0; 3],
        coordinate: Coordinate { unread: unknown_kind(element), ..coordinate(element) },
    }
}

/// Returns the error for a joint type that is missing or unknown.
fn unknown_kind(element: Element<'_>) -> Option<String> {
    const KINDS: [&str; 6] = ["revolute", "continuous", "prismatic", "fixed", "floating", "planar"];
    let Some(written) = element.word("type") else { return Some("the joint has no type".to_owned()) };
    if KINDS.contains(&written) {
        return None;
    }
    let kinds = KINDS.join(", ");
    Some(format!("type {written:?} is not a joint type; the joint types are {kinds}"))
}

/// Returns limits and coupling: `<limit lower="…" upper="…"/>` and `<mimic joint="…" multiplier="…"
/// offset="…"/>`.
fn coordinate(element: Element<'_>) -> Coordinate {
    let number = |written: Option<Written<'_>>, default: f64| {
        written.map_or(default, |written| written.number().value.unwrap_or(f64::NAN))
    };
    // A continuous joint has no limits. For other joints a missing limit is zero.
    let limit =
        element.child("limit").filter(|_| matches!(element.word("type"), Some("revolute" | "prismatic")));
    let limits = limit.and_then(|limit| match ["lower", "upper"].map(|name| limit.attribute(name)) {
        [None, None] => None,
        [lower, upper] => limits(Some(number(lower, 0.0)), Some(number(upper, 0.0))),
    });
    let follows = element.child("mimic").map(|mimic| {
        let [multiplier, offset] = [("multiplier", 1.0), ("offset", 0.0)]
            .map(|(name, default)| number(mimic.attribute(name), default));
        Follows::line(mimic.span(), name(mimic, "joint"), [multiplier, offset, 0.0])
    });
    Coordinate { limits, follows, ..Coordinate::default() }
}
