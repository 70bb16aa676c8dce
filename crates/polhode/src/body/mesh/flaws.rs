//! Why a mesh bounds no solid.

use super::TriangleMesh;
use super::diagnosis::MeshDiagnosis;
use super::places::MeshPlaces;
use crate::body::error::BodyError;

/// Why a mesh bounds no solid, all that is wrong with it, and where: what [`ClosedMesh::or_flaws`](crate::body::mesh::ClosedMesh::or_flaws)
/// finds instead of one.
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
    /// What [`ClosedMesh::of`](crate::body::mesh::ClosedMesh::of) says.
    pub first: BodyError,
    /// What else is wrong.
    pub others: Vec<BodyError>,
    /// What is right and wrong, in numbers.
    pub diagnosis: MeshDiagnosis,
    /// Where.
    pub places: MeshPlaces,
    /// The triangles as they were given, in their order, each vertex once.
    pub surface: TriangleMesh,
}

impl MeshFlaws {
    /// All that is wrong.
    pub fn errors(&self) -> impl Iterator<Item = &BodyError> {
        core::iter::once(&self.first).chain(&self.others)
    }
}
