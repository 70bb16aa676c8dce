//! A mesh that a text may name, and whose file is not read for it.

use std::path::PathBuf;

use crate::mesh::MeshSolid;

/// A mesh that was read from its file, in a unit that was given.
#[derive(Clone, Debug)]
pub(crate) struct KnownMesh {
    pub(crate) path: PathBuf,
    pub(crate) unit: Option<f64>,
    pub(crate) solid: MeshSolid,
}
