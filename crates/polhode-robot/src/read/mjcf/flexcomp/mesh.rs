//! Points of meshes: their vertices, each once.

use std::collections::HashMap;
use std::path::PathBuf;

use crate::pose::{cross, dot};

use super::super::surface::{Surface, size};
use super::super::{Branch, Reader};
use super::{Flex, Lattice, TEXT_OF_A_POINT, exactly};

impl<'a> Reader<'_, 'a, '_> {
    /// What `file` or `mesh` names: the points of its triangles or lines, or of the tetrahedra between its triangles and `origin`.
    pub(super) fn of_mesh(&mut self, branch: &Branch<'a>, flex: &Flex<'a>) -> Result<Lattice, String> {
        let element = branch.element;
        let origin = element.attribute("origin").map(|_| exactly(element, "origin", [0.0; 3])).transpose()?;
        let dim = flex.dim;
        let surface = if let Some(name) = element.word("mesh") {
            let asset = self.asset(name, branch.context)?;
            self.elements = self.elements.saturating_add(asset.size() / TEXT_OF_A_POINT);
            asset.surface()?
        } else {
            let path = self.flex_file(branch)?;
            if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("msh")) {
                return Err("its file is a .msh mesh, and MuJoCo refuses the file".to_owned());
            }
            let surface = if dim == 1 { Surface::lines(&path) } else { Surface::read(&path) };
            merged(&surface?)
        };
        let points = surface.vertices.iter().map(|vertex| vertex.map(|c| f64::from(c as f32))).collect();
        if surface.triangles.is_empty() {
            return Err("its mesh has no triangles".to_owned());
        }
        let corners = surface.triangles.iter().map(|triangle| triangle.map(|k| k as usize));
        let lattice = |points, elements: Vec<usize>| Lattice { dim, points, elements: Some(elements) };
        match (dim, origin) {
            (1, _) => Ok(lattice(points, corners.flat_map(|[a, b, _]| [a, b]).collect())),
            (2, _) => Ok(lattice(points, corners.flatten().collect())),
            (_, None) => Err("a mesh of dim 3 needs an origin, and MuJoCo refuses the file".to_owned()),
            (_, Some(origin)) => Ok(tetrahedra(origin, points, corners)),
        }
    }

    /// The file that the element of a branch names.
    pub(super) fn flex_file(&mut self, branch: &Branch<'a>) -> Result<PathBuf, String> {
        let written = branch.element.word("file").filter(|file| !file.is_empty());
        let written = written.ok_or("it names no file")?;
        let context = self.contexts.get(branch.context).ok_or("it names no file")?;
        let base = written.rsplit(['/', '\\']).next().unwrap_or(written);
        let file = if context.settings.strip_path { base } else { written };
        let folder = self.folders.get(context.root.tree()).cloned().unwrap_or_default();
        let path = self.roots.resolve(file, &folder.join(context.settings.mesh_folder));
        let path = path.map_err(|why| format!("its file {written:?} cannot be read: {why}"))?;
        self.elements = self.elements.saturating_add(size(&path) / TEXT_OF_A_POINT);
        Ok(path)
    }
}

/// The origin and all points, and the tetrahedra that have volume.
fn tetrahedra(
    origin: [f64; 3],
    mut points: Vec<[f64; 3]>,
    triangles: impl Iterator<Item = [usize; 3]>,
) -> Lattice {
    points.insert(0, origin);
    let mut elements = Vec::new();
    for corners in triangles.map(|triangle| triangle.map(|k| k + 1)) {
        let place = |k: usize| points.get(k).copied().unwrap_or([f64::NAN; 3]);
        let [a, b, c] = corners.map(|k| [0, 1, 2].map(|axis| place(k)[axis] - origin[axis]));
        if dot(cross(a, b), c) >= super::LEAST {
            elements.push(0);
            elements.extend(corners);
        }
    }
    Lattice { dim: 3, points, elements: Some(elements) }
}

/// Vertices at one place as one, in the order in which they come.
fn merged(surface: &Surface) -> Surface {
    let mut numbers = HashMap::new();
    let mut vertices = Vec::new();
    let mut number = |vertex: [f64; 3]| {
        // −0 + 0 = 0
        let key = vertex.map(|c| (c as f32 + 0.0).to_bits());
        *numbers.entry(key).or_insert_with(|| {
            vertices.push(vertex);
            vertices.len() as u32 - 1
        })
    };
    let new: Vec<u32> = surface.vertices.iter().map(|vertex| number(*vertex)).collect();
    let renamed = |k: u32| new.get(k as usize).copied().unwrap_or(u32::MAX);
    let triangles = surface.triangles.iter().map(|triangle| triangle.map(renamed)).collect();
    Surface { vertices, triangles }
}
