//! Writers for meshes: binary STL, OBJ, PLY.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::Path;

use polhode::body::mesh::TriangleMesh;
use polhode_source::FormatError;
use polhode_source::files::Memory;

use super::{MeshContents, MeshFormat, MeshPart, MeshSolid};

impl MeshFormat {
    /// Formats that can be written.
    pub const WRITTEN: &[Self] = &[Self::Stl, Self::Obj, Self::Ply];

    /// Returns the bytes of a file with these parts; `None` for a format that cannot be written.
    ///
    /// OBJ and PLY contain every digit of a coordinate, and each vertex once. In OBJ, parts with
    /// equal or empty names get a number, and `#` and `\` become spaces. STL is binary: coordinates
    /// are rounded to f32. STL and PLY lose the names of parts.
    ///
    /// ```
    /// use polhode::body::mesh::TriangleMesh;
    /// use polhode_shape::mesh::{MeshContents, MeshFormat, MeshPart};
    /// use polhode_source::files::Memory;
    /// let mesh = TriangleMesh::of_triangles(&[[[0.1, 0.0, 0.0], [2.0, 0.0, 0.7], [0.0, 3.0, 0.0]]])?;
    /// let parts = [MeshPart { name: "flake".to_owned(), mesh }];
    /// let bytes = MeshFormat::Obj.bytes(&parts).ok_or("OBJ is written")?;
    /// assert_eq!(MeshContents::parse(&Memory::default(), &bytes, "flake.obj".as_ref(), MeshFormat::Obj)?.parts, parts);
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

    /// Returns the bytes, verified by reading them again, and the solids that they bound, in the
    /// mesh's unit. `path` is for messages; nothing is written there.
    ///
    /// # Errors
    /// [`FormatError`] for a format that cannot be written, and if the file would no longer bound
    /// solids. Coordinates rounded to seven digits may open a mesh or make it intersect itself, and
    /// parts without names become one.
    pub fn checked_bytes(self, parts: &[MeshPart], path: &Path) -> Result<(Vec<u8>, MeshSolid), FormatError> {
        let refused = |error: FormatError| {
            error.with_hint(format!("this is the mesh as it would be written; {}", self.alternative()))
        };
        let bytes = self.bytes(parts).unwrap_or_default();
        let contents = MeshContents::parse(&Memory::default(), &bytes, path, self).map_err(refused)?;
        let solid = MeshSolid::of(contents, path, self, None).map_err(refused)?;
        Ok((bytes, solid))
    }

    const fn alternative(self) -> &'static str {
        match self {
            Self::Stl => "OBJ keeps all digits and separate parts",
            Self::Ply => "OBJ keeps separate parts",
            _ => "write it in another format",
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
    for mesh in parts.iter().map(|part| &part.mesh) {
        for (normal, [a, b, c]) in mesh.area_vectors().map(unit).zip(mesh.corners()) {
            for number in [normal, a, b, c].as_flattened() {
                bytes.extend_from_slice(&(*number as f32).to_le_bytes());
            }
            bytes.extend_from_slice(&[0; 2]);
        }
    }
    bytes
}

/// Returns the normalized vector; zero for a vector without length.
fn unit(n: [f64; 3]) -> [f64; 3] {
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    if length > 0.0 && length.is_finite() { n.map(|c| c / length) } else { [0.0; 3] }
}

fn obj(parts: &[MeshPart]) -> String {
    let mut text = "# written by polhode\n".to_owned();
    let mut first = 1;
    for (MeshPart { mesh, .. }, name) in parts.iter().zip(group_names(parts)) {
        for [x, y, z] in mesh.coordinates() {
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        if !name.is_empty() {
            let _ = writeln!(text, "g {name}");
        }
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|v| v as usize + first);
            let _ = writeln!(text, "f {a} {b} {c}");
        }
        first += mesh.coordinates().len();
    }
    text
}

/// Returns one-line names for the parts, all different, because groups with one name form one part.
fn group_names(parts: &[MeshPart]) -> Vec<String> {
    let plain = |part: &MeshPart| -> String {
        // `#` begins a comment, and `\` may continue the line.
        let is_plain = |c: char| !c.is_control() && c != '#' && c != '\\';
        let name: String = part.name.chars().map(|c| if is_plain(c) { c } else { ' ' }).collect();
        name.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    if let [only] = parts {
        return vec![plain(only)];
    }
    let given: Vec<String> = parts.iter().map(plain).collect();
    let mut taken = HashSet::new();
    let mut names = Vec::new();
    for (k, own) in given.iter().enumerate() {
        let is_free = |name: &str| !name.is_empty() && !taken.contains(name);
        let numbered = |stem: &str, from: usize| {
            let mut tries = (from..).map(|number| format!("{stem}_{number}"));
            tries.find(|name| is_free(name) && !given.contains(name)).unwrap_or_default()
        };
        let name = match own.as_str() {
            "" => numbered("part", k + 1),
            own if is_free(own) => own.to_owned(),
            own => numbered(own, 2),
        };
        taken.insert(name.clone());
        names.push(name);
    }
    names
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_that_are_called_the_same_stay_parts() {
        let part = |name: &str, x: f64| {
            let corners = [[x, 0.2, 0.3], [x + 0.7, 0.1, -0.2], [x, 1.9, 0.4]];
            MeshPart { name: name.to_owned(), mesh: TriangleMesh::of_triangles(&[corners]).unwrap() }
        };
        let parts: Vec<_> =
            ["", "a", "a", "a_2", "", " a\n"].iter().zip(0..).map(|(name, k)| part(name, k.into())).collect();
        assert_eq!(group_names(&parts), ["part_1", "a", "a_3", "a_2", "part_5", "a_4"]);
        let bytes = MeshFormat::Obj.bytes(&parts).unwrap();
        let again =
            MeshContents::parse(&Memory::default(), &bytes, "a.obj".as_ref(), MeshFormat::Obj).unwrap();
        assert!(again.parts.iter().map(|part| &part.mesh).eq(parts.iter().map(|part| &part.mesh)));
        assert_eq!(group_names(&parts[..1]), [""]);
    }

    #[test]
    fn names_that_obj_would_cut_are_read_again_as_they_are_written() {
        let given = ["wheel #1", "wheel #2", "wheel \\2", "#", "#3", "a\\"];
        let parts: Vec<_> = (0..given.len())
            .map(|k| {
                let x = 0.3 + 5.0 * k as f64;
                let [o, a, b, c] = [[x, 0.2, 0.3], [x + 0.7, 0.1, -0.2], [x, 1.9, 0.4], [x, 0.1, 2.2]];
                let mesh = TriangleMesh::of_triangles(&[[o, b, a], [o, a, c], [o, c, b], [a, b, c]]);
                MeshPart { name: given[k].to_owned(), mesh: mesh.unwrap() }
            })
            .collect();
        let (_, solid) = MeshFormat::Obj.checked_bytes(&parts, "a.obj".as_ref()).unwrap();
        let names: Vec<_> = solid.parts.iter().map(|part| part.name.as_str()).collect();
        assert_eq!(names, ["wheel 1", "wheel 2", "wheel 2_2", "part_4", "3", "a"]);
        let alone = MeshFormat::Obj.bytes(&parts[5..]).unwrap();
        let alone =
            MeshContents::parse(&Memory::default(), &alone, "a.obj".as_ref(), MeshFormat::Obj).unwrap();
        assert_eq!(alone.parts[0].name, "a");
    }
}
