//! Caps that close the holes of a mesh, and the region in which any other surface can differ.

use super::TriangleMesh;
use super::clusters::{across, mean};
use super::edges::{Edges, end_of, start_of};
use super::fill::{MOST_EDGES, triangulated};
use super::moment_bound::MomentBound;
use super::patches::{join, root};
use super::threads::Threads;
use super::weld::Welded;
use super::weld_near::compact;
use crate::body::error::BodyError;

/// Mesh whose holes are all closed by caps: [`TriangleMesh::capped`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CappedMesh {
    /// Mesh with each vertex once: the original triangles in their order, then those of the caps.
    pub mesh: TriangleMesh,
    /// Number of triangles of the caps.
    pub triangles: usize,
    /// Holes, in the order of the mesh.
    pub holes: Vec<MeshHole>,
}

/// Hole of a mesh: boundary edges that are connected through vertices.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshHole {
    /// Vertices of its edges, m.
    pub rim: Vec<[f64; 3]>,
    /// Number of closed curves that its edges form.
    pub loops: usize,
    /// Largest distance between two vertices, m.
    pub size: f64,
    /// Mean of its vertices, m.
    pub center: [f64; 3],
}

impl MeshHole {
    /// Returns bounds of the absolute moments of its convex hull about a point.
    ///
    /// Let w be the winding number of the mesh with its caps, and w' that of the true solid, which
    /// contains the mesh in its surface. Both are 0 or 1 everywhere, so that |w − w'| ≤ 1. If the
    /// missing surface lies within the convex hull of the hole, as the cap does, their difference
    /// is a closed surface within the hull, and w = w' outside the hull. Therefore |ΔV| ≤ ∫ dV,
    /// |Δ∫xᵢ dV| ≤ ∫|xᵢ| dV and |Δ∫xᵢxⱼ dV| ≤ ∫|xᵢxⱼ| dV over the hull. Bounds of several holes are
    /// added. A planar hole has a hull without volume, so that its cap is exact.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for a vertex that is not finite.
    pub fn bound(&self, about: [f64; 3]) -> Result<MomentBound, BodyError> {
        MomentBound::of_hull(&self.rim, about)
    }

    /// Returns the hole in another unit of length: lengths are multiplied by a factor.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.rim.as_flattened_mut().iter_mut().for_each(|c| *c *= factor);
        Self { size: self.size * factor, center: self.center.map(|c| c * factor), ..self }
    }
}

impl TriangleMesh {
    /// Closes every hole with a cap in the convex hull of the hole's edges.
    ///
    /// Boundary edges are divided into closed curves without double points. A curve of at most 256
    /// edges gets the triangulation of smallest area, which is planar for a planar curve. A longer
    /// one gets triangles from the mean of its vertices. Caps are oriented as their neighbours.
    ///
    /// The caps may intersect the mesh: the diagnosis of the result finds this. If `goes_on`
    /// returns false (it is called often), the remaining holes stay open.
    ///
    /// ```
    /// use polhode::body::mesh::{ClosedMesh, TriangleMesh};
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let capped = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [x, y, z]])?.capped(&|| true);
    /// assert_eq!((capped.holes.len(), capped.triangles), (1, 1));
    /// assert_eq!(ClosedMesh::of(&capped.mesh)?.volume(), 1.0);
    /// assert_eq!(capped.holes[0].bound([0.3, -0.2, 0.7])?.measure, 0.0); // it is planar
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn capped(&self, goes_on: &(dyn Fn() -> bool + Sync)) -> CappedMesh {
        let threads = Threads::of_machine();
        let mut exact = Welded::of(self, threads);
        let given = exact.corners.len();
        let rims = rims(&exact, threads);
        let mut holes = Vec::with_capacity(rims.len());
        for rim in &rims {
            let curves = curves(rim);
            let mut vertices: Vec<u32> = rim.iter().flat_map(|edge| edge.ends()).collect();
            vertices.sort_unstable();
            vertices.dedup();
            let place = |v: &u32| exact.place(exact.points[*v as usize]);
            holes.push(MeshHole {
                rim: vertices.iter().map(place).collect(),
                loops: curves.len(),
                size: across(&exact.points, &vertices).0 * exact.unit,
                center: exact.place(mean(&exact.points, &vertices)),
            });
            for curve in curves.iter().take_while(|_| goes_on()) {
                cap(&mut exact, curve);
            }
        }
        CappedMesh { triangles: exact.corners.len() - given, holes, mesh: compact(exact) }
    }
}

/// Boundary edge as a cap traverses it: against its triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct RimEdge {
    from: u32,
    to: u32,
}

impl RimEdge {
    const fn ends(self) -> [u32; 2] {
        [self.from, self.to]
    }
}

/// Returns the edges with an odd number of triangles, in connected groups: every vertex has an even
/// number of them.
fn rims(exact: &Welded, threads: Threads) -> Vec<Vec<RimEdge>> {
    let corners = &exact.corners;
    let edges = Edges::of(corners, exact.points.len(), threads);
    let odd = edges.crowded.iter().filter(|edge| edge.len() % 2 == 1).map(|edge| {
        // The direction of the majority remains after the others cancel.
        let start = start_of(corners, edge[0]);
        let along = edge.iter().filter(|half| start_of(corners, **half) == start).count();
        let other = || edge.iter().copied().find(|half| start_of(corners, *half) != start);
        if 2 * along > edge.len() { edge[0] } else { other().unwrap_or(edge[0]) }
    });
    let mut halves: Vec<u32> = edges.boundary.iter().copied().chain(odd).collect();
    halves.sort_unstable();
    let mut parent: Vec<u32> = (0..exact.points.len() as u32).collect();
    let rim_edge = |half: u32| RimEdge { from: end_of(corners, half), to: start_of(corners, half) };
    for &half in &halves {
        join(&mut parent, start_of(corners, half), end_of(corners, half));
    }
    let mut number = std::collections::HashMap::new();
    let mut rims: Vec<Vec<RimEdge>> = Vec::new();
    for &half in &halves {
        let edge = rim_edge(half);
        let rim = *number.entry(root(&mut parent, edge.from)).or_insert(rims.len());
        if rim == rims.len() {
            rims.push(Vec::new());
        }
        rims[rim].push(edge);
    }
    rims
}

/// Divides connected edges into closed curves that visit each of their vertices once.
///
/// A walk follows the direction of the edges where possible. When it returns to a vertex of its
/// path, the part since then is a curve.
fn curves(rim: &[RimEdge]) -> Vec<Vec<RimEdge>> {
    // Edges at each vertex: those that leave it first.
    let mut at: Vec<(u32, bool, usize)> = Vec::with_capacity(2 * rim.len());
    for (k, edge) in rim.iter().enumerate() {
        at.extend([(edge.from, false, k), (edge.to, true, k)]);
    }
    at.sort_unstable();
    // First entry of each vertex that may be unused.
    let mut first: std::collections::HashMap<u32, usize> = std::collections::HashMap::new();
    let mut used = vec![false; rim.len()];
    let mut position = std::collections::HashMap::new();
    let mut curves = Vec::new();
    for start in 0..rim.len() {
        if used[start] {
            continue;
        }
        let mut path: Vec<RimEdge> = Vec::new();
        let mut vertex = rim[start].from;
        position.clear();
        position.insert(vertex, 0);
        loop {
            let entry = first.entry(vertex).or_insert_with(|| at.partition_point(|entry| entry.0 < vertex));
            while at.get(*entry).is_some_and(|&(v, _, k)| v == vertex && used[k]) {
                *entry += 1;
            }
            let Some(&(_, is_end, k)) = at.get(*entry).filter(|entry| entry.0 == vertex) else { break };
            used[k] = true;
            path.push(rim[k]);
            vertex = if is_end { rim[k].from } else { rim[k].to };
            match position.get(&vertex) {
                Some(&since) => {
                    let curve = path.split_off(since);
                    for edge in &curve {
                        for end in edge.ends().into_iter().filter(|end| *end != vertex) {
                            position.remove(&end);
                        }
                    }
                    curves.push(curve);
                }
                None => {
                    position.insert(vertex, path.len());
                }
            }
        }
    }
    curves
}

/// Adds the cap of a curve, whose edges are in the order of a walk along it.
fn cap(exact: &mut Welded, curve: &[RimEdge]) {
    let ring = ring(curve);
    if curve.len() <= MOST_EDGES {
        // The ring is traversed in the direction of its first edge; flipped neighbours are found by
        // the diagnosis.
        exact.corners.extend(triangulated(&exact.points, &ring));
        return;
    }
    let apex = exact.points.len() as u32;
    exact.points.push(mean(&exact.points, &ring));
    exact.corners.extend(curve.iter().map(|edge| [edge.from, edge.to, apex]));
}

/// Returns the vertices of a curve in the direction of the majority of its edges.
fn ring(curve: &[RimEdge]) -> Vec<u32> {
    let mut ring = Vec::with_capacity(curve.len());
    let mut forward = 0;
    for (k, edge) in curve.iter().enumerate() {
        let next = curve[(k + 1) % curve.len()].ends();
        let is_forward = next.contains(&edge.to);
        forward += usize::from(is_forward);
        ring.push(if is_forward { edge.from } else { edge.to });
    }
    if 2 * forward < curve.len() {
        ring.reverse();
    }
    ring
}
