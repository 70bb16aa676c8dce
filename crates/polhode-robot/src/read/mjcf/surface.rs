//! Mesh files as MuJoCo reads them: only the first shape of an OBJ file, all of STL and MSH.

use std::path::Path;
use std::sync::Arc;

use polhode::body::mesh::{ConvexHull, TriangleMesh};

use polhode_source::files::Files;
use polhode_source::{read_file, read_text_file};

use polhode_shape::mesh::{MeshContents, MeshFormat};

use crate::model::InlineMesh;
use crate::read::xml::Element;

/// Vertices and triangles. Without triangles it is a point cloud.
#[derive(Clone, Debug, Default)]
pub(super) struct Surface {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Reads the attributes `vertex` and `face` of an asset; `None` without vertices.
    pub(super) fn inline(element: Element<'_>) -> Option<Self> {
        let numbers: Vec<f64> = element.attribute("vertex")?.values().collect();
        let vertices = numbers.as_chunks().0.to_vec();
        let faces: Vec<f64> = element.attribute("face").map_or_else(Vec::new, |face| face.values().collect());
        let is_index = |c: &f64| *c >= 0.0 && *c < vertices.len() as f64;
        if !numbers.len().is_multiple_of(3) || !faces.len().is_multiple_of(3) || !faces.iter().all(is_index) {
            return Some(Self::default());
        }
        let triangles = faces.as_chunks().0.iter().map(|corners| corners.map(|c| c as u32)).collect();
        Some(Self { vertices, triangles })
    }

    /// Returns the mesh of vertices and faces in the model; without faces, their convex hull, as in
    /// MuJoCo.
    pub(super) fn mesh(&self) -> Result<Arc<InlineMesh>, String> {
        if self.vertices.is_empty() {
            return Err("its vertex or face has a wrong number, or an index that does not exist".to_owned());
        }
        let surface = match self.triangles.is_empty() {
            true => ConvexHull::of(&self.vertices),
            false => TriangleMesh::new(self.vertices.clone(), self.triangles.clone()),
        };
        let surface = surface.map_err(|error| error.to_string())?;
        Ok(Arc::new(InlineMesh::new(surface, false)))
    }

    /// Reads a mesh file.
    pub(super) fn read(files: &dyn Files, path: &Path) -> Result<Self, String> {
        let ending = path.extension().map_or_else(String::new, |end| end.to_string_lossy().to_lowercase());
        match ending.as_str() {
            "stl" => {
                let contents =
                    MeshContents::read(files, path, MeshFormat::Stl).map_err(|error| error.message())?;
                let mut all = Self::default();
                for part in &contents.parts {
                    let first = all.vertices.len() as u32;
                    all.vertices.extend(part.mesh.coordinates());
                    all.triangles.extend(part.mesh.triangles().iter().map(|t| t.map(|k| k + first)));
                }
                Ok(all)
            }
            "obj" => {
                let read = read_text_file(files, path, |text| Ok(Self::of_obj(text)));
                read.map_err(|error| error.message())?
            }
            "msh" => {
                let read = read_file(files, path, |bytes| Ok(Self::of_msh(bytes)));
                read.map_err(|error| error.message())?
            }
            _ => Err(format!("MuJoCo does not read .{ending} meshes")),
        }
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = [[f64; 3]; 3]> {
        let corner = |k: u32| self.vertices.get(k as usize).copied().unwrap_or([f64::NAN; 3]);
        self.triangles.iter().map(move |triangle| triangle.map(corner))
    }

    /// Reads all vertices, and the triangles of the first object or group that has some.
    /// Quadrangles are split along the shorter diagonal.
    fn of_obj(text: &str) -> Result<Self, String> {
        let mut surface = Self::default();
        let mut is_over = false;
        let joined = text.replace("\\\n", " ").replace("\\\r\n", " ");
        for line in joined.lines() {
            let mut words = line.split_ascii_whitespace();
            match words.next() {
                Some("v") => {
                    let mut next = || words.next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN);
                    surface.vertices.push([next(), next(), next()]);
                }
                Some("g" | "o") => is_over |= !surface.triangles.is_empty(),
                Some("f") if !is_over => {
                    let count = surface.vertices.len() as i64;
                    let index = |word: &str| {
                        let written: i64 = word.split('/').next()?.parse().ok()?;
                        let index = if written < 0 { count + written } else { written - 1 };
                        u32::try_from(index).ok().filter(|&index| i64::from(index) < count)
                    };
                    let corners: Option<Vec<u32>> = words.map(index).collect();
                    let corners = corners.ok_or("one of its faces refers to a vertex that does not exist")?;
                    surface.face(&corners)?;
                }
                _ => {}
            }
        }
        Ok(surface)
    }

    fn face(&mut self, corners: &[u32]) -> Result<(), String> {
        match *corners {
            [a, b, c] => self.triangles.push([a, b, c]),
            [a, b, c, d] => {
                let distance = |p: u32, q: u32| -> f64 {
                    let [p, q] =
                        [p, q].map(|k| self.vertices.get(k as usize).copied().unwrap_or([f64::NAN; 3]));
                    (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum()
                };
                let split = if distance(a, c) < distance(b, d) {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                };
                self.triangles.extend(split);
            }
            _ => return Err(format!("one of its faces has {} corners", corners.len())),
        }
        Ok(())
    }

    /// Reads MuJoCo's MSH format: four counts, then vertices, normals, texture coordinates and
    /// triangles, four bytes each.
    fn of_msh(bytes: &[u8]) -> Result<Self, String> {
        let words = bytes.as_chunks::<4>().0;
        let count = |k: usize| words.get(k).and_then(|word| usize::try_from(i32::from_le_bytes(*word)).ok());
        let sizes = || {
            let (vertices, normals, texture, faces) = (count(0)?, count(1)?, count(2)?, count(3)?);
            let before = 4_usize.checked_add(normals.checked_add(vertices)?.checked_mul(3)?)?;
            let first_face = before.checked_add(texture.checked_mul(2)?)?;
            let all = first_face.checked_add(faces.checked_mul(3)?)?;
            (all.checked_mul(4)? == bytes.len()).then_some((vertices, first_face))
        };
        let (vertices, first_face) = sizes().ok_or("its counts do not match its length")?;
        let (vertices, faces) = (words.get(4..4 + 3 * vertices), words.get(first_face..));
        let vertices = vertices.unwrap_or_default().as_chunks().0;
        let faces = faces.unwrap_or_default().as_chunks().0;
        Ok(Self {
            vertices: vertices
                .iter()
                .map(|v: &[[u8; 4]; 3]| v.map(|c| f64::from(f32::from_le_bytes(c))))
                .collect(),
            triangles: faces.iter().map(|f: &[[u8; 4]; 3]| f.map(u32::from_le_bytes)).collect(),
        })
    }
}
