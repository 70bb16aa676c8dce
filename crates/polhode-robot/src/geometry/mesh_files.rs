//! Cache of mesh files. Each is read once, by path and by content, because variants of a robot
//! often contain copies of the same meshes.

use std::cmp::Reverse;
use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::io::{self, BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use polhode_source::files::{Files, Look};

use super::Mesh;
use crate::model::{GeometryShape, RobotModel};

/// Mesh that is read at the first request; concurrent requests wait for it.
pub(super) type MeshOnce = OnceLock<Result<Arc<Mesh>, String>>;

/// Thread-safe cache of meshes.
#[derive(Debug, Default)]
pub(super) struct MeshFiles {
    by_path: Mutex<HashMap<PathBuf, Arc<MeshOnce>>>,
    /// Distinct files by size and extension. The lock on an entry blocks only requests for files of
    /// the same size and extension.
    by_size: Mutex<HashMap<(u64, OsString), Arc<Alike>>>,
}

/// Distinct files of one size and extension.
type Alike = Mutex<Vec<(PathBuf, Arc<MeshOnce>)>>;

impl MeshFiles {
    /// Returns the mesh of a file, and reads it at the first request.
    pub(super) fn mesh(
        &self,
        files: &dyn Files,
        path: &Path,
        read: impl FnOnce(&Path) -> Result<Mesh, String>,
    ) -> Result<Arc<Mesh>, String> {
        let known = locked(&self.by_path).get(path).cloned();
        let mesh = known.unwrap_or_else(|| {
            let mesh = self.file(files, path);
            locked(&self.by_path).entry(path.to_owned()).or_insert(mesh).clone()
        });
        mesh.get_or_init(|| read(path).map(Arc::new)).clone()
    }

    /// Returns the cache entry of a file with the same bytes and extension, or a new one. glTF
    /// files refer to other files, so equal bytes do not imply equal meshes.
    fn file(&self, files: &dyn Files, path: &Path) -> Arc<MeshOnce> {
        let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
        let size = files.look(path).ok().filter(Look::is_file).map(|look| look.length);
        let (Some(size), false) = (size, ending == "gltf" || ending == "glb") else { return Arc::default() };
        let alike = Arc::clone(locked(&self.by_size).entry((size, ending)).or_default());
        let mut alike = locked(&alike);
        let same = alike.iter().find(|(other, _)| have_same_bytes(files, [path, other]).unwrap_or(false));
        if let Some((_, mesh)) = same {
            return Arc::clone(mesh);
        }
        let mesh = Arc::default();
        alike.push((path.to_owned(), Arc::clone(&mesh)));
        mesh
    }
}

pub(super) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Compares two files block by block; most files of equal size differ in the first block.
fn have_same_bytes(files: &dyn Files, [one, other]: [&Path; 2]) -> io::Result<bool> {
    let [mut one, mut other] =
        [files.open(one)?, files.open(other)?].map(|file| BufReader::with_capacity(PIECE, file));
    loop {
        let [a, b] = [one.fill_buf()?, other.fill_buf()?];
        let length = a.len().min(b.len());
        if a[..length] != b[..length] || length == 0 {
            return Ok(a.is_empty() && b.is_empty());
        }
        one.consume(length);
        other.consume(length);
    }
}

/// Block size of the comparison, bytes.
const PIECE: usize = 1 << 16;

/// Returns the mesh files of models, each once, the largest first. In this order, threads that
/// share them finish at about the same time.
pub fn mesh_files<'a>(files: &dyn Files, models: impl Iterator<Item = &'a RobotModel>) -> Vec<PathBuf> {
    let mut seen = HashSet::new();
    let geometry = models.flat_map(|model| &model.links).flat_map(|link| &link.geometry);
    let paths = geometry.filter_map(|geometry| match &geometry.shape {
        GeometryShape::Mesh { path: Ok(path), .. } => Some(path),
        _ => None,
    });
    let mut meshes: Vec<_> = paths.filter(|path| seen.insert(path.as_path())).cloned().collect();
    meshes.sort_by_cached_key(|path| Reverse(files.look(path).map_or(0, |look| look.length)));
    meshes
}
