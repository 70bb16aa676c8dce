//! By which weld, or by which holes filled, an open mesh would close.

use super::close_pairs::{ClosePairs, distance};
use super::clusters::{across, clusters};
use super::edges::{Edges, end_of, start_of};
use super::patches::{join, root};
use super::threads::Threads;
use super::weld::Welded;
use super::weld_near::boundary_vertices;
use super::{ClosedMesh, TriangleMesh};

/// The weld that closes a mesh: [`TriangleMesh::closing_weld`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosingWeld {
    /// The least tolerance that closes it, in parts of the mesh's [`diagonal`](TriangleMesh::diagonal).
    pub least: f64,
    /// A tolerance of few digits that is known to close it, in parts of the diagonal.
    pub tolerance: f64,
    /// Vertices that it joins.
    pub joined: usize,
    /// Points that become of them.
    pub points: usize,
}

/// The largest tolerance that is looked for, in parts of the diagonal, and how often a tenth of it is taken where too much is that near.
const LARGEST: f64 = 1e-3;
const TENTHS: i32 = 9;

/// The most of the volume that a weld worth a mention leaves open: one that presses sheets onto each other closes them too.
const MOST_BOUND: f64 = 0.01;

/// Open edges up to which it is looked for: the bisection sorts them some thirty times.
const MOST_EDGES: usize = 2_000_000;

impl TriangleMesh {
    /// The weld by which an open mesh bounds a solid, up to a thousandth of its size; `None` if there is none, if it leaves more than a hundredth of
    /// the volume open, if the mesh is not open, or if it does not `go_on`, which is asked often.
    ///
    /// It is not looked for among more than two million open edges. Where the edges of one triangle come in pairs is bisected over the distances of their vertices; what is found is welded and diagnosed.
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

/// The fill that closes a mesh: [`TriangleMesh::closing_fill`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosingFill {
    /// How far its largest hole is across, in parts of the mesh's [`diagonal`](TriangleMesh::diagonal).
    pub largest: f64,
    /// A size of few digits that fills them all, in parts of the diagonal.
    pub size: f64,
    /// Holes that it closes.
    pub holes: usize,
    /// Triangles that close them.
    pub triangles: usize,
}

/// The largest hole that is looked for, in parts of the diagonal: of a larger one it is not known what it was.
const LARGEST_HOLE: f64 = 0.1;

impl TriangleMesh {
    /// The size of holes by which an open mesh bounds a solid once they are filled, up to a tenth of its own size; `None` if there is none, if the mesh is
    /// not open, or if it does not `go_on`, which is asked often. What is found is filled and diagnosed.
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

/// The open edges of a mesh.
struct Seams {
    /// The vertices at them, m.
    points: Vec<[f64; 3]>,
    /// Each edge's ends, by number.
    edges: Vec<[u32; 2]>,
    /// Pairs of vertices that are near each other, with their distance, ascending.
    pairs: Vec<(f64, [u32; 2])>,
    /// How near, m.
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

    /// The least distance at which the edges come in pairs, and what is joined is no farther apart. To join more does not open them again, and
    /// does not bring together what was too far apart.
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

    /// With the first pairs joined, is every edge there an even number of times?
    fn is_paired(&self, first: usize) -> bool {
        let mut parent: Vec<u32> = (0..self.points.len() as u32).collect();
        self.pairs[..first].iter().for_each(|(_, [i, j])| join(&mut parent, *i, *j));
        let joined = self.edges.iter().map(|ends| ends.map(|v| root(&mut parent, v)));
        let mut edges: Vec<_> = joined.filter(|[a, b]| a != b).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.chunk_by(|e, f| e == f).all(|edge| edge.len() % 2 == 0)
    }
}

/// A number of so many digits that is a little larger.
fn rounded_up(x: f64, digits: i32) -> f64 {
    let exponent = x.log10().floor() as i32 - (digits - 1);
    let decimal = |n: f64| format!("{n}e{exponent}").parse().unwrap_or(x);
    let whole = (x / 10_f64.powi(exponent)).floor();
    (1..4).map(|more| decimal(whole + f64::from(more))).find(|y| *y > x * (1.0 + 1e-12)).unwrap_or(x)
}
