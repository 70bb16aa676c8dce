//! Closing of all holes of a mesh file, with a bound of what the true surface can change.

use std::path::Path;

use polhode::body::Finding;
use polhode::body::mesh::{MeshDiagnosis, MeshHole};
use polhode_source::FormatError;
use polhode_source::text::{counted, escaped};
use serde_json::{Value, json};

use super::{MeshContents, MeshPart, SolidPart, percent_above, solid};
use crate::finding::{info, warning};

/// Caps that close all holes of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshClosure {
    /// Holes of each part, in the unit of the part's mesh.
    holes: Vec<Vec<MeshHole>>,
    /// Number of each part's own triangles; those of the caps follow.
    own: Vec<usize>,
    /// Number of triangles of the caps.
    triangles: usize,
}

/// Reason why caps give no bound.
#[derive(Clone, Debug, PartialEq)]
pub enum UnboundedClosure {
    /// A cap intersects the mesh, at this point, m.
    Crossed {
        /// Point near both triangles, m.
        point: [f64; 3],
    },
    /// The bound is too large a share of the volume.
    TooWide {
        /// Bound of the error of the volume, relative to it; infinite if it has no volume.
        share: f64,
        /// Largest accepted share.
        most: f64,
        /// True if a weld or fill adds to the bound.
        repaired: bool,
        /// Number of holes.
        holes: usize,
        /// Size of the largest hole, m.
        size: f64,
        /// Centre of the largest hole, m.
        center: [f64; 3],
    },
}

impl MeshContents {
    /// Closes all holes of each part with
    /// [`TriangleMesh::capped`](polhode::body::mesh::TriangleMesh::capped). Parts with open edges
    /// in common are merged, as by [`MeshContents::filled`].
    ///
    /// # Errors
    /// [`FormatError`] if the parts have too many vertices together.
    pub fn capped(
        self,
        path: &Path,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<(Self, MeshClosure), FormatError> {
        let mut contents = self.with_whole_surfaces().map_err(|error| solid::no_solid(path, "", error))?;
        let mut closure = MeshClosure { holes: Vec::new(), own: Vec::new(), triangles: 0 };
        for part in &mut contents.parts {
            let capped = part.mesh.capped(goes_on);
            closure.own.push(part.mesh.triangles().len());
            closure.triangles += capped.triangles;
            closure.holes.push(capped.holes);
            part.mesh = capped.mesh;
        }
        Ok((contents, closure))
    }
}

impl MeshClosure {
    /// Returns the closure in another unit of length: lengths are multiplied by a factor.
    #[must_use]
    pub(crate) fn scaled(self, factor: f64) -> Self {
        let of_part = |holes: Vec<MeshHole>| holes.into_iter().map(|hole| hole.scaled(factor)).collect();
        Self { holes: self.holes.into_iter().map(of_part).collect(), ..self }
    }

    /// Returns the holes that belong to each of `solids` solids. If all parts together bound one
    /// solid, all holes belong to it.
    pub(crate) fn holes_of(&self, solids: usize) -> Vec<Vec<MeshHole>> {
        if solids == self.holes.len() { self.holes.clone() } else { vec![self.all().cloned().collect()] }
    }

    /// Returns true without holes.
    pub(crate) fn is_empty(&self) -> bool {
        self.all().next().is_none()
    }

    fn all(&self) -> impl Iterator<Item = &MeshHole> {
        self.holes.iter().flatten()
    }

    fn largest(&self) -> Option<&MeshHole> {
        self.all().max_by(|a, b| a.size.total_cmp(&b.size))
    }

    /// Returns a point where a cap intersects the mesh, m: the caps then give no bound. `unit` is
    /// the unit of the parts, m.
    pub(crate) fn crossing(&self, parts: &[MeshPart], solids: &[SolidPart], unit: f64) -> Option<[f64; 3]> {
        if solids.iter().all(|solid| solid.mesh.diagnosis().self_overlaps.is_empty()) {
            return None;
        }
        if solids.len() != self.own.len() {
            // The triangles of the solid are those of several parts.
            let overlaps = solids.iter().filter_map(|solid| solid.mesh.diagnosis().self_overlaps.first);
            return overlaps.map(|pair| pair.point.map(|c| c * unit)).next();
        }
        /// Number of pairs that a diagnosis counts.
        const MOST: usize = 10_001;
        parts.iter().zip(&self.own).find_map(|(part, &own)| {
            let pairs = MeshDiagnosis::with_places(&part.mesh, MOST).1.self_overlaps;
            // More pairs than are counted may include a cap.
            let is_full = pairs.len() >= MOST;
            let crossing = pairs.iter().find(|pair| is_full || pair.triangles.iter().any(|&t| t > own))?;
            Some(crossing.point.map(|c| c * unit))
        })
    }

    /// Returns the bound of the error of the volume, relative to a volume; both in the unit of the
    /// holes. Repairs before add their bound `repaired`.
    pub(crate) fn share(&self, volume: f64, repaired: f64) -> f64 {
        let bound = |hole: &MeshHole| hole.bound(hole.center).map_or(f64::INFINITY, |bound| bound.measure);
        let share = (self.all().map(bound).sum::<f64>() + repaired) / volume;
        if share.is_nan() { f64::INFINITY } else { share }
    }

    /// Returns the error for a share above `most`.
    pub(crate) fn too_wide(&self, share: f64, most: f64, repaired: bool) -> UnboundedClosure {
        let (size, center) = self.largest().map_or((0.0, [0.0; 3]), |hole| (hole.size, hole.center));
        UnboundedClosure::TooWide { share, most, repaired, holes: self.all().count(), size, center }
    }

    /// Returns name and numbers as JSON, for holes in metres.
    pub(crate) fn for_programs(&self, volume_bound: f64) -> (&'static str, Value) {
        let largest = self.largest();
        (
            "close_within",
            json!({
                "holes": self.all().count(),
                "triangles": self.triangles,
                "largest_m": largest.map_or(0.0, |hole| hole.size),
                "largest_at_m": largest.map(|hole| hole.center),
                "volume_bound_m3": volume_bound,
            }),
        )
    }

    /// Returns the finding that the holes were closed within bounds, for holes in metres.
    pub(crate) fn finding(&self, share: f64, file: &str) -> Finding {
        let code = "mesh.closed_within_bounds";
        let finding = match self.largest() {
            None => info(code, "nothing was closed: the mesh has no open edges"),
            Some(MeshHole { size, center: [x, y, z], .. }) => warning(
                code,
                format!(
                    "closed within bounds: {}, the largest {size:.2e} m across at ({x:.3e}, {y:.3e}, {z:.3e}) m; if the missing surface lies within the convex hulls of the holes, the volume may be off by {} of it, at most",
                    counted(self.all().count(), "hole"),
                    percent_above(share)
                ),
            ),
        };
        Finding { place: Some(escaped(file)), ..finding }
    }
}
