//! Where a surface goes through itself.

use super::inside::{Windings, centroid};
use super::meeting::Meeting;
use super::threads::Threads;
use super::tree::Tree;

/// Pairs of triangles where something counts twice: how many, and the first in the mesh's order with a point where they meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Overlaps {
    pub(crate) count: usize,
    pub(crate) first: Option<([u32; 2], [f64; 3])>,
}

impl Overlaps {
    fn add(&mut self, triangles: [u32; 2], point: [f64; 3]) {
        self.count += 1;
        self.first = earlier(self.first, Some((triangles, point)));
    }

    fn join(&mut self, other: &Self) {
        self.count += other.count;
        self.first = earlier(self.first, other.first);
    }
}

type Place = Option<([u32; 2], [f64; 3])>;

fn earlier(a: Place, b: Place) -> Place {
    match (a, b) {
        (Some((t, _)), Some((u, _))) if u < t => b,
        (None, _) => b,
        _ => a,
    }
}

/// What the triangles of a mesh do to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Meetings {
    /// Of different components.
    pub(crate) between: Overlaps,
    /// Of one component.
    pub(crate) within: Overlaps,
    /// Faces on faces, back to back.
    pub(crate) contacts: Overlaps,
}

impl Meetings {
    /// Of the triangles of a tree. `inner` is how often a sound mesh winds about what is just behind its triangles; `None` if it is not
    /// closed.
    pub(crate) fn of(windings: &Windings<'_>, tree: &Tree, inner: Option<i32>, threads: Threads) -> Self {
        let boxes = tree.boxes(windings.welded, threads);
        let parts = threads.map_pieces(tree.leaves(), LEAVES, |leaves| {
            let mut meetings = Self::default();
            tree.pairs(&boxes, leaves, |t, u| meetings.look_at(windings, inner, t.min(u), t.max(u)));
            meetings
        });
        let mut all = Self::default();
        for part in &parts {
            all.between.join(&part.between);
            all.within.join(&part.within);
            all.contacts.join(&part.contacts);
        }
        all
    }

    #[inline]
    fn look_at(&mut self, windings: &Windings<'_>, inner: Option<i32>, t: u32, u: u32) {
        let Windings { welded, patches, .. } = windings;
        let [i, j] = [t as usize, u as usize];
        let meeting = Meeting::of(welded.corners[i], welded.corners[j], |v| welded.points[v as usize]);
        let same_way = patches.against[i] == patches.against[j];
        let point = match meeting {
            Meeting::Apart => return,
            Meeting::Crossing(point) => point,
            Meeting::Overlapping(same) if same == same_way => centroid(welded.triangle(j)),
            Meeting::Overlapping(_) => {
                return self.contacts.add([t, u], centroid(welded.triangle(j)));
            }
            // Does the one go on beyond the other, or do they only touch? Beside the point the mesh winds too often if it does.
            Meeting::Touching(point) => {
                let wrong = |t: usize| {
                    let triangle = welded.triangle(t);
                    let middle = centroid(triangle);
                    triangle.iter().any(|corner| {
                        let beside = core::array::from_fn(|k| {
                            point[k] + BESIDE * (0.5 * (middle[k] + corner[k]) - point[k])
                        });
                        windings.behind(t, beside).is_some_and(|winding| Some(winding) != inner)
                    })
                };
                if inner.is_none() || !(wrong(i) || wrong(j)) {
                    return;
                }
                point
            }
        };
        let list =
            if patches.component[i] == patches.component[j] { &mut self.within } else { &mut self.between };
        list.add([t, u], point);
    }
}

/// So much of the way from a point where a triangle touches another, into it and toward each of its corners.
const BESIDE: f64 = 0.0625;

/// Leaves in a piece of work.
const LEAVES: usize = 1 << 10;
