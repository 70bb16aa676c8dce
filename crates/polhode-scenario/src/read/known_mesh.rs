//! Cached mesh, whose file is not read again.

use std::path::PathBuf;

use polhode_shape::mesh::MeshSolid;

/// Mesh read from a file with a given unit of length.
#[derive(Clone, Debug)]
pub(crate) struct KnownMesh {
    pub path: PathBuf,
    pub unit: Option<f64>,
    pub solid: MeshSolid,
}
