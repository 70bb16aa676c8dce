//! Triangles and their corners, as read from files.

use super::error::BodyError;
use crate::math::frame::Part;
use crate::math::vector::Position;

/// Triangle as its three corners, m, counter-clockwise seen from outside.
pub type Triangle = [[f64; 3]; 3];

/// Triangles and their corners as read from a file; they need not bound a solid.
///
/// [`ClosedMesh`](super::mesh::ClosedMesh) is the solid that they bound, if they do. A vertex may
/// occur more than once: corners are the same point if their coordinates are exactly equal.
///
/// ```
/// use polhode::body::mesh::TriangleMesh;
/// use polhode::math::{Part, Position};
/// let vertices = vec![Position::<Part>::ZERO, Position::new(2.0, 0.0, 0.0), Position::new(0.0, 3.0, 0.0)];
/// let flake = TriangleMesh::new(vertices.clone(), vec![[0, 1, 2]])?;
/// assert_eq!(flake.vertices().last(), Some(Position::new(0.0, 3.0, 0.0)));
/// assert_eq!(flake.corners().next(), Some([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]));
/// assert!(TriangleMesh::new(vertices, vec![[0, 1, 3]]).is_err());
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// True if the mesh was built as a convex hull by exact signs, so that it cannot intersect
    /// itself.
    pub(super) is_hull: bool,
}

impl TriangleMesh {
    /// Returns a mesh from vertices, m, as positions or arrays, and triangles as vertex indices
    /// from 0.
    ///
    /// # Errors
    /// [`BodyError::Vertex`] for a triangle's vertex that is not finite; [`BodyError::VertexIndex`]
    /// for an index out of range.
    pub fn new<V: Into<Position<Part>>>(
        vertices: Vec<V>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self, BodyError> {
        // Converts in place, without a copy.
        let vertices: Vec<_> = vertices.into_iter().map(|vertex| vertex.into().to_array()).collect();
        for (k, corners) in triangles.iter().enumerate() {
            for &index in corners {
                match vertices.get(index as usize) {
                    None => {
                        let (triangle, vertices) = (k + 1, vertices.len());
                        return Err(BodyError::VertexIndex { triangle, index: index as usize, vertices });
                    }
                    Some(&vertex) if vertex.iter().any(|c| !c.is_finite()) => {
                        return Err(BodyError::Vertex { triangle: k + 1, vertex });
                    }
                    Some(_) => {}
                }
            }
        }
        Ok(Self { vertices, triangles, is_hull: false })
    }

    /// Returns a mesh from triangles without shared indices, as in STL.
    ///
    /// # Errors
    /// [`BodyError::Vertex`] for a vertex that is not finite; [`BodyError::Parameter`] if the
    /// vertices exceed the range of 32-bit indices.
    pub fn of_triangles(triangles: &[Triangle]) -> Result<Self, BodyError> {
        Self::of_soup(triangles.to_vec())
    }

    /// Works like [`TriangleMesh::of_triangles`], but takes ownership of the triangles and needs no
    /// copy.
    ///
    /// # Errors
    /// The errors of [`TriangleMesh::of_triangles`].
    pub fn of_soup(triangles: Vec<Triangle>) -> Result<Self, BodyError> {
        numbered(3 * triangles.len())?;
        let is_finite = |t: &Triangle| t.as_flattened().iter().fold(true, |all, c| all & c.is_finite());
        if let Some(k) = triangles.iter().position(|triangle| !is_finite(triangle)) {
            let vertex = triangles[k].into_iter().find(|vertex| vertex.iter().any(|c| !c.is_finite()));
            return Err(BodyError::Vertex { triangle: k + 1, vertex: vertex.unwrap_or_default() });
        }
        let indices = (0..triangles.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        Ok(Self { vertices: triangles.into_flattened(), triangles: indices, is_hull: false })
    }

    /// Returns the vertices in the order of their indices, m.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = Position<Part>> {
        self.vertices.iter().copied().map(Position::from_array)
    }

    /// Returns the coordinates of the vertices as stored in memory, m.
    pub fn coordinates(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// Returns the triangles as vertex indices, from 0.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Returns the triangles as corner coordinates, m.
    pub fn corners(&self) -> impl Iterator<Item = Triangle> + '_ {
        self.triangles.iter().map(|corners| corners.map(|index| self.vertices[index as usize]))
    }

    /// Returns twice the area vector of each triangle, m², along its normal: (b − a) × (c − a).
    pub fn area_vectors(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.corners().map(normal)
    }

    /// Returns a mesh with the triangles of both meshes.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the vertices exceed the range of 32-bit indices.
    pub fn joined(mut self, other: &Self) -> Result<Self, BodyError> {
        numbered(self.vertices.len() + other.vertices.len())?;
        let first = self.vertices.len() as u32;
        self.triangles.extend(other.triangles.iter().map(|corners| corners.map(|index| index + first)));
        self.vertices.extend_from_slice(&other.vertices);
        self.is_hull = false;
        Ok(self)
    }

    /// Returns the mesh with every coordinate multiplied by a factor, for another unit of length.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.vertices.iter_mut().flatten().for_each(|c| *c *= factor);
        self
    }
}

/// Returns an error if the number of vertices exceeds the range of the indices.
fn numbered(vertices: usize) -> Result<(), BodyError> {
    if u32::try_from(vertices).is_ok() {
        return Ok(());
    }
    Err(BodyError::Parameter { what: "the number of vertices", value: vertices as f64, rule: "below 2³²" })
}

/// Returns (b − a) × (c − a), rounded.
pub(super) fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let from = |q: [f64; 3]| [q[0] - a[0], q[1] - a[1], q[2] - a[2]];
    let ([bx, by, bz], [cx, cy, cz]) = (from(b), from(c));
    [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx]
}
