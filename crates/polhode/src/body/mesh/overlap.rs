//! Self-intersections of a surface, where neither `star.rs` nor `layer.rs` excludes them.
//!
//! A closed mesh is valid if its winding number is 0 or 1 everywhere. This holds if none of these
//! tests finds a fault:
//!
//! 1. No two triangles cross: where they do, the winding number has three values in the four
//!    sectors between them. No two triangles coincide with the same orientation.
//! 2. Around each edge of more than two triangles the winding number has two values. So a component
//!    has one pair of values on its two sides wherever nothing else touches it. The edge may also
//!    lie on other triangles, so that its own triangles are not sufficient for the test; they only
//!    determine which of them overlap (`fan.rs`).
//! 3. Where a corner lies inside another triangle or its edge, the winding number is valid on both
//!    sides of both triangles, next to each edge that starts there. Other contacts need no test.
//!    Two edges that meet in a point inside both either pass through each other's surfaces, and
//!    then triangles cross there (1). Or one edge lies on the other's triangles up to its end, a
//!    corner (3), or up to a bend of the surface, where it crosses the adjacent triangles (1).
//! 4. Each component lies in as many others as its role requires (`component.rs`).

use core::ops::ControlFlow;

use super::edges::{Edges, end_of, start_of};
use super::fan::overlapping;
use super::inside::{Windings, centroid};
use super::meeting::Meeting;
use super::neighborhood::Neighborhoods;
use super::oriented::OrientedTree;
use super::patches::Patches;
use super::predicate::{Plane, side};
use super::sought::Sought;
use super::threads::Threads;
use super::tree::Tree;
use super::umbrella::umbrellas;
use super::weld::Welded;
use super::work::Work;
use crate::body::error::COUNTED;

/// Pairs of triangles where volume counts twice: their number, and each pair with a common point.
/// The number `COUNTED` + 1 stands for any larger number; then not all pairs were examined.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Overlaps {
    pub(crate) count: usize,
    /// Pairs and their common points, in the order of the mesh.
    pub(crate) pairs: Vec<([u32; 2], [f64; 3])>,
}

impl Overlaps {
    fn add(&mut self, triangles: [u32; 2], point: [f64; 3]) {
        self.count = (self.count + 1).min(COUNTED + 1);
        if self.pairs.len() <= COUNTED {
            self.pairs.push((triangles, point));
        }
    }

    fn join(&mut self, other: &Self) {
        self.count = (self.count + other.count).min(COUNTED + 1);
        let room = (COUNTED + 1).saturating_sub(self.pairs.len());
        self.pairs.extend(other.pairs.iter().take(room));
    }

    fn sort(&mut self) {
        self.pairs.sort_by_key(|(triangles, _)| *triangles);
    }

    fn is_full(&self) -> bool {
        self.count > COUNTED
    }
}

/// Intersections between the triangles of a mesh. If only the [first error](Sought::FirstError) is
/// sought, self-intersections of one surface are not searched.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Meetings {
    /// Intersections between different surfaces.
    pub(crate) between: Overlaps,
    /// Intersections within one surface.
    pub(crate) within: Overlaps,
    /// Contacts: faces that touch back to back.
    pub(crate) contacts: Overlaps,
}

impl Meetings {
    /// Finds the intersections of the triangles of a tree, and those at edges. `lowest` is the
    /// winding number of a valid mesh in front of its triangles; `None` if it is not closed. For a
    /// mesh of one surface the search stops when the counting limit is reached.
    ///
    /// If the work is spent before the end, the result is incomplete and depends on the threads.
    pub(crate) fn of(
        windings: &Windings<'_>,
        edges: &Edges,
        tree: &Tree,
        lowest: Option<i32>,
        sought: Sought,
        threads: Threads,
    ) -> Self {
        let mut at_edges = Self::default();
        if let Some(lowest) = lowest {
            for some in edges.crowded.chunks(SOME * EDGES) {
                if at_edges.between.is_full() {
                    break;
                }
                let parts = threads.map_pieces(some.len(), EDGES, |piece| {
                    let (mut meetings, mut beside) = (Self::default(), Neighborhoods::of(windings, lowest));
                    some[piece].iter().for_each(|edge| meetings.look_around(windings, &mut beside, edge));
                    meetings
                });
                parts.iter().for_each(|part| at_edges.join(part));
            }
        }
        let search = Search { windings, lowest, sought, threads, found: at_edges };
        let near = FEW + NEIGHBOURS * tree.order().len() as u64;
        search.by_boxes(tree, near).unwrap_or_else(|| search.by_oriented_boxes(tree))
    }

    fn join(&mut self, other: &Self) {
        self.between.join(&other.between);
        self.within.join(&other.within);
        self.contacts.join(&other.contacts);
    }

    /// Returns true if enough was found to stop the search.
    fn is_full(&self, patches: &Patches) -> bool {
        self.between.is_full() || self.within.is_full() && patches.is_one_surface()
    }

    /// Tests the triangles of an edge of more than two triangles.
    fn look_around(&mut self, windings: &Windings<'_>, beside: &mut Neighborhoods<'_>, edge: &[u32]) {
        let Windings { welded, patches, .. } = windings;
        let [start, end] = [start_of(&welded.corners, edge[0]), end_of(&welded.corners, edge[0])];
        let [a, b] = [start, end].map(|v| welded.points[v as usize]);
        let Some(at) = edge.iter().position(|&half| !beside.is_sound(half / 3, start, end)) else { return };
        let pair = overlapping(welded, patches, edge).unwrap_or_else(|| {
            let other = usize::from(at == 0);
            [edge[at].min(edge[other]) / 3, edge[at].max(edge[other]) / 3]
        });
        self.between.add(pair, core::array::from_fn(|k| 0.5 * (a[k] + b[k])));
    }

    #[inline]
    fn look_at(
        &mut self,
        windings: &Windings<'_>,
        beside: &mut Option<Neighborhoods<'_>>,
        sought: Sought,
        [t, u]: [u32; 2],
    ) -> ControlFlow<()> {
        let Windings { welded, patches, .. } = windings;
        let [i, j] = [t as usize, u as usize];
        let one_surface = patches.surface(i) == patches.surface(j);
        if one_surface && (sought == Sought::FirstError || self.within.is_full()) {
            return ControlFlow::Continue(());
        }
        let meeting = Meeting::of(welded.corners[i], welded.corners[j], |v| welded.points[v as usize]);
        let same_way = patches.against[i] == patches.against[j];
        let point = match meeting {
            Meeting::Apart => return ControlFlow::Continue(()),
            Meeting::Crossing(point) => point,
            Meeting::Overlapping(same) if same == same_way => centroid(welded.triangle(j)),
            Meeting::Overlapping(_) => {
                self.contacts.add([t, u], centroid(welded.triangle(j)));
                return ControlFlow::Continue(());
            }
            Meeting::Touching([of_t, of_u]) => {
                let Some(beside) = beside else { return ControlFlow::Continue(()) };
                let mut wrong = |on: [bool; 3], t: u32, u: u32| {
                    let corner = (0..3).find(|&k| on[k] && !is_sound_at(welded, beside, t, k, u))?;
                    Some(welded.triangle(t as usize)[corner])
                };
                let Some(point) = wrong(of_t, t, u).or_else(|| wrong(of_u, u, t)) else {
                    return ControlFlow::Continue(());
                };
                point
            }
        };
        if one_surface { &mut self.within } else { &mut self.between }.add([t, u], point);
        if self.is_full(patches) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Search for pairs of triangles that intersect. Several pieces are processed at a time, the same
/// ones for any number of threads; when enough was found, the others are skipped.
struct Search<'a> {
    windings: &'a Windings<'a>,
    lowest: Option<i32>,
    sought: Sought,
    threads: Threads,
    /// Intersections found at edges.
    found: Meetings,
}

impl Search<'_> {
    /// Compares triangles whose axis-parallel boxes intersect; `None` if there are more than `near`
    /// such pairs, so that oriented boxes are the better choice.
    fn by_boxes(&self, tree: &Tree, near: u64) -> Option<Meetings> {
        let goes_on = || self.windings.work.goes_on();
        let near = Work::of(near, &goes_on);
        let boxes = tree.boxes(self.windings.welded, self.threads);
        let Windings { welded, patches, .. } = self.windings;
        let planes: Vec<Plane> =
            tree.order().iter().map(|&t| Plane::of(&welded.triangle(t as usize))).collect();
        let surfaces = (self.sought == Sought::FirstError)
            .then(|| tree.alike(|triangle| patches.surface(triangle as usize)));
        let all = self.pieces(tree.leaves().div_ceil(LEAVES), |piece, look_at| {
            let leaves = piece * LEAVES..((piece + 1) * LEAVES).min(tree.leaves());
            let mut pairs = 0;
            tree.pairs(&boxes, surfaces.as_deref(), leaves, |i, j| {
                pairs += 1;
                if pairs % SOME_PAIRS == 0 && !near.take(SOME_PAIRS) {
                    return ControlFlow::Break(());
                }
                let [t, u] = [tree.order()[i], tree.order()[j]];
                if is_beside(welded, &planes[i], t, u) || is_beside(welded, &planes[j], u, t) {
                    return ControlFlow::Continue(());
                }
                look_at(t, u)
            });
            near.take(pairs % SOME_PAIRS);
        });
        (!near.is_spent()).then_some(all)
    }

    /// Compares triangles whose oriented boxes intersect, except those known to be side by side
    /// around a corner.
    fn by_oriented_boxes(&self, tree: &Tree) -> Meetings {
        let Windings { welded, patches, work, .. } = self.windings;
        if work.is_spent() {
            return Meetings::default();
        }
        let umbrellas = umbrellas(welded, tree.order(), &patches.component);
        let tree = OrientedTree::of(welded, tree.order(), &umbrellas);
        let tasks = tree.tasks();
        self.pieces(tasks.len(), |piece, look_at| {
            tree.pairs(tasks[piece], work, |t, u| {
                if work.take(PAIR) { look_at(t, u) } else { ControlFlow::Break(()) }
            });
        })
    }

    fn pieces(
        &self,
        pieces: usize,
        work: impl Fn(usize, &mut dyn FnMut(u32, u32) -> ControlFlow<()>) + Sync,
    ) -> Meetings {
        let mut all = self.found.clone();
        let (mut begin, mut some) = (0, FIRST);
        while begin < pieces && !all.is_full(self.windings.patches) {
            let parts = self.threads.map((pieces - begin).min(some), |piece| {
                let mut meetings = Meetings::default();
                let mut beside = self.lowest.map(|lowest| Neighborhoods::of(self.windings, lowest));
                work(begin + piece, &mut |t, u| {
                    meetings.look_at(self.windings, &mut beside, self.sought, [t.min(u), t.max(u)])
                });
                meetings
            });
            parts.iter().for_each(|part| all.join(part));
            begin += some;
            some = (2 * some).min(SOME);
        }
        [&mut all.between, &mut all.within, &mut all.contacts].into_iter().for_each(Overlaps::sort);
        all
    }
}

/// Returns true if the corners of a triangle that are not those of another one are certainly all on
/// the same side of its plane. Then the triangles do not intersect.
#[inline(always)]
fn is_beside(welded: &Welded, plane: &Plane, triangle: u32, other: u32) -> bool {
    let [p, q, r] = welded.corners[triangle as usize];
    let (mut above, mut below) = (true, true);
    for corner in welded.corners[other as usize] {
        let shared = (corner == p) | (corner == q) | (corner == r);
        let side = plane.certain_side(&welded.points[corner as usize]);
        (above, below) = (above & (shared | (side > 0.0)), below & (shared | (side < 0.0)));
    }
    above | below
}

/// Returns true if the winding numbers next to a corner of a triangle that lies on another triangle
/// are valid, on both sides of both triangles.
fn is_sound_at(
    welded: &Welded,
    beside: &mut Neighborhoods<'_>,
    triangle: u32,
    corner: usize,
    other: u32,
) -> bool {
    let [own, on] = [triangle, other].map(|t| welded.corners[t as usize]);
    let [p, q, r] = [0, 1, 2].map(|k| own[(corner + k) % 3]);
    // Directions: along its own edges, and along whatever may divide the other triangle: its edges
    // in that triangle's plane, and edges to that triangle's corners.
    let plane = welded.triangle(other as usize);
    let in_plane = [q, r].into_iter().filter(|&end| side(plane, welded.points[end as usize]) == 0.0);
    let mut directions = on.into_iter().chain(in_plane);
    beside.is_sound(triangle, p, q)
        && beside.is_sound(triangle, p, r)
        && directions.all(|toward| beside.is_sound(other, p, toward))
}

/// Number of edges in a piece of work.
const EDGES: usize = 1 << 7;

/// Number of leaves in a piece of work, and number of pieces per round: few at first, because
/// widespread faults are found immediately.
const LEAVES: usize = 1 << 9;
const FIRST: usize = 8;
const SOME: usize = 64;

/// Number of pairs with intersecting boxes up to which axis-parallel boxes are used: `FEW` plus
/// `NEIGHBOURS` per triangle.
const FEW: u64 = 1 << 16;
const NEIGHBOURS: u64 = 128;

/// Number of pairs that are charged to the work budget together.
const SOME_PAIRS: u64 = 1 << 8;

/// Cost of comparing two triangles, in visits of a ray.
const PAIR: u64 = 8;

#[cfg(test)]
mod tests;
