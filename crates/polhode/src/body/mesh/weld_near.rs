//! Welding of vertices that are nearly the same point.

use super::TriangleMesh;
use super::close_pairs::{ClosePairs, distance};
use super::clusters::{across, clusters, mean};
use super::edges::Edges;
use super::junctions::{Junctions, boundary_vertices};
use super::threads::Threads;
use super::weld::{NONE, Welded, is_proper};
use crate::body::error::{BodyError, positive};
use crate::body::triangle_mesh::normal;

/// Mesh whose torn edges were welded: [`TriangleMesh::welded`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct WeldedMesh {
    /// Mesh with each vertex once. It has all triangles in their order; degenerated ones have two
    /// equal corners. Triangles that were added at T-junctions follow.
    pub mesh: TriangleMesh,
    /// Number of boundary vertices that were joined with others.
    pub joined: usize,
    /// Number of points into which they were joined.
    pub points: usize,
    /// Largest distance between two joined vertices, m.
    pub largest_distance: f64,
    /// Largest displacement of a vertex, or of a point of a split edge, m.
    pub farthest_move: f64,
    /// Number of triangles that degenerated because two corners were joined.
    pub vanished: usize,
    /// Number of T-junctions: vertices inside boundary edges, which were split there.
    pub junctions: usize,
    /// Largest distance of such a vertex from its edge, m.
    pub largest_offset: f64,
    /// Index of the original triangle of each triangle that was added at a T-junction.
    pub origins: Vec<u32>,
    /// Number of boundary edges (edges of one triangle only) after welding.
    pub open_edges: usize,
    /// Bound of the error of the enclosed volume, m³, if the true position of each joined vertex,
    /// and of each point of a split edge, is within `farthest_move`.
    pub volume_bound: f64,
}

/// Largest accepted tolerance, relative to the mesh's diagonal.
const LARGEST: f64 = 0.01;

impl TriangleMesh {
    /// Returns the diagonal of the bounding box of all triangles, m; 0 if there are none.
    pub fn diagonal(&self) -> f64 {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in self.corners().flatten() {
            low = core::array::from_fn(|k| low[k].min(p[k]));
            high = core::array::from_fn(|k| high[k].max(p[k]));
        }
        if self.triangles.is_empty() { 0.0 } else { distance(low, high) }
    }

    /// Joins boundary vertices (at edges of one triangle) that are at most `tolerance` apart, m.
    /// This closes a torn mesh and leaves closed parts unchanged.
    ///
    /// Vertices form a cluster if steps of at most the tolerance connect them. Each cluster becomes
    /// one point, its mean, which does not depend on the order of the triangles. All vertices of a
    /// cluster must be within the tolerance of each other. Otherwise the result is an error,
    /// because details smaller than the tolerance would be lost.
    ///
    /// Then T-junctions are welded: where a boundary vertex is within the tolerance of the interior
    /// of a boundary edge of another triangle, that triangle is split there.
    ///
    /// The volume is then known to within `volume_bound`. Moving the vertices of N triangles with
    /// areas A and perimeters P by up to d changes the volume by at most
    /// d (ΣA + d ΣP/3 + 2 N d²/3).
    ///
    /// ```
    /// use polhode::body::mesh::{ClosedMesh, TriangleMesh};
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let nearly_z = [0.0, 1e-6, 1.0];
    /// let torn = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, nearly_z, y], [x, y, z]])?;
    /// assert!(ClosedMesh::of(&torn).is_err());
    /// let welded = torn.welded(1e-5)?;
    /// assert_eq!((welded.joined, welded.points, welded.open_edges), (2, 1, 0));
    /// let solid = ClosedMesh::of(&welded.mesh)?;
    /// assert!((solid.volume() - 1.0).abs() <= welded.volume_bound && welded.volume_bound < 1e-5);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a tolerance that is not positive, or within which there are too
    /// many vertices; for an open mesh also above a hundredth of its [`diagonal`](Self::diagonal).
    /// [`BodyError::WeldTooWide`] for a cluster with vertices farther apart than the tolerance.
    pub fn welded(&self, tolerance: f64) -> Result<WeldedMesh, BodyError> {
        self.welded_on(tolerance, Threads::of_machine())
    }

    fn welded_on(&self, tolerance: f64, threads: Threads) -> Result<WeldedMesh, BodyError> {
        let refused = |rule| Err(BodyError::Parameter { what: TOLERANCE, value: tolerance, rule });
        positive(TOLERANCE, tolerance)?;
        let mut exact = Welded::of(self, threads);
        let reach = tolerance / exact.unit;
        let edges = Edges::of(&exact.corners, exact.points.len(), threads);
        let ends = boundary_vertices(&exact, &edges.boundary);
        if !ends.is_empty() && tolerance > LARGEST * self.diagonal() {
            return refused("at most a hundredth of the diagonal of the mesh's box");
        }
        let points: Vec<[f64; 3]> = ends.iter().map(|&v| exact.points[v as usize]).collect();
        let close = ClosePairs::of(&points, reach, threads);
        let found = clusters(points.len(), close.pairs);
        let mut widest = 0.0_f64;
        for cluster in &found {
            let (width, ends) = across(&points, cluster);
            if width > reach {
                let example = ends.map(|i| exact.place(points[i as usize]));
                let distance = width * exact.unit;
                return Err(BodyError::WeldTooWide { tolerance, vertices: cluster.len(), distance, example });
            }
            widest = widest.max(width);
        }
        if !close.complete {
            return refused(
                "less than what tells the vertices apart: fewer of them have to be so near each other",
            );
        }
        let mut farthest = 0.0_f64;
        let mut into: Vec<u32> = (0..exact.points.len() as u32).collect();
        let mut is_moved = vec![false; exact.points.len()];
        for cluster in &found {
            let point = mean(&points, cluster);
            let first = ends[cluster[0] as usize];
            exact.points[first as usize] = point;
            for &i in cluster {
                farthest = farthest.max(distance(point, points[i as usize]));
                into[ends[i as usize] as usize] = first;
            }
            is_moved[first as usize] = true;
        }
        let proper = exact.corners.iter().filter(|corners| is_proper(corners)).count();
        exact.corners.as_flattened_mut().iter_mut().for_each(|v| *v = into[*v as usize]);
        let vanished = proper - exact.corners.iter().filter(|corners| is_proper(corners)).count();
        let junctions = Junctions::split(&mut exact, reach, threads);
        junctions.vertices.iter().for_each(|&v| is_moved[v as usize] = true);
        let farthest = farthest + junctions.farthest;
        let volume_bound = swept(&exact, &is_moved, farthest) * exact.unit.powi(3);
        let open_edges = Edges::of(&exact.corners, exact.points.len(), threads).boundary.len();
        Ok(WeldedMesh {
            joined: found.iter().map(Vec::len).sum(),
            points: found.len(),
            largest_distance: widest * exact.unit,
            farthest_move: farthest * exact.unit,
            vanished,
            junctions: junctions.count,
            largest_offset: junctions.farthest * exact.unit,
            origins: junctions.origins,
            open_edges,
            volume_bound,
            mesh: compact(exact),
        })
    }
}

const TOLERANCE: &str = "the tolerance of a weld";

/// Returns a bound of the volume swept by triangles whose vertices move by up to d = `by`: ∫₀¹ d
/// A(s) ds. The area A(s) is at most |u × v|/2 + s d (|u| + |v|) + 2 s² d², where u and v are the
/// two shorter sides of the triangle.
fn swept(exact: &Welded, is_moved: &[bool], by: f64) -> f64 {
    let moved = exact.corners.iter().filter(|corners| corners.iter().any(|&v| is_moved[v as usize]));
    let area = moved.map(|corners| {
        let [a, b, c] = corners.map(|v| exact.points[v as usize]);
        let perimeter = distance(a, b) + distance(b, c) + distance(c, a);
        0.5 * distance(normal([a, b, c]), [0.0; 3]) + by * perimeter / 3.0 + 2.0 / 3.0 * by * by
    });
    // The factor exceeds the rounding of the sum.
    by * area.sum::<f64>() * (1.0 + 1e-9) + 0.0 // the sum of nothing is −0
}

/// Returns the mesh with only the points that triangles use.
pub(super) fn compact(mut exact: Welded) -> TriangleMesh {
    let mut number = vec![NONE; exact.points.len()];
    let mut vertices = Vec::new();
    for v in exact.corners.as_flattened_mut() {
        let old = *v as usize;
        if number[old] == NONE {
            number[old] = vertices.len() as u32;
            vertices.push(exact.points[old].map(|c| c * exact.unit));
        }
        *v = number[old];
    }
    TriangleMesh { vertices, triangles: exact.corners, is_hull: false }
}
