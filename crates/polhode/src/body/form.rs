//! Shapes of parts, for drawing.

use super::triangle_mesh::TriangleMesh;
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;

/// Surface of a part in its own axes, for drawing; no computation uses it. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Form {
    /// Box with its centre at the origin and its edges along the axes.
    Box {
        /// Edge lengths along x, y and z, m.
        size: [f64; 3],
    },
    /// Ellipsoid with its centre at the origin; a sphere has three equal semi-axes.
    Ellipsoid {
        /// Semi-axes along x, y and z, m.
        semi_axes: [f64; 3],
    },
    /// Cylinder with its centre at the origin and its axis along z.
    Cylinder {
        /// Outer radius, m.
        radius: f64,
        /// Radius of the bore, m: zero for a solid or a closed can, `radius` for a thin tube
        /// without ends.
        inner_radius: f64,
        /// Length along z, from end to end, m.
        length: f64,
    },
    /// Hollow sphere with its centre at the origin.
    HollowSphere {
        /// Outer radius, m.
        radius: f64,
        /// Radius of the cavity, m.
        inner_radius: f64,
    },
    /// Cone or frustum with the centre of its base at the origin and its axis along +z.
    Cone {
        /// Radius at z = 0, m.
        base_radius: f64,
        /// Radius at z = `height`, m; zero for a pointed cone.
        top_radius: f64,
        /// Height along z, m.
        height: f64,
    },
    /// Thin wall of a cone or a frustum, with the centre of its base at the origin and its axis
    /// along +z.
    ConeShell {
        /// Radius at z = 0, m.
        base_radius: f64,
        /// Radius at z = `height`, m; zero for a pointed cone.
        top_radius: f64,
        /// Height along z, from z = 0, m.
        height: f64,
        /// True if two disks close the shell.
        ends: bool,
    },
    /// Cylinder between two half balls, with its centre at the origin and its axis along z.
    Capsule {
        /// Radius of the cylinder and of the half balls, m.
        radius: f64,
        /// Length of the cylinder, m.
        length: f64,
    },
    /// Torus with its centre at the origin and its axis along z.
    Torus {
        /// Distance from the centre of the torus to the centre line of the tube, m.
        ring_radius: f64,
        /// Radius of the tube, m.
        tube_radius: f64,
    },
    /// Thin rod along z with its centre at the origin.
    Rod {
        /// Length from end to end, m.
        length: f64,
    },
    /// Thin disk perpendicular to z with its centre at the origin.
    Disk {
        /// Radius of the rim, m.
        radius: f64,
    },
    /// Thin rectangle perpendicular to z with its centre at the origin.
    Plate {
        /// Edge lengths along x and y, m.
        size: [f64; 2],
    },
    /// Triangular prism: a triangle in the xy plane, from −`length`/2 to `length`/2 along z.
    TriangularPrism {
        /// Corners (x, y), m.
        vertices: [[f64; 2]; 3],
        /// Length along z, m; zero for a thin plate.
        length: f64,
    },
    /// Triangle mesh, counter-clockwise seen from outside.
    Mesh(TriangleMesh),
    /// Molecule: the chemical symbols of the part's particles, in their order.
    Molecule(Vec<&'static str>),
}

/// Shape of a part at its position and orientation in the body.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedForm {
    /// Shape in the part's own axes.
    pub form: Form,
    /// Position of the part's origin, body axes, m.
    pub position: Position<Body>,
    /// Rotation R_body_part.
    pub rotation: Rotation<Body, Part>,
}
