//! Cache of meshes in models. Each is measured once, by content, because robots repeat meshes.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use super::Mesh;
use super::mesh_files::{MeshOnce, locked};
use crate::model::InlineMesh;

/// Distinct meshes with one hash.
type Alike = Vec<(Arc<InlineMesh>, Arc<MeshOnce>)>;

/// Thread-safe cache of meshes in models, by the hash of their content.
#[derive(Debug, Default)]
pub(super) struct InlineMeshes(Mutex<HashMap<u64, Alike>>);

impl InlineMeshes {
    /// Returns a measured mesh, and measures it at the first request.
    pub(super) fn mesh(
        &self,
        inline: &Arc<InlineMesh>,
        measure: impl FnOnce(&InlineMesh) -> Result<Mesh, String>,
    ) -> Result<Arc<Mesh>, String> {
        let mut all = locked(&self.0);
        let alike = all.entry(inline.content_hash()).or_default();
        let known = alike.iter().find(|(other, _)| Arc::ptr_eq(other, inline) || other == inline);
        let mesh = known.map(|(_, mesh)| Arc::clone(mesh)).unwrap_or_default();
        if known.is_none() {
            alike.push((Arc::clone(inline), Arc::clone(&mesh)));
        }
        drop(all);
        mesh.get_or_init(|| measure(inline).map(Arc::new)).clone()
    }
}
