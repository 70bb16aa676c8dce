//! Inside and outside: how often a mesh winds about a point.

use super::patches::Patches;
use super::predicate::{across, facing, side, turn};
use super::tree::Tree;
use super::weld::{NONE, Welded};

/// A mesh whose triangles can be found by rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Windings<'a> {
    pub(crate) welded: &'a Welded,
    pub(crate) tree: &'a Tree,
    pub(crate) patches: &'a Patches,
}

/// Which components are about a component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Nesting {
    /// How many closed components it lies in.
    pub(crate) depth: usize,
    /// The smallest of them.
    pub(crate) inside: Option<usize>,
}

impl Windings<'_> {
    /// How often the mesh winds about what is just behind a triangle, where it is at this point of it, each component wound as most of it
    /// is; `None` where another triangle lies on the point.
    pub(crate) fn behind(&self, triangle: usize, point: [f64; 3]) -> Option<i32> {
        let (axis, facing) = self.facing(triangle)?;
        let mut winding = i32::from(facing > 0.0);
        let clear = self.hits(triangle, axis, point, |_, leaving| winding += if leaving { 1 } else { -1 });
        clear.then_some(winding)
    }

    /// Which of the closed components are about this one, seen from one of its triangles; `None` where the triangle lies on another.
    pub(crate) fn nesting(&self, triangle: usize, volume: impl Fn(usize) -> Option<f64>) -> Option<Nesting> {
        let (axis, _) = self.facing(triangle)?;
        let own = self.patches.component[triangle];
        let mut hits = Vec::new();
        let point = centroid(self.welded.triangle(triangle));
        let clear = self.hits(triangle, axis, point, |t, _| hits.push(self.patches.component[t]));
        hits.retain(|&component| component != own && component != NONE);
        hits.sort_unstable();
        // Inside what the ray meets an odd number of times.
        let odd = hits.chunk_by(|a, b| a == b).filter(|hits| hits.len() % 2 == 1);
        let around = odd.filter_map(|hits| volume(hits[0] as usize).map(|v| (v.abs(), hits[0] as usize)));
        let (mut nesting, mut smallest) = (Nesting::default(), f64::INFINITY);
        for (volume, component) in around {
            nesting.depth += 1;
            if volume < smallest {
                (smallest, nesting.inside) = (volume, Some(component));
            }
        }
        clear.then_some(nesting)
    }

    fn facing(&self, triangle: usize) -> Option<(usize, f64)> {
        let (axis, sign) = facing(self.welded.triangle(triangle))?;
        Some((axis, if self.patches.against[triangle] { -sign } else { sign }))
    }

    /// Calls `hit` for all triangles but one that the ray from a point along an axis goes through; true if that is where they are left
    /// by what is inside. False if the point lies on one of them.
    fn hits(&self, but: usize, axis: usize, point: [f64; 3], mut hit: impl FnMut(usize, bool)) -> bool {
        let mut clear = true;
        self.tree.along(self.welded, point, axis, |t| {
            let t = t as usize;
            let triangle = self.welded.triangle(t);
            if t == but {
                return;
            }
            let Some(left) = seen_at(triangle, axis, across(axis, point)) else { return };
            let height = side(triangle, point);
            clear &= height != 0.0;
            // Ahead of the point: behind the plane if its normal points along the ray, before it if against.
            if (height < 0.0) == left && height != 0.0 {
                hit(t, left != self.patches.against[t]);
            }
        });
        clear
    }
}

/// Does the line along an axis through a point of the plane across it meet the triangle? If so, whether its normal points along it.
///
/// The line runs beside the point, by an infinitely small ε along the next axis and ε² along the one after that: it never meets an edge,
/// and meets one of the two triangles at each.
pub(crate) fn seen_at(triangle: [[f64; 3]; 3], axis: usize, q: [f64; 2]) -> Option<bool> {
    let turned = |a: [f64; 2], b: [f64; 2]| {
        let turn = turn(a, b, q);
        let beside = if a[1] == b[1] { b[0] - a[0] } else { a[1] - b[1] };
        if turn == 0.0 { beside } else { turn }
    };
    let [a, b, c] = triangle.map(|p| across(axis, p));
    let turns = [turned(a, b), turned(b, c), turned(c, a)];
    let (left, right) = (turns.iter().all(|&s| s > 0.0), turns.iter().all(|&s| s < 0.0));
    (left || right).then_some(left)
}

pub(crate) fn centroid([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    core::array::from_fn(|k| (a[k] + b[k] + c[k]) / 3.0)
}
