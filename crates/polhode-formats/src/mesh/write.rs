//! Meshes as files: binary STL, OBJ, PLY.

use std::fmt::Write as _;

use polhode::body::mesh::TriangleMesh;

use super::{MeshFormat, MeshPart};

impl MeshFormat {
    /// The formats that are written.
    pub const WRITTEN: &[Self] = &[Self::Stl, Self::Obj, Self::Ply];

    /// The bytes of a file with these parts; `None` for a format that is not written.
    ///
    /// OBJ and PLY have every digit of a coordinate, and each vertex once. STL is binary: coordinates are rounded to f32, and parts lose
    /// their names there and in PLY.
    ///
    /// ```
    /// use polhode::body::mesh::TriangleMesh;
    /// use polhode_formats::mesh::{MeshContents, MeshFormat, MeshPart};
    /// let mesh = TriangleMesh::of_triangles(&[[[0.1, 0.0, 0.0], [2.0, 0.0, 0.7], [0.0, 3.0, 0.0]]])?;
    /// let parts = [MeshPart { name: "flake".to_owned(), mesh }];
    /// let bytes = MeshFormat::Obj.bytes(&parts).ok_or("OBJ is written")?;
    /// assert_eq!(MeshContents::parse(&bytes, "flake.obj".as_ref(), MeshFormat::Obj)?.parts, parts);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bytes(self, parts: &[MeshPart]) -> Option<Vec<u8>> {
        match self {
            Self::Stl => Some(stl(parts)),
            Self::Obj => Some(obj(parts).into_bytes()),
            Self::Ply => Some(ply(parts)),
            _ => None,
        }
    }
}

const STL_HEADER: usize = 80;

fn stl(parts: &[MeshPart]) -> Vec<u8> {
    let count: usize = parts.iter().map(|part| part.mesh.triangles().len()).sum();
    let mut bytes = Vec::with_capacity(STL_HEADER + 4 + 50 * count);
    bytes.extend_from_slice(b"binary STL, written by polhode");
    bytes.resize(STL_HEADER, b' ');
    bytes.extend_from_slice(&(count as u32).to_le_bytes());
    for [a, b, c] in parts.iter().flat_map(|part| part.mesh.corners()) {
        for number in [normal([a, b, c]), a, b, c].as_flattened() {
            bytes.extend_from_slice(&(*number as f32).to_le_bytes());
        }
        bytes.extend_from_slice(&[0; 2]);
    }
    bytes
}

/// The unit normal; zero for what has no area.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let from = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v) = (from(b), from(c));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    if length > 0.0 && length.is_finite() { n.map(|c| c / length) } else { [0.0; 3] }
}

fn obj(parts: &[MeshPart]) -> String {
    let mut text = "# written by polhode\n".to_owned();
    let mut first = 1;
    for MeshPart { name, mesh } in parts {
        for [x, y, z] in mesh.coordinates() {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        if !name.trim().is_empty() {
            let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
            let _ = writeln!(text, "g {}", name.trim());
        }
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|v| v as usize + first);
            let _ = writeln!(text, "f {a} {b} {c}");
        }
        first += mesh.coordinates().len();
    }
    text
}

fn ply(parts: &[MeshPart]) -> Vec<u8> {
    let count = |of: fn(&TriangleMesh) -> usize| parts.iter().map(|part| of(&part.mesh)).sum::<usize>();
    let (vertices, triangles) =
        (count(|mesh| mesh.coordinates().len()), count(|mesh| mesh.triangles().len()));
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment written by polhode\nelement vertex {vertices}\n\
         property double x\nproperty double y\nproperty double z\n\
         element face {triangles}\nproperty list uchar uint vertex_indices\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    bytes.reserve(24 * vertices + 13 * triangles);
    for number in parts.iter().flat_map(|part| part.mesh.coordinates().as_flattened()) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    let mut first = 0;
    for mesh in parts.iter().map(|part| &part.mesh) {
        for corners in mesh.triangles() {
            bytes.push(3);
            corners.iter().for_each(|v| bytes.extend_from_slice(&(v + first).to_le_bytes()));
        }
        first += mesh.coordinates().len() as u32;
    }
    bytes
}
