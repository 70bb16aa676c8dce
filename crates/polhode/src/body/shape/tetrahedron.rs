//! Solid tetrahedron.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, finite};
use crate::body::form::Form;
use crate::body::triangle_mesh::TriangleMesh;
use crate::math::frame::Part;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::{Direction, Position};

/// Solid tetrahedron with given corners.
///
/// ⟨x xᵀ⟩ = 1/20 Σ (p_k − p̄)(p_k − p̄)ᵀ: the sum over its corners, each with a twentieth of the
/// mass
///
/// ```
/// use polhode::body::shape::{Shape, Substance, Tetrahedron};
/// let corner = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let body = Tetrahedron::new(corner)?.mass_properties(Substance::Density(4.0))?;
/// assert!((body.mass() - 4.0).abs() < 1e-15);
/// assert!((body.inertia().matrix()[2][2] - 3.0 / 80.0 * 4.0 * (4.0 + 9.0)).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
///
/// Source: Tonon, J. Math. Stat. 1 (2005) 8.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tetrahedron {
    pub(in crate::body) vertices: [[f64; 3]; 4],
}

/// Volume threshold relative to the product of the edges; a smaller volume may be rounding only.
const FLAT: f64 = 4.0 * f64::EPSILON;

impl Tetrahedron {
    /// Returns the tetrahedron with the given corners, m; both orientations are allowed.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a coordinate is not finite, or if the corners are coplanar.
    pub fn new(vertices: [[f64; 3]; 4]) -> Result<Self, BodyError> {
        for vertex in vertices {
            finite("the tetrahedron's vertex", vertex)?;
        }
        let tetrahedron = Self { vertices };
        let edges = tetrahedron.edges();
        // Lengths are scaled by a power of two near the size: this is exact, and no product
        // overflows.
        let unit = power_of_two_near(edges.iter().map(|edge| edge.max_abs()).fold(0.0, f64::max));
        let [u, v, w] = edges.map(|edge| edge / unit);
        let flat = u.dot(v.cross(w)).abs() / 6.0 <= FLAT * u.norm() * v.norm() * w.norm();
        if flat {
            let value = tetrahedron.volume();
            let rule = "positive: its corners may not lie in one plane";
            return Err(BodyError::Parameter { what: "the tetrahedron's volume", value, rule });
        }
        representable(tetrahedron)
    }

    /// Returns the vectors from the first corner to the others, m.
    fn edges(&self) -> [Direction<Part>; 3] {
        let [o, a, b, c] = self.vertices.map(Direction::from_array);
        [a - o, b - o, c - o]
    }

    fn volume(&self) -> f64 {
        let [u, v, w] = self.edges();
        u.dot(v.cross(w)).abs() / 6.0
    }
}

impl Shape for Tetrahedron {
    fn spread(&self) -> Spread {
        let [u, v, w] = self.edges();
        // Relative to the first corner, so that a position far from the origin costs no digits.
        let center = (u + v + w) * 0.25;
        let corners = [-center, u - center, v - center, w - center];
        let sum = corners.iter().fold(Symmetric3::default(), |sum, d| sum + Symmetric3::outer(d.to_array()));
        Spread {
            extent: Extent::Volume(self.volume()),
            centroid: Position::from_array(self.vertices[0]) + center.as_quantity(),
            covariance: sum * 0.05,
        }
    }

    fn surface_area(&self) -> f64 {
        let [u, v, w] = self.edges();
        0.5 * (u.cross(v).norm() + v.cross(w).norm() + w.cross(u).norm() + (v - u).cross(w - u).norm())
    }

    fn form(&self) -> Option<Form> {
        let [u, v, w] = self.edges();
        let outward = if u.cross(v).dot(w) > 0.0 {
            [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        } else {
            [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]
        };
        TriangleMesh::new(self.vertices.to_vec(), outward.to_vec()).ok().map(Form::Mesh)
    }
}
