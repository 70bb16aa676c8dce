//! UsdPhysics joints: a frame on each of two bodies.

use super::layer::Prim;
use super::path::absolute;
use super::{Stage, coordinate, xform};
use crate::model::{Joint, JointKind, Name, Pose};
use crate::pose::unit;

/// Returns the joint of a prim; `None` if it is not a joint or is disabled.
pub(super) fn joint(stage: &Stage<'_>, prim: &Prim) -> Option<Joint> {
    let kind = match prim.kind.as_str() {
        "PhysicsFixedJoint" => JointKind::Fixed,
        "PhysicsRevoluteJoint" => JointKind::Revolute,
        "PhysicsPrismaticJoint" => JointKind::Prismatic,
        "PhysicsSphericalJoint" | "PhysicsDistanceJoint" | "PhysicsJoint" => JointKind::Other,
        _ => return None,
    };
    let words = |name: &str| prim.properties.get(name).and_then(|value| value.words.first());
    if prim.is_off("physics:jointEnabled") {
        return None;
    }
    let (first, second) = (end(stage, prim, 0), end(stage, prim, 1));
    // A joint to the world may name its body at either end. Its value is the displacement of the
    // second body relative to the first.
    let ((parent, in_parent), (child, in_child), sense) = match (first.0, second.0) {
        (Some(only), None) => ((None, second.1), (only, first.1), -1.0),
        (parent, Some(child)) => ((parent, first.1), (child, second.1), 1.0),
        (None, None) => return None,
    };
    let mut coordinate = coordinate::of(stage, prim, kind);
    let axis = match words("physics:axis").map(String::as_str) {
        None | Some("X") => [1.0, 0.0, 0.0],
        Some("Y") => [0.0, 1.0, 0.0],
        Some("Z") => [0.0, 0.0, 1.0],
        Some(other) => {
            coordinate.unread = Some(format!("physics:axis {other:?} is not X, Y or Z"));
            [1.0, 0.0, 0.0]
        }
    };
    let mut pose = in_parent.then(&in_child.inverse());
    pose.unreadable = in_parent.unreadable.iter().chain(&in_child.unreadable).cloned().collect();
    Some(Joint {
        name: Name { text: prim.path.clone(), ..prim.name.clone() },
        span: prim.span.clone(),
        kind,
        parent,
        child,
        axis: in_child.turned(axis.map(|c: f64| sense * c)),
        anchor: in_child.position,
        coordinate,
        pose,
    })
}

/// Returns the body at one end (`None` for the world or a static prim), and the joint's frame in
/// it.
fn end(stage: &Stage<'_>, prim: &Prim, number: usize) -> (Option<Name>, Pose) {
    let property = |name: &str| prim.properties.get(&format!("physics:{name}{number}"));
    let mut pose = Pose::IDENTITY;
    let mut wrong = |value: &super::value::Value| {
        pose.unreadable.push(crate::model::Number {
            text: "no such numbers".to_owned(),
            span: value.span.clone(),
            value: None,
        });
    };
    let position = property("localPos").and_then(|value| {
        xform::numbers::<3>(value).or_else(|| {
            wrong(value);
            None
        })
    });
    let rotation = property("localRot").and_then(|value| {
        xform::numbers::<4>(value).and_then(unit).or_else(|| {
            wrong(value);
            None
        })
    });
    pose.position = position.map_or([0.0; 3], |position| position.map(|c| stage.units.metres * c));
    pose.rotation = rotation.unwrap_or(Pose::IDENTITY.rotation);
    let body = property("body").and_then(|value| Some((value.words.first()?, value.span.clone())));
    let body = body.and_then(|(path, span)| {
        let path = absolute(path, &prim.path);
        match stage.numbers.get(path.as_str()) {
            // A prim below a body belongs to that body.
            Some(&named) => {
                let body = stage.body_around(named)?;
                let text = stage.layer.prims.get(body)?.path.clone();
                Some(Name { text, span })
            }
            None => Some(Name { text: path, span }),
        }
    });
    (body, pose)
}
