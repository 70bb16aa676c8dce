//! Repairs of a mesh on request, and bounds on their effect.

use std::path::Path;

use polhode::body::mesh::{HolesLeft, MeshEffect, TriangleMesh, WeldedMesh};
use polhode::body::{BodyError, Finding, Severity};
use polhode_source::text::counted;
use polhode_source::{FormatError, FormatErrorKind};
use serde_json::{Value, json};

use super::length::MeshLength;
use super::{MeshContents, MeshPart, MeshSolid, holes_left, solid};

/// Repair of a mesh file.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshRepair {
    /// Vertices of open edges were joined.
    Welded {
        /// Number of vertices that were joined.
        vertices: usize,
        /// Number of points after joining.
        points: usize,
        /// Maximum distance between two joined vertices, m.
        largest_distance: f64,
        /// Number of triangles that vanished because two corners became one.
        vanished: usize,
        /// Number of T-junctions: vertices inside open edges, at which these were split.
        junctions: usize,
        /// Maximum distance of such a vertex from its edge, m.
        largest_offset: f64,
        /// Bound on the error.
        bound: RepairBound,
    },
    /// Small holes were closed with triangles.
    Filled {
        /// Number of holes that were closed.
        holes: usize,
        /// Number of triangles that close them.
        triangles: usize,
        /// Maximum distance between two vertices of such a hole, m.
        largest: f64,
        /// Holes that were not closed.
        left: HolesLeft,
        /// Bound on the error, provided that the missing volume lies in the balls around the holes.
        bound: RepairBound,
    },
}

impl MeshRepair {
    /// Returns warnings about the repairs and their combined effect on the solids, or notes about
    /// repairs that had no effect.
    pub fn findings(repairs: &[Self], solid: &MeshSolid, file: &str) -> Vec<Finding> {
        let whole = solid.parts.iter().map(|part| part.mesh.volume()).sum();
        let effect = |bound: RepairBound| match solid.parts.as_slice() {
            [only] => Some(only.mesh.effect(bound.volume, bound.beyond)),
            _ => None,
        };
        Self::findings_on(repairs, whole, effect, file)
    }

    /// Returns the same findings for an enclosed volume `whole`, m³, and the effect of a bound on
    /// it.
    pub fn findings_on(
        repairs: &[Self],
        whole: f64,
        effect: impl Fn(RepairBound) -> Option<MeshEffect>,
        file: &str,
    ) -> Vec<Finding> {
        let last = repairs.iter().rposition(Self::is_something);
        let place = Some(polhode_source::text::escaped(file));
        let finding = |(k, repair): (usize, &Self)| {
            let mut message = repair.in_words();
            if Some(k) == last {
                let together = if repairs[..k].iter().any(Self::is_something) { " all together" } else { "" };
                let bound = RepairBound::of(repairs);
                let at_most = at_most(bound.volume, whole, effect(bound), together);
                message += &format!("; {}{at_most}", repair.proviso());
            }
            let severity = if repair.is_something() { Severity::Warning } else { Severity::Info };
            Finding { code: repair.code(), severity, message, place: place.clone() }
        };
        repairs.iter().enumerate().map(finding).collect()
    }

    /// Adds the reasons why holes were not filled to the error of a mesh that is still open.
    #[must_use]
    pub fn explained(repairs: &[Self], error: FormatError) -> FormatError {
        let is_open = matches!(error.kind(), FormatErrorKind::Mesh { error: BodyError::OpenMesh { .. }, .. });
        let left = repairs.iter().find_map(|repair| match repair {
            Self::Filled { left, .. } => holes_left::why(*left),
            Self::Welded { .. } => None,
        });
        match left.filter(|_| is_open) {
            None => error,
            Some(left) => {
                let hint = error.hint().map_or(String::new(), |hint| format!("; {hint}"));
                error.with_hint(format!("not all holes were filled: {left}{hint}"))
            }
        }
    }

    /// Returns true if the repair changed the mesh.
    const fn is_something(&self) -> bool {
        matches!(
            self,
            Self::Welded { points: 1.., .. }
                | Self::Welded { junctions: 1.., .. }
                | Self::Filled { holes: 1.., .. }
        )
    }

    /// Returns the condition under which the bound holds.
    const fn proviso(&self) -> &'static str {
        match self {
            Self::Welded { .. } => "",
            Self::Filled { .. } => "if the missing surface lies within the bounding balls of the holes, ",
        }
    }

    /// Returns name and numbers as JSON.
    pub fn for_programs(&self) -> (&'static str, Value) {
        match *self {
            Self::Welded {
                vertices,
                points,
                largest_distance,
                vanished,
                junctions,
                largest_offset,
                bound,
            } => (
                "weld",
                json!({
                    "vertices": vertices,
                    "points": points,
                    "largest_distance_m": largest_distance,
                    "triangles_vanished": vanished,
                    "t_junctions": junctions,
                    "largest_offset_m": largest_offset,
                    "volume_bound_m3": bound.volume,
                }),
            ),
            Self::Filled { holes, triangles, largest, bound, .. } => (
                "fill",
                json!({
                    "holes": holes,
                    "triangles": triangles,
                    "largest_m": largest,
                    "volume_bound_m3": bound.volume,
                }),
            ),
        }
    }

    /// Returns the error bound of this repair alone.
    pub const fn bound(&self) -> RepairBound {
        let (Self::Welded { bound, .. } | Self::Filled { bound, .. }) = self;
        *bound
    }

    const fn code(&self) -> &'static str {
        match self {
            Self::Welded { .. } => "mesh.welded",
            Self::Filled { .. } => "mesh.filled",
        }
    }

    fn in_words(&self) -> String {
        match *self {
            Self::Welded { points: 0, junctions: 0, .. } => {
                "nothing was welded: no vertices of open edges are within this distance".to_owned()
            }
            Self::Welded {
                vertices, points, largest_distance, vanished, junctions, largest_offset, ..
            } => {
                let joined = (points > 0).then(|| {
                    format!(
                        "{} welded to {}, at most {largest_distance:.2e} m apart; {} vanished",
                        if vertices == 1 {
                            "1 vertex was".to_owned()
                        } else {
                            format!("{vertices} vertices were")
                        },
                        counted(points, "point"),
                        if vanished == 0 { "no triangle".to_owned() } else { counted(vanished, "triangle") }
                    )
                });
                let split = (junctions > 0).then(|| {
                    let was = if junctions == 1 { "was" } else { "were" };
                    format!(
                        "{} {was} welded, at most {largest_offset:.2e} m from their edges",
                        counted(junctions, "T-junction")
                    )
                });
                format!("weld: {}", joined.into_iter().chain(split).collect::<Vec<_>>().join("; "))
            }
            Self::Filled { holes: 0, left, .. } => {
                let why = holes_left::why(left).unwrap_or_else(|| "the mesh has no open edges".to_owned());
                format!("nothing was filled: {why}")
            }
            Self::Filled { holes, triangles, largest, .. } => format!(
                "fill: {} of up to {largest:.2e} m across {} filled with {}",
                counted(holes, "hole"),
                if holes == 1 { "was" } else { "were" },
                counted(triangles, "triangle")
            ),
        }
    }
}

/// Bounds on the error that a repair leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RepairBound {
    /// Bound on the error of the enclosed volume, m³.
    pub volume: f64,
    /// Bound on the distance of that volume from the corners of the mesh, m.
    pub beyond: f64,
}

impl RepairBound {
    /// Combines the bounds of successive repairs.
    ///
    /// Welding by up to d moves the rim of a hole by at most d. The missing volume then lies in a
    /// ball of radius r + d. By Minkowski's inequality, Σ (r + d)³ ≤ (³√Σr³ + d ³√N)³ for N holes.
    /// A ball has a corner of the mesh on its surface, so it extends at most 2 r beyond the mesh.
    pub fn of(repairs: &[MeshRepair]) -> Self {
        let (mut all, mut moved) = (Self { volume: 0.0, beyond: 0.0 }, 0.0_f64);
        for repair in repairs {
            let (volume, beyond) = match *repair {
                MeshRepair::Welded { bound, .. } => {
                    moved = moved.max(bound.beyond);
                    (bound.volume, bound.beyond)
                }
                MeshRepair::Filled { bound, .. } if moved == 0.0 => (bound.volume, bound.beyond),
                MeshRepair::Filled { holes, bound, .. } => {
                    let unit = 4.0 / 3.0 * std::f64::consts::PI;
                    let radii = libm::cbrt(bound.volume / unit) + moved * libm::cbrt(holes as f64);
                    (unit * radii.powi(3), bound.beyond + moved)
                }
            };
            all = Self { volume: all.volume + volume, beyond: all.beyond.max(beyond) };
        }
        all
    }
}

/// Returns the bound in words: "the volume may be off by …, at most", with "all together" if there
/// are several repairs.
fn at_most(volume: f64, whole: f64, effect: Option<MeshEffect>, together: &str) -> String {
    let off = format!("the volume may be off by {volume:.1e} m³ ({:.1e} relative)", volume / whole);
    match effect {
        None => format!("{off}, at most{together}"),
        Some(effect) if effect.center.is_finite() => format!(
            "{off}, the centre of mass by {:.1e} m, the tensor at fixed density by {:.1e} of its largest moment, at most{together}",
            effect.center, effect.inertia
        ),
        Some(_) => format!("{off}, at most{together}: the centre of mass and the tensor are undetermined"),
    }
}

impl MeshContents {
    /// Joins torn edges with [`TriangleMesh::welded`] for each part, or for all parts together if
    /// that does not close each. `unit` is as in [`MeshSolid::read`].
    ///
    /// # Errors
    /// [`FormatError`] for a tolerance that is not positive, or one that would join vertices beyond
    /// it.
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

    /// Welds and then fills the mesh as requested; also returns the repairs.
    ///
    /// # Errors
    /// [`FormatError`], as for [`MeshContents::welded`] and [`MeshContents::filled`].
    pub fn mended(
        mut self,
        weld: Option<MeshLength>,
        fill: Option<MeshLength>,
        unit: Option<f64>,
        path: &Path,
    ) -> Result<(Self, Vec<MeshRepair>), FormatError> {
        let mut repairs = Vec::new();
        if let Some(tolerance) = weld {
            let (welded, repair) = self.welded(tolerance, unit, path)?;
            self = welded;
            repairs.push(repair);
        }
        if let Some(size) = fill {
            let (filled, repair) = self.filled(size, unit, path)?;
            self = filled;
            repairs.push(repair);
        }
        Ok((self, repairs))
    }
}

/// Divides the welded mesh into the triangles of each part.
fn divided(together: &WeldedMesh, parts: &[MeshPart]) -> Result<Vec<TriangleMesh>, BodyError> {
    let corners: Vec<_> = together.mesh.corners().collect();
    let (given, added) = corners.split_at(corners.len() - together.origins.len());
    let mut first = 0;
    let own = |part: &MeshPart| {
        let range = first..first + part.mesh.triangles().len();
        first = range.end;
        let at_junctions = added.iter().zip(&together.origins);
        let at_junctions = at_junctions.filter(|(_, origin)| range.contains(&(**origin as usize)));
        let mut triangles = given[range.clone()].to_vec();
        triangles.extend(at_junctions.map(|(triangle, _)| triangle));
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
        junctions: count(|mesh| mesh.junctions),
        largest_offset: most(|mesh| mesh.largest_offset),
        bound: RepairBound { volume, beyond: most(|mesh| mesh.farthest_move) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A weld enlarges the balls around holes. Equal balls reach the bound, others stay below it.
    #[test]
    fn a_weld_widens_the_balls_of_the_holes_that_are_filled_after_it() {
        let (welded, moved) = (2e-5, 0.03);
        let weld = MeshRepair::Welded {
            vertices: 3,
            points: 1,
            largest_distance: 0.05,
            vanished: 0,
            junctions: 0,
            largest_offset: 0.0,
            bound: RepairBound { volume: welded, beyond: moved },
        };
        let ball = |r: f64| 4.0 / 3.0 * std::f64::consts::PI * r * r * r;
        for radii in [vec![0.7], vec![0.2, 0.2, 0.2], vec![0.9, 0.1], vec![1.3, 0.4, 0.2, 0.05]] {
            let largest = radii.iter().copied().fold(0.0, f64::max);
            let fill = MeshRepair::Filled {
                holes: radii.len(),
                triangles: 7,
                largest,
                left: polhode::body::mesh::HolesLeft::default(),
                bound: RepairBound { volume: radii.iter().copied().map(ball).sum(), beyond: 2.0 * largest },
            };
            assert_eq!(RepairBound::of(&[fill]), fill.bound());
            let both = RepairBound::of(&[weld, fill]);
            let exact: f64 = welded + radii.iter().map(|r| ball(r + moved)).sum::<f64>();
            let excess = both.volume / exact - 1.0;
            let are_equal = radii.iter().all(|r| *r == largest);
            assert!(excess > -1e-14 && excess < if are_equal { 1e-14 } else { 0.2 }, "{radii:?}: {excess}");
            assert_eq!(both.beyond, 2.0 * largest + moved);
        }
    }
}
