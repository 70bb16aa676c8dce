//! Boxes, spheres, cylinders, capsules and ellipsoids of a model.

use polhode::body::BodyError;
use polhode::body::shape::{BoxShape, Capsule, Cylinder, Ellipsoid, Shape, Sphere};

use super::Reach;
use crate::model::{GeometryShape, Pose};
use crate::pose::{dot, sum};

/// A shape with a formula for its moments, and how far it goes.
pub(super) struct Primitive {
    pub(super) shape: Box<dyn Shape>,
    outline: Outline,
}

enum Outline {
    /// Half edges.
    Box([f64; 3]),
    /// Half axes.
    Ellipsoid([f64; 3]),
    /// Two discs, or two balls, at ± this on z.
    Ends { half: f64, radius: f64, balls: bool },
}

impl Primitive {
    pub(super) fn of(shape: &GeometryShape) -> Result<Self, BodyError> {
        let none = BodyError::Empty { what: "primitives" };
        Ok(match *shape {
            GeometryShape::Box(size) => {
                Self { shape: Box::new(BoxShape::new(size)?), outline: Outline::Box(size.map(|c| 0.5 * c)) }
            }
            GeometryShape::Sphere(radius) => Self {
                shape: Box::new(Sphere::new(radius)?),
                outline: Outline::Ends { half: 0.0, radius, balls: true },
            },
            GeometryShape::Cylinder { radius, length } => Self {
                shape: Box::new(Cylinder::new(radius, length)?),
                outline: Outline::Ends { half: 0.5 * length, radius, balls: false },
            },
            GeometryShape::Capsule { radius, length } => Self {
                shape: Box::new(Capsule::new(radius, length)?),
                outline: Outline::Ends { half: 0.5 * length, radius, balls: true },
            },
            GeometryShape::Ellipsoid(half_axes) => {
                Self { shape: Box::new(Ellipsoid::new(half_axes)?), outline: Outline::Ellipsoid(half_axes) }
            }
            GeometryShape::Mesh { .. } | GeometryShape::Other(_) => return Err(none),
        })
    }

    /// How far it goes when it is placed.
    pub(super) fn reach(&self, pose: &Pose) -> Reach {
        let center = pose.position;
        let rows = pose.matrix();
        match self.outline {
            Outline::Box(half) => {
                let corner = |k: usize| {
                    let sign = |bit: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
                    pose.placed([0, 1, 2].map(|j| sign(j) * half[j]))
                };
                Reach::of((0..8).map(corner))
            }
            Outline::Ellipsoid(half) => {
                // max of n·x over the ellipsoid: |S Rᵀ n|
                let wide = rows.map(|row| [0, 1, 2].map(|j| row[j] * half[j])).map(|v| dot(v, v).sqrt());
                let longest = half.iter().fold(0.0_f64, |max, c| max.max(*c));
                Reach { extent: dot(center, center).sqrt() + longest, bounds: around(center, wide) }
            }
            Outline::Ends { half, radius, balls } => {
                let axis = rows.map(|row| row[2]);
                let along = axis.map(|a| half * a.abs());
                let across =
                    axis.map(|a| if balls { radius } else { radius * (1.0 - a * a).max(0.0).sqrt() });
                let farthest = [-half, half].map(|z| {
                    let end = sum(center, axis.map(|a| z * a));
                    if balls {
                        return dot(end, end).sqrt() + radius;
                    }
                    // the rim: as far along the axis as the disc, and its radius beyond the disc's middle
                    let high = dot(end, axis);
                    let aside = (dot(end, end) - high * high).max(0.0).sqrt();
                    high.hypot(aside + radius)
                });
                Reach { extent: farthest[0].max(farthest[1]), bounds: around(center, sum(along, across)) }
            }
        }
    }
}

fn around(center: [f64; 3], half: [f64; 3]) -> [[f64; 3]; 2] {
    [sum(center, half.map(|c| -c)), sum(center, half)]
}
