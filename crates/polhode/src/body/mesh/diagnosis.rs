//! What is right and wrong with a mesh, and where.

use super::TriangleMesh;
use super::component::{Measured, MeshComponent};
use super::edges::{Edges, end_of, start_of};
use super::inside::Windings;
use super::layer::Layers;
use super::overlap::{Meetings, Overlaps};
use super::patches::{Patches, is_balanced, join};
use super::threads::Threads;
use super::tree::Tree;
use super::weld::{NONE, Welded, is_proper};
use super::work::Work;

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
    /// would be needed than this, 300 million and 2,000 for each triangle.
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
        Analysis::of(mesh, Threads::of_machine()).diagnosis
    }

    /// The same on at most so many threads.
    pub fn with_threads(mesh: &TriangleMesh, threads: usize) -> Self {
        Analysis::of(mesh, Threads::of(threads)).diagnosis
    }
}

/// A diagnosis and what it was made of.
#[derive(Debug)]
pub(crate) struct Analysis {
    pub(crate) welded: Welded,
    pub(crate) patches: Patches,
    pub(crate) diagnosis: MeshDiagnosis,
    /// What it took to look for what meets.
    #[cfg(test)]
    pub(super) steps: u64,
}

impl Analysis {
    pub(crate) fn of(mesh: &TriangleMesh, threads: Threads) -> Self {
        Self::within(STEPS + STEPS_EACH * mesh.triangles().len() as u64, mesh, threads)
    }

    /// With so many steps for what is looked for among the triangles.
    pub(super) fn within(steps: u64, mesh: &TriangleMesh, threads: Threads) -> Self {
        let welded = Welded::of(mesh, threads);
        let corners = &welded.corners;
        let edges = Edges::of(corners, welded.points.len(), threads);
        let patches = Patches::of(corners, &edges, threads);
        let mut measured = Measured::of(&welded, &patches);
        // What has no area has no sides, and meets nothing that its neighbours do not meet.
        let has_area =
            |t: usize| patches.component[t] != NONE && measured.collinear.binary_search(&(t as u32)).is_err();
        let tree = Tree::of(&welded, has_area, threads);
        let work = Work::of(steps);
        let windings = Windings { welded: &welded, tree: &tree, patches: &patches, work: &work };
        measured.nest(&windings, threads);
        let meetings = if mesh.is_hull {
            // A corner of many faces has as many pairs as their square, and none of them meet elsewhere.
            Meetings::default()
        } else {
            let layers = Layers::of(&welded, &tree, &edges, &measured.collinear);
            let (mut doubtful, again) = (layers.doubtful(threads), edges.again());
            doubtful.retain(|t| again.binary_search(t).is_err());
            let doubtful = tree.part(&welded, doubtful, threads);
            Meetings::of(&windings, &edges, &doubtful, lowest_winding(&measured.components), threads)
        };
        let undecided = work.is_spent().then_some(steps);
        // What was found until then depends on the threads.
        let meetings = if undecided.is_some() { Meetings::default() } else { meetings };
        let findings = Findings { welded: &welded, edges: &edges };
        let diagnosis = MeshDiagnosis { undecided, ..findings.diagnosis(measured, &meetings) };
        Self {
            welded,
            patches,
            diagnosis,
            #[cfg(test)]
            steps: work.done(),
        }
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
        let (edges, corners) = (self.edges, &self.welded.corners);
        let unbalanced: Vec<_> =
            edges.crowded.iter().filter(|edge| !is_balanced(corners, edge)).map(|edge| edge[0]).collect();
        let crowded: Vec<_> = edges.crowded.iter().map(|edge| edge[0]).collect();
        let degenerate: Vec<_> = (0..corners.len()).filter(|&t| !is_proper(&corners[t])).collect();
        let collinear: Vec<_> = measured.collinear.iter().map(|&t| t as usize).collect();
        MeshDiagnosis {
            triangles: corners.len(),
            vertices: self.welded.points.len(),
            boundary: self.at_edges(&edges.boundary),
            boundary_loops: loops(corners, &edges.boundary),
            inconsistent: self.at_edges(&edges.inconsistent),
            non_manifold: self.at_edges(&crowded),
            unbalanced: self.at_edges(&unbalanced),
            degenerate: self.at_triangles(&degenerate),
            collinear: self.at_triangles(&collinear),
            duplicates: self.pairs(true),
            back_to_back: self.pairs(false),
            overlaps: self.at_pairs(&meetings.between),
            self_overlaps: self.at_pairs(&meetings.within),
            contacts: self.at_pairs(&meetings.contacts),
            components: measured.components,
            undecided: None,
        }
    }

    fn at_edges(&self, halves: &[u32]) -> Faults<EdgePlace> {
        let place = |&half: &u32| EdgePlace {
            triangle: half as usize / 3 + 1,
            ends: [start_of(&self.welded.corners, half), end_of(&self.welded.corners, half)]
                .map(|v| self.welded.place(self.welded.points[v as usize])),
        };
        Faults { count: halves.len(), first: halves.first().map(place) }
    }

    fn at_triangles(&self, triangles: &[usize]) -> Faults<TrianglePlace> {
        let place = |&t: &usize| TrianglePlace {
            triangle: t + 1,
            corners: self.welded.triangle(t).map(|p| self.welded.place(p)),
        };
        Faults { count: triangles.len(), first: triangles.first().map(place) }
    }

    fn pairs(&self, same_way: bool) -> Faults<PairPlace> {
        let mut pairs = self.edges.duplicates.iter().filter(|pair| pair.2 == same_way);
        let place = |&(first, second, _): &(u32, u32, bool)| PairPlace {
            triangles: [first as usize + 1, second as usize + 1],
            point: self.welded.place(super::inside::centroid(self.welded.triangle(first as usize))),
        };
        let first = pairs.next().map(place);
        Faults { count: usize::from(first.is_some()) + pairs.count(), first }
    }

    fn at_pairs(&self, overlaps: &Overlaps) -> Faults<PairPlace> {
        let place = |([t, u], point): ([u32; 2], [f64; 3])| PairPlace {
            triangles: [t as usize + 1, u as usize + 1],
            point: self.welded.place(point),
        };
        Faults { count: overlaps.count, first: overlaps.first.map(place) }
    }
}

/// How many loops half-edges make.
fn loops(corners: &[[u32; 3]], boundary: &[u32]) -> usize {
    let ends = boundary.iter().flat_map(|&half| [start_of(corners, half), end_of(corners, half)]);
    let mut vertices: Vec<u32> = ends.collect();
    vertices.sort_unstable();
    vertices.dedup();
    let number = |vertex: u32| vertices.partition_point(|&v| v < vertex) as u32;
    let mut parent: Vec<u32> = (0..vertices.len() as u32).collect();
    for &half in boundary {
        join(&mut parent, number(start_of(corners, half)), number(end_of(corners, half)));
    }
    (0..).zip(&parent).filter(|(v, parent)| v == *parent).count()
}
