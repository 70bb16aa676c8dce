//! Where a surface goes through itself.
//!
//! A closed mesh is sound if it winds about no place more than once, or less than not at all. It is, if none of these finds a fault:
//!
//! 1. No two triangles go through each other: where they do, the winding number has three values in the four corners between them. None lie
//!    on each other the same way round.
//! 2. Around each edge of more than two triangles the winding number has two values. So a component has one pair of
//!    values on its two sides wherever nothing else touches it. The edge may lie on further triangles, so that its own do not tell:
//!    they only say which of them overlap (`fan.rs`).
//! 3. Where a corner lies within another triangle or its edge, the winding number is right on both sides of both, next to each edge that
//!    begins there. Other ways to touch need no look: two edges that meet in a point within both either go through the surfaces of each
//!    other, and so do triangles there (1), or one lies on the other's triangles up to its end, a corner (3), or until the surface
//!    bends, and goes through what is on its sides (1).
//! 4. Each component lies in as many others as its kind says (`component.rs`).

use core::ops::ControlFlow;

use super::COUNTED;
use super::edges::{Edges, end_of, opposite, start_of};
use super::fan::overlapping;
use super::inside::{Germ, Windings, centroid};
use super::meeting::Meeting;
use super::predicate::side;
use super::threads::Threads;
use super::tree::Tree;

/// Pairs of triangles where something counts twice: how many, and the first in the mesh's order of those that were looked at, with a point
/// where they meet. One more than are counted stands for any larger number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Overlaps {
    pub(crate) count: usize,
    pub(crate) first: Option<([u32; 2], [f64; 3])>,
}

impl Overlaps {
    fn add(&mut self, triangles: [u32; 2], point: [f64; 3]) {
        self.join(&Self { count: 1, first: Some((triangles, point)) });
    }

    fn join(&mut self, other: &Self) {
        self.count = (self.count + other.count).min(COUNTED + 1);
        self.first = match (self.first, other.first) {
            (Some((t, _)), Some((u, _))) if u < t => other.first,
            (None, _) => other.first,
            _ => self.first,
        };
    }

    fn is_full(&self) -> bool {
        self.count > COUNTED
    }
}

/// What the triangles of a mesh do to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Meetings {
    /// Of different surfaces.
    pub(crate) between: Overlaps,
    /// Of one surface.
    pub(crate) within: Overlaps,
    /// Faces on faces, back to back.
    pub(crate) contacts: Overlaps,
}

impl Meetings {
    /// Of the triangles of a tree, and those about edges. `lowest` is how often a sound mesh winds about what is before its triangles;
    /// `None` if it is not closed.
    pub(crate) fn of(
        windings: &Windings<'_>,
        edges: &Edges,
        tree: &Tree,
        lowest: Option<i32>,
        threads: Threads,
    ) -> Self {
        let mut all = Self::default();
        if let Some(lowest) = lowest {
            let at_edges = threads.map_pieces(edges.crowded.len(), EDGES, |piece| {
                let mut meetings = Self::default();
                edges.crowded[piece].iter().for_each(|edge| meetings.look_around(windings, edge, lowest));
                meetings
            });
            at_edges.iter().for_each(|part| all.join(part));
        }
        let boxes = tree.boxes(windings.welded, threads);
        // Some pieces at once, the same ones for any number of threads: where enough was found, the others are left.
        let mut begin = 0;
        while begin < tree.leaves() && !all.between.is_full() {
            let some = begin..(begin + SOME * LEAVES).min(tree.leaves());
            let parts = threads.map_pieces(some.len(), LEAVES, |leaves| {
                let mut meetings = Self::default();
                tree.pairs(&boxes, some.start + leaves.start..some.start + leaves.end, |t, u| {
                    meetings.look_at(windings, lowest, t.min(u), t.max(u))
                });
                meetings
            });
            parts.iter().for_each(|part| all.join(part));
            begin = some.end;
        }
        all
    }

    fn join(&mut self, other: &Self) {
        self.between.join(&other.between);
        self.within.join(&other.within);
        self.contacts.join(&other.contacts);
    }

    /// The triangles of an edge of more than two.
    fn look_around(&mut self, windings: &Windings<'_>, edge: &[u32], lowest: i32) {
        let Windings { welded, patches, .. } = windings;
        let ends = [start_of(&welded.corners, edge[0]), end_of(&welded.corners, edge[0])];
        let [a, b] = ends.map(|v| welded.points[v as usize]);
        let sound = |half: u32| {
            let tip = welded.points[opposite(&welded.corners, half) as usize];
            windings.is_sound(half as usize / 3, &[a, b, tip], lowest)
        };
        let Some(at) = edge.iter().position(|&half| !sound(half)) else { return };
        let pair = overlapping(welded, patches, edge).unwrap_or_else(|| {
            let other = usize::from(at == 0);
            [edge[at].min(edge[other]) / 3, edge[at].max(edge[other]) / 3]
        });
        self.between.add(pair, core::array::from_fn(|k| 0.5 * (a[k] + b[k])));
    }

    #[inline]
    fn look_at(&mut self, windings: &Windings<'_>, lowest: Option<i32>, t: u32, u: u32) -> ControlFlow<()> {
        let Windings { welded, patches, .. } = windings;
        let [i, j] = [t as usize, u as usize];
        let one_surface = patches.surface(i) == patches.surface(j);
        if one_surface && self.within.is_full() {
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
                let Some(lowest) = lowest else { return ControlFlow::Continue(()) };
                let wrong = |on: [bool; 3], i: usize, j: usize| {
                    (0..3)
                        .find(|&k| on[k] && !is_sound_at(windings, i, k, j, lowest))
                        .map(|k| welded.triangle(i)[k])
                };
                let Some(point) = wrong(of_t, i, j).or_else(|| wrong(of_u, j, i)) else {
                    return ControlFlow::Continue(());
                };
                point
            }
        };
        if one_surface { &mut self.within } else { &mut self.between }.add([t, u], point);
        if self.between.is_full() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Is the winding number right beside a corner of a triangle that lies on another triangle, on both sides of both?
fn is_sound_at(windings: &Windings<'_>, triangle: usize, corner: usize, other: usize, lowest: i32) -> bool {
    let [own, on] = [triangle, other].map(|t| windings.welded.triangle(t));
    let [p, q, r] = [0, 1, 2].map(|k| own[(corner + k) % 3]);
    let sound = |t: usize, germ: Germ| windings.is_sound(t, &germ, lowest);
    // Next to its own edges; and next to whatever may divide the other: its edges in that one's plane, and edges to that one's corners.
    let in_plane = [q, r].into_iter().filter(|&end| side(on, end) == 0.0);
    let mut directions = on.into_iter().chain(in_plane);
    sound(triangle, [p, q, r])
        && sound(triangle, [p, r, q])
        && directions.all(|toward| on.into_iter().all(|beside| sound(other, [p, toward, beside])))
}

/// Edges in a piece of work.
const EDGES: usize = 1 << 10;

/// Leaves in a piece of work, and such pieces at once.
const LEAVES: usize = 1 << 9;
const SOME: usize = 64;
