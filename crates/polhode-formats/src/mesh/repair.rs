//! What a mesh is mended by where somebody asks for it, and what that may change.

use std::path::Path;

use polhode::body::mesh::{TriangleMesh, WeldedMesh};
use polhode::body::{BodyError, Finding, Severity};

use super::{MeshContents, MeshPart, MeshSolid, solid};
use crate::error::FormatError;
use crate::unit::{self, Dimension, UnitError};

/// A length beside a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshLength {
    /// In m.
    Metres(f64),
    /// In parts of the mesh's size: the diagonal of the box about all of its triangles.
    OfSize(f64),
}

impl MeshLength {
    /// A length with its unit, or a plain number for a part of the mesh's size.
    ///
    /// ```
    /// use polhode_formats::mesh::MeshLength;
    /// assert_eq!(MeshLength::parse("0.01 mm"), Ok(MeshLength::Metres(0.00001)));
    /// assert_eq!(MeshLength::parse("3e-7"), Ok(MeshLength::OfSize(3e-7)));
    /// assert!(MeshLength::parse("2 kg").is_err());
    /// ```
    ///
    /// # Errors
    /// [`UnitError`] for what is neither.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        if let Ok(part) = text.trim().parse() {
            return Ok(Self::OfSize(part));
        }
        unit::parse(text, Dimension::LENGTH).map(Self::Metres)
    }

    /// The number itself.
    pub const fn value(self) -> f64 {
        match self {
            Self::Metres(value) | Self::OfSize(value) => value,
        }
    }

    /// In the mesh's own unit.
    fn beside(self, diagonal: f64, unit: f64) -> f64 {
        match self {
            Self::Metres(length) => length / unit,
            Self::OfSize(part) => part * diagonal,
        }
    }
}

/// What was mended of a mesh file.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshRepair {
    /// Vertices of open edges were joined.
    Welded {
        /// Vertices that were joined.
        vertices: usize,
        /// Points that became of them.
        points: usize,
        /// The largest distance between two vertices that were joined, m.
        largest_distance: f64,
        /// Triangles of which two corners became one.
        vanished: usize,
        /// What it may be off.
        bound: RepairBound,
    },
}

/// What a repair leaves open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RepairBound {
    /// How much more or less the mesh may enclose, m³.
    pub volume: f64,
    /// How much farther out than its corners that may be, m.
    pub beyond: f64,
}

impl MeshRepair {
    /// What was done, and what it means for the solids that came of it: a warning.
    pub fn finding(&self, solid: &MeshSolid, file: &str) -> Finding {
        let RepairBound { volume, beyond } = self.bound();
        let whole: f64 = solid.parts.iter().map(|part| part.mesh.volume()).sum();
        let effect = match solid.parts.as_slice() {
            [only] => {
                let effect = only.mesh.effect(volume, beyond);
                format!(
                    ", the centre of mass by {:.1e} m, the tensor at one density by {:.1e} of its largest moment",
                    effect.center, effect.inertia
                )
            }
            _ => String::new(),
        };
        let message = format!(
            "{}; the volume may be off by {volume:.1e} m³ ({:.1e} of it){effect}, at most",
            self.in_words(),
            volume / whole
        );
        let place = Some(crate::text::escaped(file));
        Finding { code: self.code(), severity: Severity::Warning, message, place }
    }

    /// What it may be off.
    pub const fn bound(&self) -> RepairBound {
        let Self::Welded { bound, .. } = self;
        *bound
    }

    const fn code(&self) -> &'static str {
        "mesh.welded"
    }

    fn in_words(&self) -> String {
        let Self::Welded { vertices, points, largest_distance, vanished, .. } = *self;
        if points == 0 {
            return "nothing was welded: no vertices of open edges are so near each other".to_owned();
        }
        let vanished = match vanished {
            0 => "no triangle vanished".to_owned(),
            1 => "1 triangle vanished".to_owned(),
            many => format!("{many} triangles vanished"),
        };
        let points = if points == 1 { "1 point".to_owned() } else { format!("{points} points") };
        format!(
            "{vertices} vertices were welded to {points}, as was asked, at most {largest_distance:.2e} m apart; {vanished}"
        )
    }
}

impl MeshContents {
    /// The mesh with torn edges joined: [`TriangleMesh::welded`] of each part; of all together, if that
    /// does not close each. `unit` is as in [`MeshSolid::read`].
    ///
    /// # Errors
    /// [`FormatError`] for a tolerance that is not positive or would join what is farther apart.
    pub fn welded(
        mut self,
        tolerance: MeshLength,
        unit: Option<f64>,
        path: &Path,
    ) -> Result<(Self, MeshRepair), FormatError> {
        let unit = unit.or(self.unit).unwrap_or(1.0);
        let refused = |part: &str, error| solid::no_solid(path, part, error);
        let all = solid::joined(&self.parts).map_err(|error| refused("", error))?;
        let tolerance = tolerance.beside(all.diagonal(), unit);
        let each: Result<Vec<_>, _> = self.parts.iter().map(|part| part.mesh.welded(tolerance)).collect();
        let welded = match each {
            Ok(each) if each.iter().all(|mesh| mesh.open_edges == 0) => each,
            Err(error) if self.parts.len() == 1 => return Err(refused(&self.parts[0].name, error)),
            Ok(each) if self.parts.len() == 1 => each,
            _ => {
                let together = all.welded(tolerance).map_err(|error| refused("", error))?;
                let parts = divided(&together, &self.parts).map_err(|error| refused("", error))?;
                for (part, mesh) in self.parts.iter_mut().zip(parts) {
                    part.mesh = mesh;
                }
                return Ok((self, repair(&[together], unit)));
            }
        };
        let repair = repair(&welded, unit);
        for (part, welded) in self.parts.iter_mut().zip(welded) {
            part.mesh = welded.mesh;
        }
        Ok((self, repair))
    }
}

/// The triangles of each part, of all together.
fn divided(together: &WeldedMesh, parts: &[MeshPart]) -> Result<Vec<TriangleMesh>, BodyError> {
    let mut corners = together.mesh.corners();
    let own = |part: &MeshPart| {
        let triangles = corners.by_ref().take(part.mesh.triangles().len()).collect();
        TriangleMesh::of_soup(triangles)
    };
    parts.iter().map(own).collect()
}

fn repair(welded: &[WeldedMesh], unit: f64) -> MeshRepair {
    let count = |of: fn(&WeldedMesh) -> usize| welded.iter().map(of).sum();
    let most = |of: fn(&WeldedMesh) -> f64| unit * welded.iter().map(of).fold(0.0, f64::max);
    let volume = welded.iter().map(|mesh| mesh.volume_bound).sum::<f64>() * unit.powi(3);
    MeshRepair::Welded {
        vertices: count(|mesh| mesh.joined),
        points: count(|mesh| mesh.points),
        largest_distance: most(|mesh| mesh.largest_distance),
        vanished: count(|mesh| mesh.vanished),
        bound: RepairBound { volume, beyond: most(|mesh| mesh.farthest_move) },
    }
}
