//! T-junctions: boundary vertices inside boundary edges of other triangles.

use std::collections::{BTreeMap, HashMap};

use super::close_pairs::distance;
use super::edges::{Edges, end_of, opposite, start_of};
use super::threads::Threads;
use super::weld::Welded;

/// Splits of boundary edges at vertices near them.
#[derive(Debug, Default)]
pub(super) struct Junctions {
    /// Number of vertices at which an edge was split, counted for each edge.
    pub(super) count: usize,
    /// Largest distance of such a vertex from its edge.
    pub(super) farthest: f64,
    /// Vertices at which edges were split.
    pub(super) vertices: Vec<u32>,
    /// Earlier triangle to which each added triangle belonged.
    pub(super) origins: Vec<u32>,
}

/// Largest number of passes. A pass makes edges shorter, and an edge shorter than the tolerance is
/// not split; a mesh that needs more passes stays open.
const MOST_PASSES: usize = 64;

impl Junctions {
    /// Splits boundary edges at boundary vertices within `reach` of their interior, until there are
    /// none. The first piece of a triangle takes its place; the others are added at the end.
    pub(super) fn split(exact: &mut Welded, reach: f64, threads: Threads) -> Self {
        let given = exact.corners.len() as u32;
        let mut all = Self::default();
        for _ in 0..MOST_PASSES {
            let edges = Edges::of(&exact.corners, exact.points.len(), threads);
            let vertices = boundary_vertices(exact, &edges.boundary);
            let grid = Grid::of(exact, &edges.boundary, &vertices, reach);
            let mut splits: BTreeMap<u32, (u32, Vec<Near>)> = BTreeMap::new();
            for &half in &edges.boundary {
                let near = grid.near(exact, half, reach);
                // Other edges of the same triangle are split in the next pass.
                if !near.is_empty() {
                    splits.entry(half / 3).or_insert((half, near));
                }
            }
            if splits.is_empty() {
                break;
            }
            for (triangle, (half, near)) in splits {
                let tip = opposite(&exact.corners, half);
                let mut from = start_of(&exact.corners, half);
                let end = end_of(&exact.corners, half);
                let origin = match triangle.checked_sub(given) {
                    None => triangle,
                    Some(added) => all.origins[added as usize],
                };
                let first = near[0].vertex;
                exact.corners[triangle as usize] = [from, first, tip];
                from = first;
                for to in near[1..].iter().map(|near| near.vertex).chain([end]) {
                    exact.corners.push([from, to, tip]);
                    all.origins.push(origin);
                    from = to;
                }
                all.count += near.len();
                all.farthest = near.iter().map(|near| near.distance).fold(all.farthest, f64::max);
                all.vertices.extend(near.iter().map(|near| near.vertex));
            }
        }
        all
    }
}

/// Vertex near the interior of an edge.
struct Near {
    /// Position along the edge, from 0 to 1.
    along: f64,
    distance: f64,
    vertex: u32,
}

/// Boundary vertices in cubic cells.
struct Grid {
    cells: HashMap<[i64; 3], Vec<u32>>,
    side: f64,
}

impl Grid {
    /// Returns the grid. Cells are about as large as an edge, and at least twice the tolerance.
    fn of(exact: &Welded, boundary: &[u32], vertices: &[u32], reach: f64) -> Self {
        let length = |&half: &u32| {
            let [a, b] = ends(exact, half);
            distance(a, b)
        };
        let mean = boundary.iter().map(length).sum::<f64>() / boundary.len().max(1) as f64;
        // Coordinates are about 1: the numbers of cells stay exact.
        let mut grid = Self { cells: HashMap::new(), side: mean.max(2.0 * reach).max(1e-9) };
        for &v in vertices {
            grid.cells.entry(grid.cell(exact.points[v as usize])).or_default().push(v);
        }
        grid
    }

    fn cell(&self, p: [f64; 3]) -> [i64; 3] {
        p.map(|c| (c / self.side).floor() as i64)
    }

    /// Returns the vertices within `reach` of the interior of an edge, in their order along it.
    /// Vertices of its triangle, and those within `reach` of its ends, are left out.
    fn near(&self, exact: &Welded, half: u32, reach: f64) -> Vec<Near> {
        let [a, b] = ends(exact, half);
        let own = exact.corners[half as usize / 3];
        let edge: [f64; 3] = core::array::from_fn(|k| b[k] - a[k]);
        let squared: f64 = edge.iter().map(|c| c * c).sum();
        let steps = (squared.sqrt() / self.side).ceil().max(1.0);
        let mut found: Vec<u32> = Vec::new();
        // Points at most a side apart: whatever is within half a side of the edge is in a cell next
        // to that of one of them.
        for step in 0..=steps as u64 {
            let t = step as f64 / steps;
            let [x, y, z] = self.cell(core::array::from_fn(|k| a[k] + t * edge[k]));
            for cell in (0..27).map(|k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]) {
                found.extend(self.cells.get(&cell).into_iter().flatten());
            }
        }
        found.sort_unstable();
        found.dedup();
        let mut near: Vec<Near> = found
            .into_iter()
            .filter(|vertex| !own.contains(vertex))
            .filter_map(|vertex| {
                let p = exact.points[vertex as usize];
                let along = (0..3).map(|k| (p[k] - a[k]) * edge[k]).sum::<f64>() / squared;
                let foot = core::array::from_fn(|k| a[k] + along * edge[k]);
                let off = distance(p, foot);
                let is_inside = along > 0.0
                    && along < 1.0
                    && off <= reach
                    && distance(p, a) > reach
                    && distance(p, b) > reach;
                is_inside.then_some(Near { along, distance: off, vertex })
            })
            .collect();
        near.sort_by(|p, q| p.along.total_cmp(&q.along).then(p.vertex.cmp(&q.vertex)));
        near
    }
}

fn ends(exact: &Welded, half: u32) -> [[f64; 3]; 2] {
    [start_of(&exact.corners, half), end_of(&exact.corners, half)].map(|v| exact.points[v as usize])
}

/// Returns the vertices at edges of one triangle, ascending.
pub(super) fn boundary_vertices(exact: &Welded, boundary: &[u32]) -> Vec<u32> {
    let ends =
        boundary.iter().flat_map(|&half| [start_of(&exact.corners, half), end_of(&exact.corners, half)]);
    let mut vertices: Vec<u32> = ends.collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}
