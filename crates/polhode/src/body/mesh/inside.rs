//! Inside and outside: how often a mesh winds about a place, exactly.
//!
//! Places are beside triangles, infinitely near to points that are given exactly: a [`Germ`]. So nothing is rounded, no place lies on an
//! edge, and there is always an answer.

use super::patches::Patches;
use super::predicate::{across, facing, side, turn};
use super::tree::Tree;
use super::weld::{NONE, Welded};
use super::work::Work;

/// A mesh whose triangles can be found by rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Windings<'a> {
    pub(crate) welded: &'a Welded,
    pub(crate) tree: &'a Tree,
    pub(crate) patches: &'a Patches,
    /// What rays may cost, and whatever else is looked for.
    pub(crate) work: &'a Work<'a>,
}

/// A place in a triangle: from its first point infinitely little toward the second, and from there infinitely less toward the third. The
/// three lie in the triangle's plane, and on no line.
///
/// What is affine has the sign there that it has at the first of the points where it is not zero.
pub(crate) type Germ = [[f64; 3]; 3];

/// Which components are about a component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Nesting {
    /// How many closed components it lies in.
    pub(crate) depth: usize,
    /// The smallest of them.
    pub(crate) inside: Option<usize>,
}

/// A triangle that a ray goes through.
struct Hit {
    triangle: usize,
    /// It lies on the triangle that the ray begins at.
    coplanar: bool,
    /// Its normal points along the ray.
    along: bool,
}

impl Windings<'_> {
    /// Which of the closed components are about this one, by the volumes of components, negative if wound inward: seen from the side of one
    /// of its triangles that it encloses.
    ///
    /// What encloses that too, and does not go through it, is about it if it is larger. A solid may fill a cavity.
    pub(crate) fn nesting(&self, triangle: usize, volume: impl Fn(usize) -> Option<f64>) -> Nesting {
        let own = self.patches.component[triangle];
        let (Some((axis, along)), Some(own_volume)) = (self.facing(triangle), volume(own as usize)) else {
            return Nesting::default();
        };
        let outward = own_volume > 0.0;
        let mut hits = Vec::new();
        self.hits(axis, &self.welded.triangle(triangle), |hit| {
            let component = self.patches.component[hit.triangle];
            if component != own && component != NONE && (!hit.coplanar || along == outward) {
                hits.push(component);
            }
        });
        hits.sort_unstable();
        let is_larger = |v: f64| {
            let same = if outward && v < 0.0 { -SAME } else { SAME };
            v.abs() > own_volume.abs() * (1.0 + same)
        };
        // Inside what the ray meets an odd number of times.
        let odd = hits.chunk_by(|a, b| a == b).filter(|hits| hits.len() % 2 == 1);
        let around = odd.filter_map(|hits| volume(hits[0] as usize).map(|v| (v, hits[0] as usize)));
        let (mut nesting, mut smallest) = (Nesting::default(), f64::INFINITY);
        for (volume, component) in around.filter(|around| is_larger(around.0)) {
            nesting.depth += 1;
            if volume.abs() < smallest {
                (smallest, nesting.inside) = (volume.abs(), Some(component));
            }
        }
        nesting
    }

    /// How often a closed mesh winds about what is just before a triangle and just behind it, at its first corner, where each triangle counts
    /// as often as it is there; `None` if the triangle has no area.
    pub(crate) fn beside(&self, triangle: usize, times: impl Fn(usize) -> i32) -> Option<[i32; 2]> {
        let germ = self.welded.triangle(triangle);
        let (axis, sign) = facing(germ)?;
        let (mut ahead, mut coplanar) = (0, 0);
        self.hits(axis, &germ, |hit| {
            let step = if hit.along { times(hit.triangle) } else { -times(hit.triangle) };
            if hit.coplanar { coplanar += step } else { ahead += step }
        });
        Some(if sign > 0.0 { [ahead, ahead + coplanar] } else { [ahead + coplanar, ahead] })
    }

    /// An axis along which a triangle is seen, and whether its outer side faces along it.
    fn facing(&self, triangle: usize) -> Option<(usize, bool)> {
        let (axis, sign) = facing(self.welded.triangle(triangle))?;
        Some((axis, (sign > 0.0) != self.patches.against[triangle]))
    }

    /// Calls `hit` for all triangles that the ray from a germ along an axis goes through, those that the germ lies on among them.
    fn hits(&self, axis: usize, germ: &Germ, mut hit: impl FnMut(Hit)) {
        if self.work.is_spent() {
            return;
        }
        let mut visits = 0;
        self.tree.along(self.welded, germ[0], axis, |t| {
            visits += 1;
            let t = t as usize;
            let triangle = self.welded.triangle(t);
            let Some(left) = seen_at(triangle, axis, germ) else { return };
            let height = first_sign(germ.iter().map(|&p| side(triangle, p)));
            // Ahead of the germ: behind the plane if its normal points along the ray, before it if against.
            if height == 0.0 || (height < 0.0) == left {
                hit(Hit { triangle: t, coplanar: height == 0.0, along: left });
            }
        });
        self.work.take(visits);
    }
}

/// Volumes that differ by no larger part are the same, but for rounding.
const SAME: f64 = 1e-12;

/// Does the line along an axis through a germ meet the triangle? If so, whether its normal points along it.
///
/// It meets no edge, but for those that are seen as points, if the germ's three points are not seen on a line.
fn seen_at(triangle: [[f64; 3]; 3], axis: usize, germ: &Germ) -> Option<bool> {
    let [a, b, c] = triangle.map(|p| across(axis, p));
    let turned = |a, b| first_sign(germ.iter().map(|&p| turn(a, b, across(axis, p))));
    let turns = [turned(a, b), turned(b, c), turned(c, a)];
    let (left, right) = (turns.iter().all(|&s| s > 0.0), turns.iter().all(|&s| s < 0.0));
    (left || right).then_some(left)
}

pub(crate) fn first_sign(mut values: impl Iterator<Item = f64>) -> f64 {
    values.find(|&value| value != 0.0).unwrap_or(0.0)
}

/// Does the line along an axis through a point of the plane across it meet the triangle?
///
/// The line runs beside the point, by an infinitely small ε along the next axis and ε² along the one after that: it never meets an edge,
/// and meets one of the two triangles at each.
pub(crate) fn is_seen_at(triangle: [[f64; 3]; 3], axis: usize, q: [f64; 2]) -> bool {
    let turned = |a: [f64; 2], b: [f64; 2]| {
        let turn = turn(a, b, q);
        let beside = if a[1] == b[1] { b[0] - a[0] } else { a[1] - b[1] };
        if turn == 0.0 { beside } else { turn }
    };
    let [a, b, c] = triangle.map(|p| across(axis, p));
    let turns = [turned(a, b), turned(b, c), turned(c, a)];
    turns.iter().all(|&s| s > 0.0) || turns.iter().all(|&s| s < 0.0)
}

pub(crate) fn centroid([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    core::array::from_fn(|k| (a[k] + b[k] + c[k]) / 3.0)
}
