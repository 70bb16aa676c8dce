//! Diagnosis of a mesh: properties and defects, with their places.

use super::TriangleMesh;
use super::component::{Measured, MeshComponent};
use super::edges::{Edges, end_of, start_of};
use super::inside::Windings;
use super::layer::Layers;
use super::overlap::{Meetings, Overlaps};
use super::patches::{Patches, is_balanced, join};
use super::sought::Sought;
use super::star::is_star_shaped;
use super::threads::Threads;
use super::tree::Tree;
use super::weld::{NONE, Welded, is_proper};
use super::work::{GoesOn, Work};

/// Diagnosis of a mesh: everything for which [`ClosedMesh`](crate::body::mesh::ClosedMesh) returns
/// an error, a correction or a remark, with its place.
///
/// Corners are the same vertex if their coordinates are exactly equal, and exact signs decide
/// whether triangles intersect, without a tolerance. The numbers are the same for any number of
/// threads. Time and memory are proportional to the triangles plus the pairs of close triangles.
/// The search for overlaps stops at the counting limit. Of several identical triangles with the
/// same orientation, only one is compared with others.
///
/// ```
/// use polhode::body::mesh::{ComponentRole, MeshDiagnosis, TriangleMesh};
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let tetrahedron = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
/// let diagnosis = MeshDiagnosis::of(&tetrahedron);
/// assert!(diagnosis.boundary.is_empty() && diagnosis.overlaps.is_empty());
/// assert_eq!(diagnosis.components[0].role, ComponentRole::Solid);
///
/// let torn = TriangleMesh::of_triangles(&[[o, y, x], [o, x, z], [o, z, y]])?;
/// let boundary = MeshDiagnosis::of(&torn).boundary;
/// assert_eq!((boundary.count, boundary.first.map(|edge| edge.triangle)), (3, Some(1)));
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshDiagnosis {
    /// Number of triangles in the input.
    pub triangles: usize,
    /// Number of distinct corners.
    pub vertices: usize,
    /// Edges that belong to one triangle: the mesh is open there.
    pub boundary: Faults<EdgePlace>,
    /// Number of loops of boundary edges; loops that share a vertex count as one.
    pub boundary_loops: usize,
    /// Edges that their two triangles traverse in the same direction.
    pub inconsistent: Faults<EdgePlace>,
    /// Edges of more than two triangles; bodies that touch along an edge have four.
    pub non_manifold: Faults<EdgePlace>,
    /// Edges of more than two triangles that are not traversed equally often in both directions.
    pub unbalanced: Faults<EdgePlace>,
    /// Degenerate triangles: two corners are equal.
    pub degenerate: Faults<TrianglePlace>,
    /// Triangles with three distinct collinear corners; these are seams, not defects.
    pub collinear: Faults<TrianglePlace>,
    /// Duplicates of other triangles with the same orientation.
    pub duplicates: Faults<PairPlace>,
    /// Duplicates of other triangles with opposite orientation: a wall of zero thickness, or a
    /// contact of two bodies.
    pub back_to_back: Faults<PairPlace>,
    /// Pairs of triangles that intersect, or that show overlapping bodies, on surfaces that are
    /// connected at most through edges of more than two triangles. At most 10,000 of these are
    /// counted; 10,001 stands for any larger number. The same limit holds for `self_overlaps` and
    /// `contacts`.
    pub overlaps: Faults<PairPlace>,
    /// Pairs of triangles of one surface that intersect or show an overlap.
    pub self_overlaps: Faults<PairPlace>,
    /// Pairs of faces that touch back to back without being the same triangle: contacts of bodies.
    pub contacts: Faults<PairPlace>,
    /// Components connected through edges, in the order of their first triangles.
    pub components: Vec<MeshComponent>,
    /// Number of steps after which the search for overlaps and nesting stopped undecided; `None` if
    /// it finished. The limit is 300 million plus 2,000 per triangle, unless the caller ended the
    /// search earlier.
    pub undecided: Option<u64>,
    /// True if the triangles were not searched for intersections, as by
    /// [`ClosedMesh::unchecked`](crate::body::mesh::ClosedMesh::unchecked). Then `overlaps`,
    /// `self_overlaps` and `contacts` are empty.
    pub unsearched: bool,
}

/// Number of faults of one kind, and the first in the order of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults<P> {
    /// Number of faults.
    pub count: usize,
    /// First fault; if the counting limit was exceeded, the first of those counted.
    pub first: Option<P>,
}

impl<P> Faults<P> {
    /// Returns true if the number of faults is zero.
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl<P> Default for Faults<P> {
    fn default() -> Self {
        Self { count: 0, first: None }
    }
}

/// Place of an edge of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePlace {
    /// Index of the triangle, from 1.
    pub triangle: usize,
    /// End points of the edge, m.
    pub ends: [[f64; 3]; 2],
}

/// Place of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrianglePlace {
    /// Index of the triangle, from 1.
    pub triangle: usize,
    /// Corners of the triangle, m.
    pub corners: [[f64; 3]; 3],
}

/// Place of a pair of triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairPlace {
    /// Indices of the triangles, from 1, ascending.
    pub triangles: [usize; 2],
    /// Common point of the triangles, m, rounded.
    pub point: [f64; 3],
}

impl MeshDiagnosis {
    /// Diagnoses the mesh; a large one on all threads of the machine.
    pub fn of(mesh: &TriangleMesh) -> Self {
        Analysis::of(mesh, Sought::All, Threads::for_triangles(mesh.triangles.len()), &|| true).diagnosis
    }

    /// Diagnoses the mesh on at most `threads` threads.
    pub fn with_threads(mesh: &TriangleMesh, threads: usize) -> Self {
        Analysis::of(mesh, Sought::All, Threads::of(threads), &|| true).diagnosis
    }
}

/// Diagnosis and the intermediate results that it is based on.
#[derive(Debug)]
pub(crate) struct Analysis {
    pub(crate) welded: Welded,
    pub(crate) patches: Patches,
    pub(super) edges: Edges,
    pub(super) meetings: Meetings,
    pub(crate) diagnosis: MeshDiagnosis,
}

impl Analysis {
    pub(crate) fn of(mesh: &TriangleMesh, sought: Sought, threads: Threads, goes_on: &GoesOn<'_>) -> Self {
        let work = Work::of(STEPS + STEPS_EACH * mesh.triangles().len() as u64, goes_on);
        Self::within(&work, mesh, sought, threads)
    }

    /// Analyses the mesh within a step limit for the searches among the triangles.
    pub(super) fn within(work: &Work<'_>, mesh: &TriangleMesh, sought: Sought, threads: Threads) -> Self {
        let welded = Welded::of(mesh, threads);
        let corners = &welded.corners;
        let edges = Edges::of(corners, welded.points.len(), threads);
        // An open mesh, or one with duplicate triangles, bounds nothing, whatever else it contains.
        let is_torn = !edges.boundary.is_empty() || edges.duplicates.iter().any(|&(_, _, same_way)| same_way);
        if sought == Sought::FirstError && is_torn {
            let (patches, meetings) = (Patches::default(), Meetings::default());
            let diagnosis =
                Findings { welded: &welded, edges: &edges }.diagnosis(Measured::default(), &meetings);
            return Self { welded, patches, edges, meetings, diagnosis };
        }
        let patches = Patches::of(corners, &edges, threads);
        let mut measured = Measured::of(&welded, &patches, threads);
        // A triangle without area has no sides. It meets only triangles that its neighbours also
        // meet.
        let has_area =
            |t: usize| patches.component[t] != NONE && measured.collinear.binary_search(&(t as u32)).is_err();
        // The same holds for an inconsistent component. A single surface without edges of more than
        // two triangles can only meet itself, which is a remark.
        let is_one = measured.components.len() == 1 && edges.crowded.is_empty();
        let is_known = match sought {
            Sought::FirstError => {
                is_one || measured.components.iter().any(|component| !component.role.is_closed())
            }
            Sought::NoIntersections => is_one,
            Sought::All => {
                is_one && measured.collinear.is_empty() && work.goes_on() && is_star_shaped(&welded, &edges)
            }
        };
        let tree = Tree::of(&welded, |t| !is_known && has_area(t), threads);
        let windings = Windings { welded: &welded, tree: &tree, patches: &patches, work };
        if !is_known {
            measured.nest(&windings, threads);
        }
        let is_searched = !mesh.is_hull && !is_known && sought != Sought::NoIntersections;
        let meetings = if !is_searched || !work.goes_on() {
            // At a vertex of a hull with many faces, the number of pairs is quadratic, and none of
            // them meet elsewhere.
            Meetings::default()
        } else {
            let mut is_again = vec![false; welded.corners.len()];
            let again = edges.again();
            again.iter().for_each(|&t| is_again[t as usize] = true);
            let once = (!again.is_empty()).then(|| {
                let order = tree.order().iter().copied().filter(|&t| !is_again[t as usize]);
                tree.part(&welded, order.collect(), threads)
            });
            let once = once.as_ref().unwrap_or(&tree);
            let doubtful = |tree: &Tree| {
                let layers = Layers::of(&welded, tree, &edges, |t| is_again[t as usize], &measured.collinear);
                layers.doubtful(work, threads)
            };
            let doubtful = (once.order().len() >= WORTH_LAYERS).then(|| doubtful(once));
            let some = doubtful.filter(|some| some.len() < once.order().len());
            let some = some.map(|some| once.part(&welded, some, threads));
            let doubtful = some.as_ref().unwrap_or(once);
            Meetings::of(&windings, &edges, doubtful, lowest_winding(&measured.components), sought, threads)
        };
        let undecided = work.not_enough();
        // The results found before the search stopped depend on the threads.
        let meetings = if undecided.is_some() { Meetings::default() } else { meetings };
        let findings = Findings { welded: &welded, edges: &edges };
        let unsearched = sought == Sought::NoIntersections;
        let diagnosis = MeshDiagnosis { undecided, unsearched, ..findings.diagnosis(measured, &meetings) };
        Self { welded, patches, edges, meetings, diagnosis }
    }
}

/// Number of triangles below which comparing all close ones takes less time than the search for
/// regions of a single layer. For a torus of 1,280 triangles it saves a seventh of the time; of
/// 5,120, it would add a third.
const WORTH_LAYERS: usize = 1 << 11;

/// Step limit for a mesh, and its increment per triangle. Most steps are visits of a line at a
/// triangle. Walls of touching bricks take about 400 per triangle.
const STEPS: u64 = 300_000_000;
const STEPS_EACH: u64 = 2_000;

/// Returns the winding number of a valid mesh in front of its triangles: 0, or −1 if the whole mesh
/// is oriented inward.
fn lowest_winding(components: &[MeshComponent]) -> Option<i32> {
    let volume: f64 = components.iter().map(|component| component.volume).sum();
    components.iter().all(|component| component.role.is_closed()).then_some(if volume > 0.0 { 0 } else { -1 })
}

/// Results by indices within the mesh.
struct Findings<'a> {
    welded: &'a Welded,
    edges: &'a Edges,
}

impl Findings<'_> {
    fn diagnosis(&self, measured: Measured, meetings: &Meetings) -> MeshDiagnosis {
        let Self { welded, edges } = *self;
        let corners = &welded.corners;
        MeshDiagnosis {
            triangles: corners.len(),
            vertices: welded.points.len(),
            boundary: faults(edges.boundary.iter().map(|&half| at_edge(welded, half))),
            boundary_loops: loops(corners, welded.points.len(), &edges.boundary),
            inconsistent: faults(edges.inconsistent.iter().map(|&half| at_edge(welded, half))),
            non_manifold: faults(edges.crowded.iter().map(|edge| at_edge(welded, edge[0]))),
            unbalanced: faults(unbalanced(welded, edges)),
            degenerate: faults(degenerate(welded)),
            collinear: faults(measured.collinear.iter().map(|&t| at_triangle(welded, t as usize))),
            duplicates: faults(again(welded, edges, true)),
            back_to_back: faults(again(welded, edges, false)),
            overlaps: overlaps(welded, &meetings.between),
            self_overlaps: overlaps(welded, &meetings.within),
            contacts: overlaps(welded, &meetings.contacts),
            components: measured.components,
            undecided: None,
            unsearched: false,
        }
    }
}

fn faults<P>(mut places: impl Iterator<Item = P>) -> Faults<P> {
    let first = places.next();
    Faults { count: usize::from(first.is_some()) + places.count(), first }
}

fn overlaps(welded: &Welded, overlaps: &Overlaps) -> Faults<PairPlace> {
    Faults { count: overlaps.count, first: overlaps.pairs.first().map(|pair| at_pair(welded, pair)) }
}

/// Returns the edges of more than two triangles that are not traversed equally often in both
/// directions.
pub(super) fn unbalanced<'a>(
    welded: &'a Welded,
    edges: &'a Edges,
) -> impl Iterator<Item = EdgePlace> + use<'a> {
    let unbalanced = edges.crowded.iter().filter(|edge| !is_balanced(&welded.corners, edge));
    unbalanced.map(|edge| at_edge(welded, edge[0]))
}

/// Returns the triangles with two equal corners.
pub(super) fn degenerate(welded: &Welded) -> impl Iterator<Item = TrianglePlace> + '_ {
    let degenerate = (0..welded.corners.len()).filter(|&t| !is_proper(&welded.corners[t]));
    degenerate.map(|t| at_triangle(welded, t))
}

/// Returns the pairs of duplicate triangles with the same or the opposite orientation.
pub(super) fn again<'a>(
    welded: &'a Welded,
    edges: &'a Edges,
    same_way: bool,
) -> impl Iterator<Item = PairPlace> + use<'a> {
    let pairs = edges.duplicates.iter().filter(move |pair| pair.2 == same_way);
    pairs.map(|&(first, second, _)| {
        at_pair(welded, &([first, second], super::inside::centroid(welded.triangle(first as usize))))
    })
}

pub(super) fn at_edge(welded: &Welded, half: u32) -> EdgePlace {
    EdgePlace {
        triangle: half as usize / 3 + 1,
        ends: [start_of(&welded.corners, half), end_of(&welded.corners, half)]
            .map(|v| welded.place(welded.points[v as usize])),
    }
}

pub(super) fn at_triangle(welded: &Welded, t: usize) -> TrianglePlace {
    TrianglePlace { triangle: t + 1, corners: welded.triangle(t).map(|p| welded.place(p)) }
}

pub(super) fn at_pair(welded: &Welded, &([t, u], point): &([u32; 2], [f64; 3])) -> PairPlace {
    PairPlace { triangles: [t as usize + 1, u as usize + 1], point: welded.place(point) }
}

/// Returns the number of loops that half-edges form among `points` points.
fn loops(corners: &[[u32; 3]], points: usize, boundary: &[u32]) -> usize {
    if boundary.is_empty() {
        return 0;
    }
    let mut is_end = vec![false; points];
    let mut parent: Vec<u32> = (0..points as u32).collect();
    for &half in boundary {
        let [start, end] = [start_of(corners, half), end_of(corners, half)];
        (is_end[start as usize], is_end[end as usize]) = (true, true);
        join(&mut parent, start, end);
    }
    (0..).zip(&parent).zip(is_end).filter(|&((v, parent), is_end)| is_end && v == *parent).count()
}
