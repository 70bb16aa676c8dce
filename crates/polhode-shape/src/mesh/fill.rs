//! Hole filling for the parts of a mesh file.

use std::collections::HashMap;
use std::path::Path;

use polhode::body::BodyError;
use polhode::body::mesh::{FilledMesh, HolesLeft};
use polhode_source::FormatError;

use super::{MeshContents, MeshLength, MeshPart, MeshRepair, RepairBound, solid};
use crate::finding::info;

impl MeshContents {
    /// Closes holes up to this size with
    /// [`TriangleMesh::filled`](polhode::body::mesh::TriangleMesh::filled) for each part. Parts
    /// with open edges in common are pieces of one surface: they are filled together and become one
    /// part, with a finding. `unit` is as in [`MeshSolid::read`](super::MeshSolid::read).
    ///
    /// # Errors
    /// [`FormatError`] if the size is not positive.
    pub fn filled(
        mut self,
        size: MeshLength,
        unit: Option<f64>,
        path: &Path,
    ) -> Result<(Self, MeshRepair), FormatError> {
        let unit = unit.or(self.unit).unwrap_or(1.0);
        let refused = |error| solid::no_solid(path, "", error);
        let size = size.beside(solid::joined(&self.parts).map_err(refused)?.diagonal(), unit);
        self = self.with_whole_surfaces().map_err(refused)?;
        let mut fills = Vec::new();
        for part in &mut self.parts {
            let mut filled = part.mesh.filled(size).map_err(refused)?;
            part.mesh = std::mem::take(&mut filled.mesh);
            fills.push(filled);
        }
        Ok((self, repair(&fills, unit)))
    }

    /// Merges parts with open edges in common, which are pieces of one surface, into one part
    /// without a name each, with a finding.
    pub(super) fn with_whole_surfaces(mut self) -> Result<Self, BodyError> {
        let first = first_pieces(&self.parts);
        let mut parts = Vec::new();
        for (k, part) in self.parts.iter().enumerate().filter(|(k, _)| first[*k] == *k) {
            let pieces =
                || self.parts.iter().zip(&first).filter(|(_, first)| **first == k).map(|piece| piece.0);
            match pieces().count() {
                1 => parts.push(part.clone()),
                count => {
                    let message = format!(
                        "{count} open parts of the file form one surface, and were merged into one part"
                    );
                    self.findings.push(info("mesh.joined", message));
                    parts.push(MeshPart { name: String::new(), mesh: solid::joined(pieces())? });
                }
            }
        }
        self.parts = parts;
        Ok(self)
    }
}

/// Returns, for each part, the first part of the same surface. Parts are connected if they have
/// open edges in common.
fn first_pieces(parts: &[MeshPart]) -> Vec<usize> {
    let mut first: Vec<usize> = (0..parts.len()).collect();
    if let [_] = parts {
        return first;
    }
    let mut known = HashMap::new();
    for (k, part) in parts.iter().enumerate() {
        for edge in part.mesh.open_edges() {
            let bits = edge.map(|end| end.map(f64::to_bits));
            let other = first[*known.entry(bits).or_insert(k)];
            let (low, high) = (other.min(first[k]), other.max(first[k]));
            if low != high {
                first.iter_mut().filter(|first| **first == high).for_each(|first| *first = low);
            }
        }
    }
    first
}

fn repair(filled: &[FilledMesh], unit: f64) -> MeshRepair {
    let count = |of: fn(&FilledMesh) -> usize| filled.iter().map(of).sum();
    let most = |of: fn(&FilledMesh) -> f64| unit * filled.iter().map(of).fold(0.0, f64::max);
    let volume = filled.iter().map(|mesh| mesh.volume_bound).sum::<f64>() * unit.powi(3);
    MeshRepair::Filled {
        holes: count(|mesh| mesh.holes),
        triangles: count(|mesh| mesh.triangles),
        largest: most(|mesh| mesh.largest),
        left: filled.iter().map(|mesh| mesh.left).fold(HolesLeft::default(), |all, left| all + left),
        bound: RepairBound { volume, beyond: 2.0 * most(|mesh| mesh.largest_radius) },
    }
}
