//! Geometric primitives of a model: boxes, spheres, cylinders, capsules, ellipsoids and cones.

use polhode::body::shape::{BoxShape, Capsule, Cone, Cylinder, Ellipsoid, Shape, Sphere, Substance};
use polhode::body::{BodyError, MassProperties};
use polhode::math::{Part, Position, Rotation};

use super::Reach;
use crate::model::{GeometryShape, Pose};
use crate::pose::{dot, sum};

/// Shape with closed-form moments and a known extent.
pub(super) struct Primitive {
    shape: Box<dyn Shape>,
    pub(super) outline: Outline,
}

pub(super) enum Outline {
    /// Half edge lengths along x, y, z.
    Box([f64; 3]),
    /// Semi-axes along x, y, z.
    Ellipsoid([f64; 3]),
    /// Disc at z = −half and a point at z = +half.
    Cone { half: f64, radius: f64 },
    /// Two discs, or two balls, at z = ±half.
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
            GeometryShape::Cone { radius, length } => Self {
                shape: Box::new(Cone::new(radius, 0.0, length)?),
                outline: Outline::Cone { half: 0.5 * length, radius },
            },
            GeometryShape::Mesh { .. } | GeometryShape::Inline { .. } | GeometryShape::Other(_) => {
                return Err(none);
            }
        })
    }

    /// Returns the mass properties at density 1 kg/m³, in the frame of the model's shape.
    pub(super) fn mass_properties(&self) -> Result<MassProperties<Part>, BodyError> {
        let own = self.shape.mass_properties(Substance::Density(1.0))?;
        match self.outline {
            // This shape type has its origin at the middle of the cone's base.
            Outline::Cone { half, .. } => own.placed(Position::new(0.0, 0.0, -half), Rotation::identity()),
            _ => Ok(own),
        }
    }

    /// Returns the farthest point of the placed shape in a direction.
    pub(super) fn support(&self, pose: &Pose, direction: [f64; 3]) -> [f64; 3] {
        let rows = pose.matrix();
        let d = [0, 1, 2].map(|j| (0..3).map(|i| rows[i][j] * direction[i]).sum::<f64>());
        let sign = |c: f64| if c < 0.0 { -1.0 } else { 1.0 };
        let along = |v: [f64; 3], radius: f64| {
            let length = dot(v, v).sqrt();
            if length > 0.0 { v.map(|c| radius * c / length) } else { [0.0; 3] }
        };
        let local = match self.outline {
            Outline::Box(half) => [0, 1, 2].map(|k| sign(d[k]) * half[k]),
            // Support point of an ellipsoid: S² d / |S d|.
            Outline::Ellipsoid(half) => {
                let stretched = along([0, 1, 2].map(|k| half[k] * d[k]), 1.0);
                [0, 1, 2].map(|k| half[k] * stretched[k])
            }
            Outline::Cone { half, radius } => {
                let around = along([d[0], d[1], 0.0], radius);
                let rim = sum(around, [0.0, 0.0, -half]);
                let apex = [0.0, 0.0, half];
                if dot(d, rim) > dot(d, apex) { rim } else { apex }
            }
            Outline::Ends { half, radius, balls } => {
                let around = along(if balls { d } else { [d[0], d[1], 0.0] }, radius);
                sum(around, [0.0, 0.0, sign(d[2]) * half])
            }
        };
        pose.placed(local)
    }

    /// Returns the extent of the placed shape.
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
                // Maximum of n·x over the ellipsoid: |S Rᵀ n|.
                let wide = rows.map(|row| [0, 1, 2].map(|j| row[j] * half[j])).map(|v| dot(v, v).sqrt());
                let longest = half.iter().fold(0.0_f64, |max, c| max.max(*c));
                Reach { extent: dot(center, center).sqrt() + longest, bounds: around(center, wide) }
            }
            Outline::Cone { half, radius } => {
                let axis = rows.map(|row| row[2]);
                let [base, apex] = [-half, half].map(|z| sum(center, axis.map(|a| z * a)));
                let across = axis.map(|a| radius * (1.0 - a * a).max(0.0).sqrt());
                let points = [apex, sum(base, across), sum(base, across.map(|c| -c))].into_iter();
                let extent = dot(apex, apex).sqrt().max(rim(base, axis, radius));
                Reach { extent, ..Reach::of(points) }
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
                    rim(end, axis, radius)
                });
                Reach { extent: farthest[0].max(farthest[1]), bounds: around(center, sum(along, across)) }
            }
        }
    }
}

/// Returns the distance of the farthest point of a disc's rim from the origin.
fn rim(middle: [f64; 3], axis: [f64; 3], radius: f64) -> f64 {
    let high = dot(middle, axis);
    let aside = (dot(middle, middle) - high * high).max(0.0).sqrt();
    high.hypot(aside + radius)
}

fn around(center: [f64; 3], half: [f64; 3]) -> [[f64; 3]; 2] {
    [sum(center, half.map(|c| -c)), sum(center, half)]
}
