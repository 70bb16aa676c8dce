//! Joints, in the joint set of a model or, until 3.x, in the child body.

use super::frame::{Frames, offset, socket};
use super::{GROUND, coordinate, transform};
use crate::model::{Coordinate, Joint, JointKind, Name, Note, Pose};
use crate::read::xml::{Element, is_true};

/// Returns a joint between two frames. `None` if a frame is missing, or with a note if a frame is
/// of a kind that is not read.
pub(super) fn new<'a>(element: Element<'a>, frames: &Frames<'a>, notes: &mut Vec<Note>) -> Option<Joint> {
    let own = Frames::of(element);
    let ends = ["parent_frame", "child_frame"].map(|side| socket(element, side));
    let [Some(parent), Some(child)] = ends else { return None };
    let placed = (frames.placed(&own, &parent), frames.placed(&own, &child));
    let (Some((parent, in_parent)), Some((child, in_child))) = placed else {
        let name = element.word("name").unwrap_or("");
        let message = "the joint is not read: one of its frames is not a PhysicalOffsetFrame".to_owned();
        notes.push(Note::new("read.left_out", name, parent.span, message));
        return None;
    };
    Some(joint(element, parent, child, &in_parent, &in_child))
}

/// Returns the joint that is written in a body.
pub(super) fn old(element: Element<'_>, body: &Name) -> Joint {
    let start = element.span().start;
    let parent = element
        .child_text("parent_body")
        .map_or_else(|| Name { text: GROUND.to_owned(), span: start..start + 1 }, |name| name.name());
    let in_parent = offset(element, "location_in_parent", "orientation_in_parent");
    let in_child = offset(element, "location", "orientation");
    joint(element, parent, body.clone(), &in_parent, &in_child)
}

fn joint(element: Element<'_>, parent: Name, child: Name, in_parent: &Pose, in_child: &Pose) -> Joint {
    let start = element.span().start;
    let (kind, axis) = match element.name() {
        "WeldJoint" => (JointKind::Fixed, [0.0, 0.0, 1.0]),
        "PinJoint" => (JointKind::Revolute, [0.0, 0.0, 1.0]),
        "SliderJoint" => (JointKind::Prismatic, [1.0, 0.0, 0.0]),
        "FreeJoint" => (JointKind::Free, [0.0, 0.0, 1.0]),
        _ => (JointKind::Other, [0.0, 0.0, 1.0]),
    };
    let is_reversed = element.child_text("reverse").is_some_and(|reverse| is_true(reverse.value));
    let moved = match element.name() {
        "WeldJoint" => Ok(Pose::IDENTITY),
        _ if is_reversed => {
            Err("it is reversed (it moves the parent relative to the child), which is not read".to_owned())
        }
        "PinJoint" | "SliderJoint" | "FreeJoint" | "BallJoint" | "UniversalJoint" | "PlanarJoint"
        | "GimbalJoint" => Ok(Pose::IDENTITY),
        "CustomJoint" => transform::at_zero(element),
        other => Err(format!("the position of {other} with its coordinates at zero is not read")),
    };
    let (moved, unread) = match moved {
        Ok(pose) => (pose, None),
        Err(why) => (Pose::IDENTITY, Some(why)),
    };
    let unreadable = in_parent.unreadable.iter().chain(&in_child.unreadable).cloned().collect();
    let pose =
        Pose { unreadable, span: in_parent.span.clone(), ..in_parent.then(&moved).then(&in_child.inverse()) };
    Joint {
        name: element.attribute("name").map_or_else(
            || Name { text: format!("{} of {}", element.name(), child.text), span: start..start + 1 },
            |name| name.name(),
        ),
        span: element.span(),
        kind,
        parent: Some(parent).filter(|parent| parent.text != GROUND),
        axis: in_child.turned(axis),
        anchor: in_child.position,
        child,
        pose,
        coordinate: Coordinate { unread, ..coordinate::of(element) },
    }
}
