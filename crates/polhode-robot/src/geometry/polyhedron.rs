//! Polyhedra inside and around a primitive: the volume that it shares with other shapes lies
//! between theirs.
//!
//! A surface of revolution is cut into `AROUND` facets around its axis, a ball also into half as
//! many rings. The inner polyhedron has its corners on the surface. The outer one is the inner one
//! enlarged until its facets touch the surface; for a circle by 1/cos(π/n).

use std::f64::consts::PI;

use polhode::body::BodyError;
use polhode::body::mesh::TriangleMesh;

use super::primitive::{Outline, Primitive};
use crate::model::Pose;

/// Number of facets around an axis; a multiple of 4, so that a ring lies on the equator.
const AROUND: u32 = 96;

/// Polyhedra inside and around a shape.
pub(super) struct Polyhedra {
    pub(super) inner: TriangleMesh,
    /// Outer polyhedron; `None` if the inner one is the shape itself.
    pub(super) outer: Option<TriangleMesh>,
}

impl Polyhedra {
    /// Returns the polyhedra of a placed primitive.
    ///
    /// # Errors
    /// [`BodyError`] if a coordinate is not finite.
    pub(super) fn of(primitive: &Primitive, pose: &Pose) -> Result<Self, BodyError> {
        if let Outline::Box(half) = primitive.outline {
            return Ok(Self { inner: cuboid(half, pose)?, outer: None });
        }
        let inner = revolved(&rings(&primitive.outline, false), pose)?;
        Ok(Self { inner, outer: Some(revolved(&rings(&primitive.outline, true), pose)?) })
    }
}

/// Ring of a surface of revolution: its semi-axes along x and y, and its height.
type Ring = [f64; 3];

/// Returns the rings of a shape from bottom to top.
fn rings(outline: &Outline, grows: bool) -> Vec<Ring> {
    let circle = if grows { 1.0 / libm::cos(PI / f64::from(AROUND)) } else { 1.0 };
    match *outline {
        Outline::Box(_) => Vec::new(),
        Outline::Cone { half, radius } => vec![[circle * radius, circle * radius, -half], [0.0, 0.0, half]],
        Outline::Ends { half, radius, balls: false } => {
            [-half, half].map(|z| [circle * radius, circle * radius, z]).to_vec()
        }
        Outline::Ends { half, radius, balls: true } => ball([radius; 3], half, grows),
        Outline::Ellipsoid(half_axes) => ball(half_axes, 0.0, grows),
    }
}

/// Returns the rings of an ellipsoid whose halves are moved apart along z by ±`half`.
fn ball(half_axes: [f64; 3], half: f64, grows: bool) -> Vec<Ring> {
    let steps = AROUND / 2;
    let angle = |k: u32| PI * (f64::from(k) / f64::from(steps) - 0.5);
    // The middle of a facet is at cos(π/n) of the distance of its corners from the axis.
    let middle = libm::cos(PI / f64::from(AROUND));
    let meridian = |k: u32| {
        let (sin, cos) = libm::sincos(angle(k));
        [middle * cos, sin]
    };
    let inward = (0..steps).map(|k| {
        let ([x, y], [next_x, next_y]) = (meridian(k), meridian(k + 1));
        (x * next_y - next_x * y).abs() / (next_x - x).hypot(next_y - y)
    });
    let factor = if grows { 1.0 / inward.fold(1.0, f64::min) } else { 1.0 };
    let ring = |k: u32, shift: f64| {
        let (sin, cos) = libm::sincos(angle(k));
        // The cosine at a pole is zero, not its rounding error.
        let cos = if k == 0 || k == steps { 0.0 } else { cos };
        [factor * half_axes[0] * cos, factor * half_axes[1] * cos, factor * half_axes[2] * sin + shift]
    };
    let lower = (0..=steps / 2).map(|k| ring(k, -half));
    let first_upper = if half > 0.0 { steps / 2 } else { steps / 2 + 1 };
    lower.chain((first_upper..=steps).map(|k| ring(k, half))).collect()
}

/// Returns the closed surface through rings; a first or last ring with a radius gets a flat end.
fn revolved(rings: &[Ring], pose: &Pose) -> Result<TriangleMesh, BodyError> {
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let mut before: Option<(u32, u32)> = None;
    let pole = |z: f64| pose.placed([0.0, 0.0, z]);
    let ends = [rings.first(), rings.last()].map(|ring| ring.filter(|ring| ring[0] > 0.0));
    if let Some(bottom) = ends[0] {
        before = Some((0, 1));
        vertices.push(pole(bottom[2]));
    }
    let mut add = |ring: &Ring, count: u32| {
        let first = vertices.len() as u32;
        if count == 1 {
            vertices.push(pole(ring[2]));
        } else {
            vertices.extend((0..count).map(|k| {
                let (sin, cos) = libm::sincos(2.0 * PI * f64::from(k) / f64::from(count));
                pose.placed([ring[0] * cos, ring[1] * sin, ring[2]])
            }));
        }
        if let Some((lower, lower_count)) = before {
            for k in 0..AROUND {
                let next = (k + 1) % AROUND;
                if lower_count > 1 {
                    let top = if count > 1 { first + next } else { first };
                    triangles.push([lower + k, lower + next, top]);
                }
                if count > 1 {
                    let bottom = if lower_count > 1 { lower + k } else { lower };
                    triangles.push([bottom, first + next, first + k]);
                }
            }
        }
        before = Some((first, count));
    };
    for ring in rings {
        add(ring, if ring[0] > 0.0 { AROUND } else { 1 });
    }
    if let Some(top) = ends[1] {
        add(top, 1);
    }
    TriangleMesh::new(vertices, triangles)
}

/// Returns the surface of a box with these half edges.
fn cuboid(half: [f64; 3], pose: &Pose) -> Result<TriangleMesh, BodyError> {
    const TRIANGLES: [[u32; 3]; 12] = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let corner = |k: usize| pose.placed([0, 1, 2].map(|j| if k >> j & 1 == 0 { -half[j] } else { half[j] }));
    TriangleMesh::new((0..8).map(corner).collect::<Vec<_>>(), TRIANGLES.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::GeometryShape;
    use crate::pose::of_roll_pitch_yaw;
    use polhode::body::mesh::ClosedMesh;

    /// Volumes of the polyhedra enclose that of the shape, within a percent.
    #[test]
    fn polyhedra_are_inside_and_around() {
        let pose = Pose::new([0.3, -0.2, 0.7], of_roll_pitch_yaw([0.4, -1.1, 2.3]));
        for (shape, volume) in [
            (GeometryShape::Sphere(0.31), 4.0 / 3.0 * PI * 0.31_f64.powi(3)),
            (GeometryShape::Cylinder { radius: 0.07, length: 0.5 }, PI * 0.07 * 0.07 * 0.5),
            (
                GeometryShape::Capsule { radius: 0.07, length: 0.5 },
                PI * 0.07 * 0.07 * (0.5 + 4.0 / 3.0 * 0.07),
            ),
            (GeometryShape::Ellipsoid([0.2, 0.3, 0.5]), 4.0 / 3.0 * PI * 0.03),
            (GeometryShape::Cone { radius: 0.2, length: 0.7 }, PI / 3.0 * 0.04 * 0.7),
        ] {
            let Polyhedra { inner, outer } = Polyhedra::of(&Primitive::of(&shape).unwrap(), &pose).unwrap();
            let [inner, outer] = [inner, outer.unwrap()].map(|mesh| {
                let solid = ClosedMesh::of(&mesh).unwrap();
                assert!(!solid.inverted());
                solid.volume()
            });
            assert!(inner < volume && volume < outer, "{shape:?} {inner} {volume} {outer}");
            assert!(outer - inner < 0.01 * volume, "{shape:?} {inner} {volume} {outer}");
        }
        let shape = GeometryShape::Box([0.2, 0.3, 0.5]);
        let Polyhedra { inner, outer } = Polyhedra::of(&Primitive::of(&shape).unwrap(), &pose).unwrap();
        assert!(outer.is_none() && (ClosedMesh::of(&inner).unwrap().volume() - 0.03).abs() < 1e-16);
    }
}
