//! What a part looks like.

use super::triangle_mesh::TriangleMesh;
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;

/// The surface of a part in its own axes, for those who draw it; nothing is computed from it. Lengths are in m.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Form {
    /// Its middle is the origin, its edges lie along the axes.
    Box {
        /// Edges.
        size: [f64; 3],
    },
    /// Its middle is the origin; a sphere has three equal semi-axes.
    Ellipsoid {
        /// Along x, y and z.
        semi_axes: [f64; 3],
    },
    /// Its middle is the origin, its axis lies along z.
    Cylinder {
        /// Of its wall.
        radius: f64,
        /// Radius of its bore: zero of a solid or a closed can, `radius` of a thin tube without ends.
        inner_radius: f64,
        /// From end to end.
        length: f64,
    },
    /// Its middle is the origin.
    HollowSphere {
        /// Outer radius.
        radius: f64,
        /// Radius of the cavity.
        inner_radius: f64,
    },
    /// The middle of its base is the origin, its axis lies along +z.
    Cone {
        /// At z = 0.
        base_radius: f64,
        /// At z = height; zero for a tip.
        top_radius: f64,
        /// Along z.
        height: f64,
    },
    /// The thin wall of a cone or a frustum; the middle of its base is the origin, its axis lies along +z.
    ConeShell {
        /// Radius at z = 0.
        base_radius: f64,
        /// Radius at z = height; zero for a tip.
        top_radius: f64,
        /// Height, from z = 0.
        height: f64,
        /// True if two disks close it.
        ends: bool,
    },
    /// A cylinder between two half balls, its middle at the origin, its axis along z.
    Capsule {
        /// Of the cylinder and the balls.
        radius: f64,
        /// Of the cylinder.
        length: f64,
    },
    /// Its middle is the origin, its axis lies along z.
    Torus {
        /// From the middle to the middle of the tube.
        ring_radius: f64,
        /// Of the tube.
        tube_radius: f64,
    },
    /// A thin rod along z, its middle at the origin.
    Rod {
        /// From end to end.
        length: f64,
    },
    /// A thin disk across z, its middle at the origin.
    Disk {
        /// Of its rim.
        radius: f64,
    },
    /// A thin rectangle across z, its middle at the origin.
    Plate {
        /// Edges along x and y.
        size: [f64; 2],
    },
    /// A triangle in the plane z = 0, from −length/2 to length/2 along z.
    TriangularPrism {
        /// Corners (x, y).
        vertices: [[f64; 2]; 3],
        /// Length along z; zero of a thin plate.
        length: f64,
    },
    /// Triangles, counter-clockwise from outside.
    Mesh(TriangleMesh),
    /// The part's particles are atoms: the symbol of each, in their order.
    Molecule(Vec<&'static str>),
}

/// A form at its place in the body.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedForm {
    /// In the part's own axes.
    pub form: Form,
    /// Where the part's origin is.
    pub position: Position<Body>,
    /// R_body_part.
    pub rotation: Rotation<Body, Part>,
}
