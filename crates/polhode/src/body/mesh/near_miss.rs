//! Search for the weld or hole filling that closes an open mesh.

use super::close_pairs::{ClosePairs, distance};
use super::clusters::{across, clusters};
use super::edges::{Edges, end_of, start_of};
use super::junctions::boundary_vertices;
use super::patches::{join, root};
use super::threads::Threads;
use super::weld::Welded;
use super::{ClosedMesh, TriangleMesh};

/// Weld that closes a mesh: [`TriangleMesh::closing_weld`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosingWeld {
    /// Smallest tolerance that closes the mesh, relative to its
    /// [`diagonal`](TriangleMesh::diagonal).
    pub least: f64,
    /// Tolerance with few digits that is known to close the mesh, relative to the diagonal.
    pub tolerance: f64,
    /// Number of vertices that the weld joins.
    pub joined: usize,
    /// Number of points into which it joins them.
    pub points: usize,
}

/// Largest tolerance that is tried, relative to the diagonal, and the number of times that it is
/// divided by ten if too many vertices are that close.
const LARGEST: f64 = 1e-3;
const TENTHS: i32 = 9;

/// Largest uncertain volume, relative to the whole, of a weld that is reported: welding sheets onto
/// each other also closes them.
const MOST_BOUND: f64 = 0.01;

/// Maximum number of open edges for the search; the bisection sorts them about thirty times.
const MOST_EDGES: usize = 2_000_000;

impl TriangleMesh {
    /// Finds the weld that turns an open mesh into a solid, with a tolerance of at most a
    /// thousandth of the mesh's diagonal. Returns `None` if there is none, if more than a hundredth
    /// of the volume would be uncertain, if the mesh is not open, or if `goes_on` returns false (it
    /// is called often).
    ///
    /// The search is omitted for more than two million open edges. Bisection over the distances of
    /// the edges' vertices finds where the open edges match in pairs. The result is then welded and
    /// diagnosed.
    ///
    /// ```
    /// use polhode::body::mesh::TriangleMesh;
    /// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    /// let torn = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, [0.0, 1e-6, 1.0], y], [x, y, z]])?;
    /// let weld = torn.closing_weld(&|| true).ok_or("it closes")?;
    /// assert_eq!((weld.tolerance, weld.joined, weld.points), (3e-7, 2, 1)); // 1e-6 of √14
    /// assert_eq!(torn.welded(weld.tolerance * torn.diagonal())?.open_edges, 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn closing_weld(&self, goes_on: &(dyn Fn() -> bool + Sync)) -> Option<ClosingWeld> {
        if !goes_on() {
            return None;
        }
        let diagonal = self.diagonal();
        let threads = Threads::of_machine();
        let seams = Seams::of(&Welded::of(self, threads), threads, diagonal)?;
        let least = seams.least()? / diagonal;
        [1, 2, 3].into_iter().find_map(|digits| {
            let tolerance = rounded_up(least, digits);
            let welded = self.welded(tolerance * diagonal).ok().filter(|welded| welded.open_edges == 0)?;
            let solid = ClosedMesh::watched(&welded.mesh, goes_on).ok()?;
            let is_known = welded.volume_bound <= MOST_BOUND * solid.volume();
            is_known.then_some(ClosingWeld { least, tolerance, joined: welded.joined, points: welded.points })
        })
    }
}

/// Hole filling that closes a mesh: [`TriangleMesh::closing_fill`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosingFill {
    /// Diameter of the largest hole, relative to the mesh's [`diagonal`](TriangleMesh::diagonal).
    pub largest: f64,
    /// Hole size with few digits that fills all holes, relative to the diagonal.
    pub size: f64,
    /// Number of holes that it fills.
    pub holes: usize,
    /// Number of triangles that fill them.
    pub triangles: usize,
}

/// Largest hole that is filled, relative to the diagonal: the original surface of a larger one is
/// too uncertain.
const LARGEST_HOLE: f64 = 0.1;

impl TriangleMesh {
    /// Finds the hole size for which filling turns an open mesh into a solid, at most a tenth of
    /// the mesh's diagonal. Returns `None` if there is none, if the mesh is not open, or if
    /// `goes_on` returns false (it is called often). The result is filled and diagnosed.
    pub fn closing_fill(&self, goes_on: &(dyn Fn() -> bool + Sync)) -> Option<ClosingFill> {
        if !goes_on() {
            return None;
        }
        let diagonal = self.diagonal();
        let filled = self.filled(LARGEST_HOLE * diagonal).ok()?;
        if filled.holes == 0 || filled.open_edges > 0 {
            return None;
        }
        ClosedMesh::watched(&filled.mesh, goes_on).ok()?;
        let largest = filled.largest / diagonal;
        let sizes = [1, 2, 3].into_iter().map(|digits| rounded_up(largest, digits));
        let size =
            sizes.filter(|size| *size <= LARGEST_HOLE).find(|size| size * diagonal > filled.largest)?;
        Some(ClosingFill { largest, size, holes: filled.holes, triangles: filled.triangles })
    }
}

/// Open edges of a mesh.
struct Seams {
    /// Vertices of the open edges, m.
    points: Vec<[f64; 3]>,
    /// Ends of each edge, as indices into `points`.
    edges: Vec<[u32; 2]>,
    /// Pairs of vertices that are close together, with their distance, m, ascending.
    pairs: Vec<(f64, [u32; 2])>,
    /// Largest distance of the pairs, m.
    reach: f64,
}

impl Seams {
    fn of(exact: &Welded, threads: Threads, diagonal: f64) -> Option<Self> {
        let boundary = Edges::of(&exact.corners, exact.points.len(), threads).boundary;
        let vertices = boundary_vertices(exact, &boundary);
        if vertices.is_empty() || boundary.len() > MOST_EDGES {
            return None;
        }
        let number = |v: u32| vertices.partition_point(|&w| w < v) as u32;
        let ends = |&half: &u32| [start_of(&exact.corners, half), end_of(&exact.corners, half)].map(number);
        let edges = boundary.iter().map(ends).collect();
        let points: Vec<_> = vertices.iter().map(|&v| exact.place(exact.points[v as usize])).collect();
        let reaches = (0..=TENTHS).map(|k| LARGEST * diagonal * 0.1_f64.powi(k));
        let mut near = reaches.map(|reach| (reach, ClosePairs::of(&points, reach, threads)));
        let (reach, close) = near.find(|(_, close)| close.complete)?;
        let apart = |&[i, j]: &[u32; 2]| distance(points[i as usize], points[j as usize]);
        let mut pairs: Vec<_> = close.pairs.iter().map(|pair| (apart(pair), *pair)).collect();
        pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        Some(Self { points, edges, pairs, reach })
    }

    /// Returns the smallest distance at which the edges match in pairs and no joined vertices are
    /// farther apart. Joining more vertices neither opens the edges again nor joins vertices that
    /// were too far apart.
    fn least(&self) -> Option<f64> {
        let (mut open, mut closed) = (0, self.pairs.len());
        if !self.is_paired(closed) {
            return None;
        }
        while closed - open > 1 {
            let middle = open + (closed - open) / 2;
            if self.is_paired(middle) { closed = middle } else { open = middle }
        }
        let (mut tolerance, _) = *self.pairs.get(closed.checked_sub(1)?)?;
        loop {
            let within = self.pairs.iter().take_while(|pair| pair.0 <= tolerance).map(|pair| pair.1);
            let found = clusters(self.points.len(), within);
            let widest = found.iter().map(|cluster| across(&self.points, cluster).0).fold(0.0, f64::max);
            if widest <= tolerance {
                return Some(tolerance);
            }
            if widest > self.reach {
                return None;
            }
            tolerance = widest;
        }
    }

    /// Returns true if every edge occurs an even number of times after the first `first` pairs are
    /// joined.
    fn is_paired(&self, first: usize) -> bool {
        let mut parent: Vec<u32> = (0..self.points.len() as u32).collect();
        self.pairs[..first].iter().for_each(|(_, [i, j])| join(&mut parent, *i, *j));
        let joined = self.edges.iter().map(|ends| ends.map(|v| root(&mut parent, v)));
        let mut edges: Vec<_> = joined.filter(|[a, b]| a != b).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.chunk_by(|e, f| e == f).all(|edge| edge.len() % 2 == 0)
    }
}

/// Returns a slightly larger number with this number of significant digits.
fn rounded_up(x: f64, digits: i32) -> f64 {
    let exponent = x.log10().floor() as i32 - (digits - 1);
    let decimal = |n: f64| format!("{n}e{exponent}").parse().unwrap_or(x);
    let whole = (x / 10_f64.powi(exponent)).floor();
    (1..4).map(|more| decimal(whole + f64::from(more))).find(|y| *y > x * (1.0 + 1e-12)).unwrap_or(x)
}
