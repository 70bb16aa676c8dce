//! Errors of a mesh that bounds no solid.

use super::TriangleMesh;
use super::diagnosis::MeshDiagnosis;
use super::places::MeshPlaces;
use crate::body::error::BodyError;

/// All errors of a mesh that bounds no solid, with their places.
/// [`ClosedMesh::or_flaws`](crate::body::mesh::ClosedMesh::or_flaws) returns it.
///
/// ```
/// use polhode::body::BodyError;
/// use polhode::body::mesh::{ClosedMesh, TriangleMesh};
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let torn = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z, y]])?;
/// let flaws = ClosedMesh::or_flaws(&torn, 100, &|| true).err().ok_or("it is open")?;
/// assert!(matches!(flaws.first, BodyError::OpenMesh { edges: 3, .. }) && flaws.others.is_empty());
/// assert_eq!(flaws.places.boundary[0].ends, [y, x]);
/// assert_eq!((flaws.surface.triangles().len(), flaws.surface.vertices().len()), (3, 4));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshFlaws {
    /// Error that [`ClosedMesh::of`](crate::body::mesh::ClosedMesh::of) returns.
    pub first: BodyError,
    /// All other errors of the mesh.
    pub others: Vec<BodyError>,
    /// Diagnosis of the mesh: numbers of defects and properties.
    pub diagnosis: MeshDiagnosis,
    /// Places of the defects.
    pub places: MeshPlaces,
    /// Triangles of the input in their order, each vertex once.
    pub surface: TriangleMesh,
}

impl MeshFlaws {
    /// Returns all errors.
    pub fn errors(&self) -> impl Iterator<Item = &BodyError> {
        core::iter::once(&self.first).chain(&self.others)
    }
}
