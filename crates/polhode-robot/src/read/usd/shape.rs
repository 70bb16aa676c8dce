//! Shapes of the UsdGeom schema, such as `Cube`, `Sphere` and `Cylinder`.

use super::layer::Prim;
use super::{Stage, applies};
use crate::model::{Geometry, GeometryShape, Pose, Role};
use crate::pose::{about, product};

/// Returns the shape of a prim in a body's frame; `None` if it has none.
pub(super) fn geometry(stage: &Stage<'_>, k: usize, prim: &Prim, body: &Pose) -> Option<Geometry> {
    let number = |name: &str, default: f64| {
        prim.properties
            .get(name)
            .map_or(default, |value| value.numbers.first().and_then(|n| n.value).unwrap_or(f64::NAN))
    };
    let metres = stage.units.metres;
    let axis = prim.properties.get("axis").and_then(|axis| axis.words.first()).map_or("Z", String::as_str);
    let (radius, height) =
        (|default| metres * number("radius", default), |default| metres * number("height", default));
    let shape = match prim.kind.as_str() {
        "Cube" => GeometryShape::Box([metres * number("size", 2.0); 3]),
        "Sphere" => GeometryShape::Sphere(radius(1.0)),
        "Cylinder" => GeometryShape::Cylinder { radius: radius(1.0), length: height(2.0) },
        "Capsule" => GeometryShape::Capsule { radius: radius(0.5), length: height(1.0) },
        "Cone" => GeometryShape::Cone { radius: radius(1.0), length: height(2.0) },
        "Plane" | "Points" | "BasisCurves" | "NurbsPatch" => GeometryShape::Other(prim.kind.to_lowercase()),
        _ => return None,
    };
    let shape = if matches!(axis, "X" | "Y" | "Z") {
        shape
    } else {
        GeometryShape::Other(format!("a shape along the axis {axis:?}, which is not X, Y or Z,"))
    };
    let role = if applies(prim, "PhysicsCollisionAPI") { Role::Collision } else { Role::Visual };
    let span = prim.span.clone();
    let unreadable = stage.place(k).unreadable.clone();
    let Some((scale, pose)) = stage.place(k).scaled_pose() else {
        let shape = GeometryShape::Other("a shape with non-perpendicular axes".to_owned());
        return Some(Geometry { span, role, pose: Pose { unreadable, ..Pose::IDENTITY }, shape });
    };
    let mut pose = body.inverse().then(&pose);
    let is_long = matches!(
        shape,
        GeometryShape::Cylinder { .. } | GeometryShape::Capsule { .. } | GeometryShape::Cone { .. }
    );
    // The scale along z is the one along the shape's own axis.
    let scale = match axis {
        "X" if is_long => {
            pose.rotation = product(pose.rotation, about(1, std::f64::consts::FRAC_PI_2));
            [scale[2], scale[1], scale[0]]
        }
        "Y" if is_long => {
            pose.rotation = product(pose.rotation, about(0, -std::f64::consts::FRAC_PI_2));
            [scale[0], scale[2], scale[1]]
        }
        _ => scale,
    };
    let shape = scaled(shape, scale);
    Some(Geometry { span, role, pose: Pose { unreadable, ..pose }, shape })
}

/// Returns a shape scaled along its axes.
fn scaled(shape: GeometryShape, [x, y, z]: [f64; 3]) -> GeometryShape {
    /// Tolerance for equal factors: rounding in single precision.
    const EQUAL: f64 = 1e-6;
    let round = (x / y - 1.0).abs() < EQUAL;
    let even = round && (x / z - 1.0).abs() < EQUAL;
    match shape {
        GeometryShape::Box([a, b, c]) => GeometryShape::Box([a * x, b * y, c * z]),
        GeometryShape::Sphere(radius) if even => GeometryShape::Sphere(radius * x),
        GeometryShape::Sphere(radius) => GeometryShape::Ellipsoid([radius * x, radius * y, radius * z]),
        GeometryShape::Cylinder { radius, length } if round => {
            GeometryShape::Cylinder { radius: radius * x, length: length * z }
        }
        GeometryShape::Capsule { radius, length } if even => {
            GeometryShape::Capsule { radius: radius * x, length: length * x }
        }
        GeometryShape::Cone { radius, length } if round => {
            GeometryShape::Cone { radius: radius * x, length: length * z }
        }
        GeometryShape::Cylinder { .. } | GeometryShape::Capsule { .. } | GeometryShape::Cone { .. } => {
            GeometryShape::Other("a round shape with different scales along its axes".to_owned())
        }
        other => other,
    }
}
