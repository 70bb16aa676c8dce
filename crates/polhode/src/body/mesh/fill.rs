//! Filling of small holes of a mesh with triangles.

use super::TriangleMesh;
use super::close_pairs::distance;
use super::clusters::across;
use super::edges::{Edges, end_of, start_of};
use super::patches::{join, root};
use super::threads::Threads;
use super::weld::{NONE, Welded, is_proper};
use super::weld_near::compact;
use crate::body::error::{BodyError, positive};
use crate::body::triangle_mesh::normal;

/// Mesh whose small holes were filled: [`TriangleMesh::filled`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FilledMesh {
    /// Mesh with each vertex once: the original triangles in their order, then those that fill the
    /// holes.
    pub mesh: TriangleMesh,
    /// Number of holes that were filled.
    pub holes: usize,
    /// Number of triangles that fill them.
    pub triangles: usize,
    /// Largest distance between two vertices of a filled hole, m.
    pub largest: f64,
    /// Number of boundary edges (edges of one triangle only) before filling.
    pub edges_before: usize,
    /// Number of boundary edges after filling.
    pub open_edges: usize,
    /// Numbers of holes that were not filled, by reason.
    pub left: HolesLeft,
    /// Bound of the error of the enclosed volume, m³, if the missing surface lies within the balls
    /// around the holes.
    pub volume_bound: f64,
    /// Largest radius of these balls, m.
    pub largest_radius: f64,
}

/// Numbers of holes that were not filled, by reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct HolesLeft {
    /// Number of holes with more than 256 edges.
    pub many_edged: usize,
    /// Number of other holes that are larger than the requested size.
    pub larger: usize,
    /// Number of loops that are rims of sheets, not holes: the filling triangles would have no less
    /// area than the sheet, or would use all of its vertices.
    pub sheets: usize,
    /// Number of boundary edges that do not form a separate loop, for example of holes that share a
    /// vertex.
    pub loose_edges: usize,
}

impl core::ops::Add for HolesLeft {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            many_edged: self.many_edged + other.many_edged,
            larger: self.larger + other.larger,
            sheets: self.sheets + other.sheets,
            loose_edges: self.loose_edges + other.loose_edges,
        }
    }
}

/// Maximum number of edges of a loop that is filled; the cost is proportional to its cube.
pub(super) const MOST_EDGES: usize = 256;

impl TriangleMesh {
    /// Fills the holes whose diameter is at most `size`, m. The diameter is the largest distance
    /// between two vertices.
    ///
    /// Each loop is filled with the triangulation of smallest area that uses the vertices of the
    /// loop only. If its area is at least that of the surface whose rim the loop is, or if that
    /// surface has no other vertices, the surface is a sheet and the loop is not filled. The true
    /// surface is unknown: `volume_bound` is the total volume of the balls around the holes. Each
    /// ball is centred at the centre of the bounding box of the hole's vertices and reaches the
    /// farthest of them.
    ///
    /// If the missing surface lies within these balls, the filled mesh and the true one enclose the
    /// same region elsewhere. The bound then holds for the volume in which they differ. Each ball
    /// has a vertex of its hole on its surface, which is a corner of the mesh. Therefore no point
    /// of the ball is farther from any point than the farthest corner plus the ball's diameter.
    /// [`ClosedMesh::effect`](super::ClosedMesh::effect) of `volume_bound` and twice the
    /// `largest_radius` thus bounds the change of the centre of mass and of the tensor.
    ///
    /// ```
    /// use polhode::body::mesh::{ClosedMesh, TriangleMesh};
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let open = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [x, y, z]])?;
    /// let filled = open.filled(3.5)?;
    /// assert_eq!((filled.holes, filled.triangles, filled.open_edges), (1, 1, 0));
    /// assert_eq!(ClosedMesh::of(&filled.mesh)?.volume(), 1.0);
    /// assert_eq!(open.filled(3.1)?.holes, 0); // it is √10 across
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the size is not positive and finite.
    pub fn filled(&self, size: f64) -> Result<FilledMesh, BodyError> {
        positive("the size of a hole", size)?;
        let threads = Threads::of_machine();
        let mut exact = Welded::of(self, threads);
        let edges = Edges::of(&exact.corners, exact.points.len(), threads);
        let boundary = &edges.boundary;
        let given = exact.corners.len();
        let found = loops(&exact.corners, boundary);
        let in_loops: usize = found.iter().map(|(_, hole)| hole.len()).sum();
        let mut left = HolesLeft { loose_edges: boundary.len() - in_loops, ..HolesLeft::default() };
        let sheets = if found.is_empty() { Sheets::default() } else { Sheets::of(&exact, &edges) };
        let (mut holes, mut closed, mut largest, mut radius, mut balls) = (0, 0, 0.0_f64, 0.0_f64, 0.0);
        for (half, hole) in found {
            if hole.len() > MOST_EDGES {
                left.many_edged += 1;
                continue;
            }
            let (width, _) = across(&exact.points, &hole);
            if width * exact.unit > size {
                left.larger += 1;
                continue;
            }
            let least_area = triangulated(&exact.points, &hole);
            if sheets.has_rim(half / 3, &least_area, &exact.points) {
                left.sheets += 1;
                continue;
            }
            let around = reach(&exact.points, &hole);
            (holes, closed) = (holes + 1, closed + hole.len());
            (largest, radius) = (largest.max(width), radius.max(around));
            balls += 4.0 / 3.0 * core::f64::consts::PI * around.powi(3);
            exact.corners.extend(least_area);
        }
        Ok(FilledMesh {
            holes,
            triangles: exact.corners.len() - given,
            largest: largest * exact.unit,
            edges_before: boundary.len(),
            open_edges: boundary.len() - closed,
            left,
            volume_bound: balls * exact.unit.powi(3),
            largest_radius: radius * exact.unit,
            mesh: compact(exact),
        })
    }
}

impl TriangleMesh {
    /// Returns the end points of the boundary edges (edges of one triangle only), m; of each edge
    /// the lexicographically smaller point first.
    pub fn open_edges(&self) -> Vec<[[f64; 3]; 2]> {
        let threads = Threads::of_machine();
        let exact = Welded::of(self, threads);
        let boundary = Edges::of(&exact.corners, exact.points.len(), threads).boundary;
        let ends = |&half: &u32| [start_of(&exact.corners, half), end_of(&exact.corners, half)];
        let sorted = |[a, b]: [[f64; 3]; 2]| if a <= b { [a, b] } else { [b, a] };
        let places = |ends: [u32; 2]| ends.map(|v| exact.place(exact.points[v as usize]));
        boundary.iter().map(|half| sorted(places(ends(half)))).collect()
    }
}

/// Surfaces connected through edges.
#[derive(Default)]
struct Sheets {
    /// Representative triangle of the surface of each triangle.
    first: Vec<u32>,
    /// Number of triangles and area, m², of the surface of each representative.
    sizes: Vec<(usize, f64)>,
}

impl Sheets {
    fn of(exact: &Welded, edges: &Edges) -> Self {
        let mut first: Vec<u32> = (0..exact.corners.len() as u32).collect();
        for half in 0..3 * first.len() as u32 {
            let twin = edges.twin(half);
            if twin != NONE {
                join(&mut first, half / 3, twin / 3);
            }
        }
        for pair in edges.crowded.iter().flat_map(|edge| edge.windows(2)) {
            join(&mut first, pair[0] / 3, pair[1] / 3);
        }
        let mut sizes = vec![(0, 0.0); first.len()];
        for t in (0..first.len()).filter(|&t| is_proper(&exact.corners[t])) {
            let (count, area) = &mut sizes[root(&mut first, t as u32) as usize];
            (*count, *area) = (*count + 1, *area + area_of(exact.triangle(t)));
        }
        for t in 0..first.len() as u32 {
            first[t as usize] = root(&mut first, t);
        }
        Self { first, sizes }
    }

    /// Returns true if the loop that the triangles `between` fill is the rim of a whole surface,
    /// the one that contains `triangle`. A surface with no more triangles than `between` has no
    /// vertices except those of the loop.
    fn has_rim(&self, triangle: u32, between: &[[u32; 3]], points: &[[f64; 3]]) -> bool {
        /// Relative rounding tolerance of the area of a plane sheet.
        const ROUNDED: f64 = 1e-6;
        let (count, area) = self.sizes[self.first[triangle as usize] as usize];
        let own: f64 = between.iter().map(|corners| area_of(corners.map(|v| points[v as usize]))).sum();
        count <= between.len() || own >= area * (1.0 - ROUNDED)
    }
}

fn area_of(triangle: [[f64; 3]; 3]) -> f64 {
    0.5 * distance(normal(triangle), [0.0; 3])
}

/// Returns the boundary loops, traversed against their half-edges, each with one of its half-edges.
/// Loops through a vertex shared with another loop are omitted.
fn loops(corners: &[[u32; 3]], boundary: &[u32]) -> Vec<(u32, Vec<u32>)> {
    let mut from: Vec<(u32, u32, u32)> =
        boundary.iter().map(|&h| (start_of(corners, h), end_of(corners, h), h)).collect();
    from.sort_unstable();
    let next = |v: u32| {
        let first = from.partition_point(|edge| edge.0 < v);
        let is_only = from.get(first).is_some_and(|edge| edge.0 == v)
            && from.get(first + 1).is_none_or(|edge| edge.0 != v);
        is_only.then_some(first)
    };
    let mut visited = vec![false; from.len()];
    let mut loops = Vec::new();
    for k in 0..from.len() {
        let mut hole = Vec::new();
        let mut at = Some(k);
        while let Some(edge) = at.filter(|&edge| !visited[edge]) {
            visited[edge] = true;
            hole.push(from[edge].0);
            at = next(from[edge].1);
        }
        // The walk is back at its start, where no other edge starts.
        if at == Some(k) && next(from[k].0) == Some(k) && hole.len() > 2 {
            hole.reverse();
            loops.push((from[k].2, hole));
        }
    }
    loops
}

/// Returns the largest distance of the vertices from the centre of their bounding box.
fn reach(points: &[[f64; 3]], hole: &[u32]) -> f64 {
    let at = |k: usize| hole.iter().map(move |&v| points[v as usize][k]);
    let middle = core::array::from_fn(|k| {
        0.5 * (at(k).fold(f64::INFINITY, f64::min) + at(k).fold(f64::NEG_INFINITY, f64::max))
    });
    hole.iter().map(|&v| distance(points[v as usize], middle)).fold(0.0, f64::max)
}

/// Returns the triangulation of a polygon with the smallest total area, by dynamic programming over
/// its diagonals.
///
/// A plane polygon is triangulated without overlap, because any other triangulation has more area.
pub(super) fn triangulated(points: &[[f64; 3]], hole: &[u32]) -> Vec<[u32; 3]> {
    // Starts at the lexicographically smallest vertex, so that the result does not depend on the
    // order of the triangles if two triangulations have equal area.
    let key = |v: &u32| points[*v as usize].map(|c| c + 0.0);
    let least = |a: &(usize, &u32), b: &(usize, &u32)| {
        let (p, q) = (key(a.1), key(b.1));
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(p[2].total_cmp(&q[2]))
    };
    let first = hole.iter().enumerate().min_by(least).map_or(0, |(k, _)| k);
    let ring: Vec<u32> = hole[first..].iter().chain(&hole[..first]).copied().collect();
    let n = ring.len();
    let p = |i: usize| points[ring[i] as usize];
    let area = |i: usize, k: usize, j: usize| area_of([p(i), p(k), p(j)]);
    let mut best = vec![(0.0_f64, 0_usize); n * n];
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let ways = (i + 1..j).map(|k| (best[i * n + k].0 + best[k * n + j].0 + area(i, k, j), k));
            best[i * n + j] = ways.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        }
    }
    let mut triangles = Vec::with_capacity(n - 2);
    let mut waiting = vec![(0, n - 1)];
    while let Some((i, j)) = waiting.pop() {
        if j - i > 1 {
            let k = best[i * n + j].1;
            triangles.push([ring[i], ring[k], ring[j]]);
            waiting.extend([(i, k), (k, j)]);
        }
    }
    triangles
}
