//! Names of the parts of a mesh, by their triangles.

use polhode_shape::mesh::MeshContents;

/// Names and numbers of triangles of the parts of a file. Triangles are numbered through all parts.
#[derive(Debug)]
pub(crate) struct PartNames(Vec<(String, usize)>);

impl PartNames {
    pub(crate) fn of(contents: &MeshContents) -> Self {
        let named = contents.parts.iter().map(|part| (part.name.clone(), part.mesh.triangles().len()));
        Self(named.collect())
    }

    /// Returns the number of parts if there are several.
    pub(crate) fn several(&self) -> Option<usize> {
        Some(self.0.len()).filter(|count| *count > 1)
    }

    /// Returns the name of the part that has a triangle, from 1, if there are several parts.
    pub(crate) fn of_triangle(&self, triangle: usize) -> Option<&str> {
        self.several()?;
        let mut last = 0;
        let part = self.0.iter().find(|(_, count)| {
            last += count;
            triangle <= last
        });
        part.map(|(name, _)| name.as_str()).filter(|name| !name.is_empty())
    }
}
