//! Numeric data of the equations, along the axes of the body's surface and of the ground.

use super::ground::{Ground, GroundShape};
use super::law::ContactLaw;
use super::surface::{BodySurface, SurfaceShape};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::Acceleration;

/// Body, its surface, the ground and the contact law.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Model {
    pub(super) mass: f64,
    /// Inertia tensor about the centre of mass, and its inverse.
    pub(super) inertia: [[f64; 3]; 3],
    pub(super) inverse_inertia: [[f64; 3]; 3],
    /// Inertia about the third axis, for a lying cylinder, whose axis keeps its direction.
    pub(super) axis_inertia: Option<f64>,
    /// Vector from the centre of mass to the centre of the surface.
    pub(super) offset: [f64; 3],
    pub(super) surface: SurfaceForm,
    pub(super) ground: GroundForm,
    /// Gravity along the axes of the ground.
    pub(super) gravity: [f64; 3],
    /// Rate of turning of the ground about its third axis.
    pub(super) turning: f64,
    pub(super) kinetic: f64,
    pub(super) viscous: f64,
    /// Lengths of rolling and pivoting resistance, m.
    pub(super) rolling: f64,
    pub(super) pivoting: f64,
    /// Rotations of the surface axes in the body, and of the ground axes in space.
    pub(super) in_body: Rotation<Body, Part>,
    pub(super) in_space: Rotation<Space, Part>,
}

/// Convex surface relative to its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SurfaceForm {
    /// Circle about z with a tube around it. A zero radius is a sphere, a zero tube a sharp edge.
    /// `height` is the position along z.
    Rim { radius: f64, tube: f64, height: f64 },
    /// Ellipsoid, by the squares of its semi-axes.
    Ellipsoid { squares: [f64; 3] },
}

/// Ground in its own axes: a plane z = 0, a sphere about the origin, or a cylinder about z. A
/// radius is negative for contact from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum GroundForm {
    Plane,
    Sphere { radius: f64 },
    Cylinder { radius: f64 },
}

impl GroundForm {
    /// Returns the point at a place.
    pub(super) fn position(self, [a, b, c]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Plane => [a, b, 0.0],
            Self::Sphere { radius } => [a, b, c].map(|x| -radius * x),
            Self::Cylinder { radius } => [-radius * a, -radius * b, c],
        }
    }

    /// Returns the place of a point.
    pub(super) fn place(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Plane => [x, y, 0.0],
            Self::Sphere { radius } => {
                let length = x.hypot(y).hypot(z) * -radius.signum();
                [x, y, z].map(|x| x / length)
            }
            Self::Cylinder { radius } => {
                let length = x.hypot(y) * -radius.signum();
                [x / length, y / length, z]
            }
        }
    }
}

impl Model {
    pub(super) fn of(
        body: &MassProperties<Body>,
        surface: &BodySurface,
        ground: &Ground,
        law: &ContactLaw,
        gravity: Acceleration<Space>,
        side: f64,
    ) -> Self {
        let (in_body, in_space) = (surface.axes(), ground.axes());
        let inertia = body.inertia().in_frame(in_body.inverse());
        let rows = inertia.matrix();
        let offset = in_body.inverse() * (surface.center() - body.center_of_mass());
        let gravity = (in_space.inverse() * gravity).to_array();
        let friction = law.friction();
        Self {
            mass: body.mass(),
            inertia: rows,
            inverse_inertia: inverse(rows),
            axis_inertia: matches!(surface.shape(), SurfaceShape::Cylinder { .. }).then_some(rows[2][2]),
            offset: offset.to_array(),
            surface: match *surface.shape() {
                SurfaceShape::Sphere { radius } | SurfaceShape::Cylinder { radius, .. } => {
                    SurfaceForm::Rim { radius: 0.0, tube: radius, height: 0.0 }
                }
                SurfaceShape::Rim { radius, tube, thickness } => {
                    SurfaceForm::Rim { radius, tube, height: 0.5 * side * thickness }
                }
                SurfaceShape::Ellipsoid { semi_axes } => {
                    SurfaceForm::Ellipsoid { squares: semi_axes.map(|a| a * a) }
                }
            },
            ground: match *ground.shape() {
                GroundShape::Plane => GroundForm::Plane,
                GroundShape::Sphere { radius, side } => GroundForm::Sphere { radius: side.signed(radius) },
                GroundShape::Cylinder { radius, side } => {
                    GroundForm::Cylinder { radius: side.signed(radius) }
                }
            },
            gravity,
            turning: ground.turning(),
            kinetic: friction.kinetic,
            viscous: friction.viscous,
            rolling: law.resistance().rolling,
            pivoting: law.resistance().pivoting,
            in_body,
            in_space,
        }
    }
}

/// Inverts a tensor of inertia.
fn inverse([a, b, c]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let rows = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = a[0] * rows[0][0] + a[1] * rows[0][1] + a[2] * rows[0][2];
    rows.map(|row| row.map(|x| x / determinant))
}
