//! Mesh files that have been read, each once: by its path, and by what is in it, as robots that are variants of each other come with copies.

use std::cmp::Reverse;
use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::io::{self, BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use polhode_source::files::{Files, Look};

use super::Mesh;
use crate::model::{GeometryShape, RobotModel};

/// A mesh that is read when it is first asked for; whoever asks meanwhile waits.
type MeshOnce = OnceLock<Result<Arc<Mesh>, String>>;

/// What has been read, for several threads.
#[derive(Debug, Default)]
pub(super) struct MeshFiles {
    by_path: Mutex<HashMap<PathBuf, Arc<MeshOnce>>>,
    /// Different files with so many bytes and this ending: whoever compares them keeps others from these alone.
    by_size: Mutex<HashMap<(u64, OsString), Arc<Alike>>>,
}

/// Files of one size and ending that differ.
type Alike = Mutex<Vec<(PathBuf, Arc<MeshOnce>)>>;

impl MeshFiles {
    /// The mesh in a file, read now if it has not been.
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

    /// What is known of a file with the same bytes and ending, or else nothing yet. glTF names other files, so that equal bytes say nothing
    /// of it.
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

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Piece by piece: most files of one size are different from the first pieces on.
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

/// Bytes that are compared at once.
const PIECE: usize = 1 << 16;

/// The mesh files of models, each once, the largest first: in this order threads that share them end at about the same time.
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
