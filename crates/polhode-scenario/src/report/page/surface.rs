//! Contact surface of a body, as a shape of the page.

use polhode::body::{BodyPart, Form, PlacedForm};
use polhode::math::{Body, Direction, Part, Position};
use polhode::motion::contact::{BodySurface, SurfaceShape};
use polhode_document::json::numbers;
use serde_json::{Value, json};

use super::placed::{THIN, at};

/// Relative tolerance for lengths that look equal.
const ALIKE: f64 = 1e-3;

/// Display length of an infinite cylinder, in radii.
const ENDLESS: f64 = 4.0;

/// Returns the surface at its place, relative to a point of the body.
pub(crate) fn shape(surface: &BodySurface, point: Position<Body>) -> Option<Value> {
    let own = match *surface.shape() {
        SurfaceShape::Sphere { radius } => json!({ "kind": "ellipsoid", "half": numbers(&[radius; 3]) }),
        SurfaceShape::Ellipsoid { semi_axes } => json!({ "kind": "ellipsoid", "half": numbers(&semi_axes) }),
        SurfaceShape::Rim { radius, tube, thickness } if thickness > 0.0 || tube == 0.0 => {
            cylinder(radius + tube, f64::max(thickness + 2.0 * tube, THIN * radius))
        }
        SurfaceShape::Rim { radius, tube, .. } => json!({ "kind": "torus", "radius": radius, "tube": tube }),
        SurfaceShape::Cylinder { radius, length } => cylinder(radius, length.unwrap_or(ENDLESS * radius)),
        _ => return None,
    };
    let place = (surface.center() - point).to_array();
    Some(at(own, "surface", place, surface.axes().canonical_quaternion()))
}

fn cylinder(radius: f64, height: f64) -> Value {
    json!({ "kind": "cylinder", "radius": radius, "inner": 0.0, "height": height })
}

/// Returns true if the shape of some part is known.
pub(crate) fn has_forms(parts: &[BodyPart]) -> bool {
    parts.iter().any(|part| part.form.is_some() || !part.particles.is_empty())
}

/// Returns true if the surface is that of some part.
pub(crate) fn is_shown(surface: &BodySurface, parts: &[BodyPart]) -> bool {
    parts.iter().filter_map(|part| part.form.as_ref()).any(|form| is_like(surface, form))
}

fn is_like(surface: &BodySurface, form: &PlacedForm) -> bool {
    let z = Direction::<Part>::new(0.0, 0.0, 1.0);
    let is_along = (surface.axes() * z).dot(form.rotation * z).abs() > 1.0 - ALIKE;
    let (size, fits) = match (*surface.shape(), &form.form) {
        (SurfaceShape::Sphere { radius }, Form::Ellipsoid { semi_axes }) => {
            (radius, semi_axes.iter().all(|a| alike(*a, radius)))
        }
        (SurfaceShape::Sphere { radius }, Form::HollowSphere { radius: own, .. }) => {
            (radius, alike(*own, radius))
        }
        (SurfaceShape::Ellipsoid { semi_axes: own }, Form::Ellipsoid { semi_axes }) => {
            let turn = (surface.axes().inverse() * form.rotation).canonical_quaternion();
            let is_turned = turn.iter().skip(1).any(|x| x.abs() > ALIKE);
            let fits = own.iter().zip(semi_axes).all(|(a, b)| alike(*a, *b));
            (own.iter().copied().fold(0.0, f64::max), fits && !is_turned)
        }
        (SurfaceShape::Rim { radius, tube, .. }, Form::Torus { ring_radius, tube_radius }) => (
            radius,
            is_along && alike(radius, *ring_radius) && alike(radius + tube, ring_radius + tube_radius),
        ),
        (
            SurfaceShape::Rim { radius, tube, .. },
            Form::Cylinder { radius: own, .. } | Form::Disk { radius: own },
        ) => (radius, is_along && alike(radius + tube, *own)),
        (SurfaceShape::Cylinder { radius, .. }, Form::Cylinder { radius: own, .. }) => {
            (radius, is_along && alike(radius, *own))
        }
        _ => return false,
    };
    fits && (form.position - surface.center()).norm() <= ALIKE * size
}

fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= ALIKE * a.abs().max(b.abs())
}
