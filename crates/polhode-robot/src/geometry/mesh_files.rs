//! Mesh files that have been read, each once: by its path, and by what is in it, as robots that are variants of each other come with copies.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::Mesh;

/// A mesh that is read when it is first asked for; whoever asks meanwhile waits.
type MeshOnce = OnceLock<Result<Arc<Mesh>, String>>;

/// What has been read, for several threads.
#[derive(Debug, Default)]
pub(super) struct MeshFiles(Mutex<Known>);

#[derive(Debug, Default)]
struct Known {
    by_path: HashMap<PathBuf, Arc<MeshOnce>>,
    by_size: HashMap<u64, Vec<PathBuf>>,
}

impl MeshFiles {
    /// The mesh in a file, read now if it has not been.
    pub(super) fn mesh(
        &self,
        path: &Path,
        read: impl FnOnce(&Path) -> Result<Mesh, String>,
    ) -> Result<Arc<Mesh>, String> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mesh = known.file(path);
        drop(known);
        mesh.get_or_init(|| read(path).map(Arc::new)).clone()
    }
}

impl Known {
    fn file(&mut self, path: &Path) -> Arc<MeshOnce> {
        if let Some(mesh) = self.by_path.get(path) {
            return Arc::clone(mesh);
        }
        let same = self.copy_of(path).and_then(|copy| self.by_path.get(&copy)).map(Arc::clone);
        let mesh = same.unwrap_or_default();
        self.by_path.insert(path.to_owned(), Arc::clone(&mesh));
        mesh
    }

    /// A file with the same bytes and ending. glTF names other files, so that equal bytes say nothing of it.
    fn copy_of(&mut self, path: &Path) -> Option<PathBuf> {
        let ending = |path: &Path| path.extension().map(OsStr::to_ascii_lowercase);
        let own = ending(path).filter(|ending| ending != "gltf" && ending != "glb")?;
        let others = self.by_size.entry(fs::metadata(path).ok()?.len()).or_default();
        let bytes = if others.is_empty() { Vec::new() } else { fs::read(path).ok()? };
        let is_same = |other: &&PathBuf| {
            ending(other).as_ref() == Some(&own) && fs::read(other).is_ok_and(|others| others == bytes)
        };
        let same = others.iter().find(is_same).cloned();
        if same.is_none() {
            others.push(path.to_owned());
        }
        same
    }
}
