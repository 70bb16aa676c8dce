//! What is right and wrong with a mesh, and where.

use super::TriangleMesh;
use super::component::{Measured, MeshComponent};
use super::edges::{Edges, end_of, start_of};
use super::inside::Windings;
use super::layer::Layers;
use super::overlap::{Meetings, Overlaps};
use super::patches::{Patches, is_balanced, join};
use super::sought::Sought;
use super::threads::Threads;
use super::tree::Tree;
use super::weld::{NONE, Welded, is_proper};
use super::work::{GoesOn, Work};

/// What is right and wrong with a mesh, and where: everything that [`ClosedMesh`](crate::body::mesh::ClosedMesh) refuses, corrects or mentions.
///
/// Corners are the same vertex when their coordinates are equal, exactly, and whether triangles cross is decided by exact signs: there is
/// no tolerance. The numbers are the same for any number of threads. Time and memory go with the triangles, and with the pairs of them
/// that are near each other; of those that overlap no more are looked at than are counted. Of triangles that are there again, the same way
/// round, only one is compared with others.
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
    /// Triangles given.
    pub triangles: usize,
    /// Different corners of them.
    pub vertices: usize,
    /// Edges of one triangle: here the mesh is open.
    pub boundary: Faults<EdgePlace>,
    /// Loops that these edges make; where two of them meet in a vertex they count as one.
    pub boundary_loops: usize,
    /// Edges whose two triangles run along them the same way.
    pub inconsistent: Faults<EdgePlace>,
    /// Edges of more than two triangles: where bodies touch along an edge, there are four.
    pub non_manifold: Faults<EdgePlace>,
    /// Those among them that are not run along as often one way as the other.
    pub unbalanced: Faults<EdgePlace>,
    /// Triangles with two equal corners.
    pub degenerate: Faults<TrianglePlace>,
    /// Triangles with three different corners on one line: a seam, and no defect.
    pub collinear: Faults<TrianglePlace>,
    /// Triangles that are there again, the same way round.
    pub duplicates: Faults<PairPlace>,
    /// Triangles that are there again, the other way round: a wall without thickness, or where two bodies touch.
    pub back_to_back: Faults<PairPlace>,
    /// Pairs of triangles that cross, or that show that bodies overlap, of surfaces that do not hang together but by edges of more than two
    /// triangles. Of these and the next two 10,000 are counted: 10,001 stands for any larger number.
    pub overlaps: Faults<PairPlace>,
    /// Pairs of triangles of one surface that do.
    pub self_overlaps: Faults<PairPlace>,
    /// Pairs of faces that lie on each other, back to back, but are not the same triangle: where bodies touch.
    pub contacts: Faults<PairPlace>,
    /// Parts that hang together by their edges, by their first triangles.
    pub components: Vec<MeshComponent>,
    /// So many triangles are so near each other that it was not found out which of them overlap, and which parts lie in which: more steps
    /// would be needed than this, 300 million and 2,000 for each triangle, or those until it was ended.
    pub undecided: Option<u64>,
}

/// How often something was found, and the first in the mesh's order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults<P> {
    /// How often.
    pub count: usize,
    /// Where first; of more than are counted, where first of those.
    pub first: Option<P>,
}

impl<P> Faults<P> {
    /// Found nowhere?
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl<P> Default for Faults<P> {
    fn default() -> Self {
        Self { count: 0, first: None }
    }
}

/// An edge of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePlace {
    /// The triangle, from 1.
    pub triangle: usize,
    /// The ends of its edge, m.
    pub ends: [[f64; 3]; 2],
}

/// A triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrianglePlace {
    /// The triangle, from 1.
    pub triangle: usize,
    /// Its corners, m.
    pub corners: [[f64; 3]; 3],
}

/// Two triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairPlace {
    /// The triangles, from 1, ascending.
    pub triangles: [usize; 2],
    /// A point that they have in common, m, rounded.
    pub point: [f64; 3],
}

impl MeshDiagnosis {
    /// What is right and wrong with the mesh; on all threads of the machine.
    pub fn of(mesh: &TriangleMesh) -> Self {
        Analysis::of(mesh, Sought::All, Threads::of_machine(), &|| true).diagnosis
    }

    /// The same on at most so many threads.
    pub fn with_threads(mesh: &TriangleMesh, threads: usize) -> Self {
        Analysis::of(mesh, Sought::All, Threads::of(threads), &|| true).diagnosis
    }
}

/// A diagnosis and what it was made of.
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

    /// With so much work for what is looked for among the triangles.
    pub(super) fn within(work: &Work<'_>, mesh: &TriangleMesh, sought: Sought, threads: Threads) -> Self {
        let welded = Welded::of(mesh, threads);
        let corners = &welded.corners;
        let edges = Edges::of(corners, welded.points.len(), threads);
        // What is open or there twice bounds nothing, whatever meets.
        let is_torn = !edges.boundary.is_empty() || edges.duplicates.iter().any(|&(_, _, same_way)| same_way);
        if sought == Sought::FirstError && is_torn {
            let (patches, meetings) = (Patches::default(), Meetings::default());
            let diagnosis =
                Findings { welded: &welded, edges: &edges }.diagnosis(Measured::default(), &meetings);
            return Self { welded, patches, edges, meetings, diagnosis };
        }
        let patches = Patches::of(corners, &edges, threads);
        let mut measured = Measured::of(&welded, &patches, threads);
        // What has no area has no sides, and meets nothing that its neighbours do not meet.
        let has_area =
            |t: usize| patches.component[t] != NONE && measured.collinear.binary_search(&(t as u32)).is_err();
        // Neither does what is wound both ways; and one surface without edges of more than two triangles meets none but itself, which
        // is a remark.
        let is_one = measured.components.len() == 1 && edges.crowded.is_empty();
        let is_known = sought == Sought::FirstError
            && (is_one || measured.components.iter().any(|component| !component.role.is_closed()));
        let tree = Tree::of(&welded, |t| !is_known && has_area(t), threads);
        let windings = Windings { welded: &welded, tree: &tree, patches: &patches, work };
        if !is_known {
            measured.nest(&windings, threads);
        }
        let meetings = if mesh.is_hull || is_known || !work.goes_on() {
            // A corner of many faces of a hull has as many pairs as their square, and none of them meet elsewhere.
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
            let layers = Layers::of(&welded, once, &edges, |t| is_again[t as usize], &measured.collinear);
            let doubtful = layers.doubtful(work, threads);
            let some = (doubtful.len() < once.order().len()).then(|| once.part(&welded, doubtful, threads));
            let doubtful = some.as_ref().unwrap_or(once);
            Meetings::of(&windings, &edges, doubtful, lowest_winding(&measured.components), sought, threads)
        };
        let undecided = work.not_enough();
        // What was found until then depends on the threads.
        let meetings = if undecided.is_some() { Meetings::default() } else { meetings };
        let findings = Findings { welded: &welded, edges: &edges };
        let diagnosis = MeshDiagnosis { undecided, ..findings.diagnosis(measured, &meetings) };
        Self { welded, patches, edges, meetings, diagnosis }
    }
}

/// Steps for a mesh, and more for each of its triangles: most are visits of a line at a triangle. Walls of touching bricks take some 400 for
/// each.
const STEPS: u64 = 300_000_000;
const STEPS_EACH: u64 = 2_000;

/// How often a sound mesh winds about what is before its triangles: not at all, or, if all of it is wound inward, −1 times.
fn lowest_winding(components: &[MeshComponent]) -> Option<i32> {
    let volume: f64 = components.iter().map(|component| component.volume).sum();
    components.iter().all(|component| component.role.is_closed()).then_some(if volume > 0.0 { 0 } else { -1 })
}

/// What was found, by numbers within the mesh.
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

/// Edges of more than two triangles that are not run along as often one way as the other.
pub(super) fn unbalanced<'a>(
    welded: &'a Welded,
    edges: &'a Edges,
) -> impl Iterator<Item = EdgePlace> + use<'a> {
    let unbalanced = edges.crowded.iter().filter(|edge| !is_balanced(&welded.corners, edge));
    unbalanced.map(|edge| at_edge(welded, edge[0]))
}

/// Triangles with two equal corners.
pub(super) fn degenerate(welded: &Welded) -> impl Iterator<Item = TrianglePlace> + '_ {
    let degenerate = (0..welded.corners.len()).filter(|&t| !is_proper(&welded.corners[t]));
    degenerate.map(|t| at_triangle(welded, t))
}

/// Triangles that are there again, the same way round or the other.
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

/// How many loops half-edges make between so many points.
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
