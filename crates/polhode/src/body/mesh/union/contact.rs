//! Search for triangles that have only corners and edges in common with others.

use core::ops::ControlFlow;

use super::super::layer::Layers;
use super::super::meeting::Meeting;
use super::super::predicate::{across, facing, side, turn};
use super::super::threads::Threads;
use super::super::tree::Tree;
use super::super::weld::Welded;
use super::super::work::Work;
use super::weighted::Weighted;

/// Returns for each triangle true if another one may intersect it beyond their common corners and
/// edges. The result may be true in near misses, but it is always true for an intersection, except
/// at points.
///
/// If neither of the two triangles of an edge is intersected, nothing lies on the edge, and the
/// winding numbers on both of their outer sides are equal.
pub(super) fn met(
    mesh: &Weighted,
    tree: &Tree,
    collinear: &[u32],
    work: &Work<'_>,
    threads: Threads,
) -> Vec<bool> {
    let welded = &mesh.welded;
    let mut met = vec![false; welded.corners.len()];
    let doubtful = Layers::of(welded, tree, &mesh.edges, |_| false, collinear).doubtful(work, threads);
    let doubtful = tree.part(welded, doubtful, threads);
    let boxes = doubtful.boxes(welded, threads);
    let found = threads.map_pieces(doubtful.leaves(), LEAVES, |leaves| {
        let mut found = Vec::new();
        doubtful.pairs(&boxes, None, leaves, |i, j| {
            let [t, u] = [doubtful.order()[i], doubtful.order()[j]];
            if !work.take(PAIR) {
                return ControlFlow::Break(());
            }
            if may_meet(welded, t, u) {
                found.extend([t, u]);
            }
            ControlFlow::Continue(())
        });
        found.sort_unstable();
        found.dedup();
        found
    });
    found.into_iter().flatten().for_each(|t| met[t as usize] = true);
    met
}

/// Number of leaves in a piece of work.
const LEAVES: usize = 1 << 9;

/// Cost of comparing two triangles, in visits of a ray.
const PAIR: u64 = 4;

/// Tests two different triangles, each with an area.
fn may_meet(welded: &Welded, t: u32, u: u32) -> bool {
    let [own, other] = [t, u].map(|t| welded.corners[t as usize]);
    let [a, b] = [t, u].map(|t| welded.triangle(t as usize));
    let shared = |v: [u32; 3], w: [u32; 3]| v.map(|corner| w.contains(&corner));
    let (of_t, of_u) = (Corners::beside(b, a, shared(own, other)), Corners::beside(a, b, shared(other, own)));
    if of_t.are_apart() || of_u.are_apart() {
        return false;
    }
    let is_coplanar = of_u.heights == [0.0; 3];
    if !is_coplanar && of_u.shared.iter().filter(|&&shared| shared).count() == 2 {
        return false; // they share an edge and therefore nothing else
    }
    if is_coplanar || !of_t.touch() && !of_u.touch() {
        return Meeting::of(own, other, |v| welded.points[v as usize]) != Meeting::Apart;
    }
    !(of_t.touch_beside(b) || of_u.touch_beside(a))
}

/// Corners of a triangle relative to the plane of another.
struct Corners {
    points: [[f64; 3]; 3],
    heights: [f64; 3],
    /// Corners that the other triangle shares.
    shared: [bool; 3],
}

impl Corners {
    fn beside(plane: [[f64; 3]; 3], points: [[f64; 3]; 3], shared: [bool; 3]) -> Self {
        let height = |k: usize| if shared[k] { 0.0 } else { side(plane, points[k]) };
        Self { points, heights: [0, 1, 2].map(height), shared }
    }

    /// Returns true if all corners that are not shared lie on one side of the plane.
    fn are_apart(&self) -> bool {
        let all = |so: fn(f64) -> bool| (0..3).all(|k| self.shared[k] || so(self.heights[k]));
        all(|h| h > 0.0) || all(|h| h < 0.0)
    }

    /// Returns true if a corner that is not shared lies in the plane.
    fn touch(&self) -> bool {
        (0..3).any(|k| !self.shared[k] && self.heights[k] == 0.0)
    }

    /// Returns true if the triangle lies on one side of the plane, and its corners in the plane are
    /// beyond an edge of the other triangle, except for a shared corner on that edge.
    fn touch_beside(&self, other: [[f64; 3]; 3]) -> bool {
        if self.heights.iter().any(|&h| h > 0.0) && self.heights.iter().any(|&h| h < 0.0) {
            return false;
        }
        let Some((axis, sign)) = facing(other) else { return false };
        let other = other.map(|p| across(axis, p));
        (0..3).any(|edge| {
            let inward = |p: [f64; 3]| sign * turn(other[edge], other[(edge + 1) % 3], across(axis, p));
            (0..3).all(|k| {
                let height = inward(self.points[k]);
                self.heights[k] != 0.0 || height < 0.0 || self.shared[k] && height == 0.0
            })
        })
    }
}
