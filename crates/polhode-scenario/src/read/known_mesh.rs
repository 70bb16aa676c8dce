//! A mesh that a text may name, and whose file is not read for it.

use std::path::PathBuf;

use polhode_shape::mesh::MeshSolid;

/// A mesh that was read from its file, in a unit that was given.
#[derive(Clone, Debug)]
pub(crate) struct KnownMesh {
    pub path: PathBuf,
    pub unit: Option<f64>,
    pub solid: MeshSolid,
}
