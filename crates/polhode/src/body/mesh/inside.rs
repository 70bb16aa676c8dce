//! Winding number of a mesh about a place, computed exactly.
//!
//! Places are adjacent to triangles, infinitesimally near to exactly given points: see [`Germ`].
//! Therefore nothing is rounded, no place lies on an edge, and the result is always defined.

use super::patches::Patches;
use super::predicate::{across, facing, side, turn};
use super::tree::Tree;
use super::weld::{NONE, Welded};
use super::work::Work;

/// Mesh whose triangles can be found by rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Windings<'a> {
    pub(crate) welded: &'a Welded,
    pub(crate) tree: &'a Tree,
    pub(crate) patches: &'a Patches,
    /// Step budget of rays and other searches.
    pub(crate) work: &'a Work<'a>,
}

/// A place in a triangle: at its first point, displaced infinitesimally toward the second point,
/// and from there by a second-order infinitesimal toward the third. The three points lie in the
/// triangle's plane and are not collinear.
///
/// The sign of an affine function there is its sign at the first of the three points where it is
/// not zero.
pub(crate) type Germ = [[f64; 3]; 3];

/// Components that contain a given component.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Nesting {
    /// Number of closed components that contain it.
    pub(crate) depth: usize,
    /// Smallest of these components.
    pub(crate) inside: Option<usize>,
}

/// Triangle that a ray passes through.
struct Hit {
    triangle: usize,
    /// True if it is coplanar with the triangle where the ray starts, and contains the start.
    coplanar: bool,
    /// True if its normal points along the ray.
    along: bool,
}

impl Windings<'_> {
    /// Returns the closed components that contain the component of `triangle`, as seen from the
    /// inner side of that triangle. `volume` returns the volumes of components, negative if
    /// oriented inward.
    ///
    /// A component that encloses that side and does not intersect this component contains it if it
    /// is larger. A solid may fill a cavity.
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
        // A point is inside a component that the ray meets an odd number of times.
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

    /// Returns the winding numbers of a closed mesh just in front of a triangle and just behind it,
    /// at its first corner. `times` is the multiplicity of each triangle. `None` if the triangle
    /// has no area.
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

    /// Returns an axis along which a triangle has projected area, and true if its outer side faces
    /// along the axis.
    fn facing(&self, triangle: usize) -> Option<(usize, bool)> {
        let (axis, sign) = facing(self.welded.triangle(triangle))?;
        Some((axis, (sign > 0.0) != self.patches.against[triangle]))
    }

    /// Calls `hit` for all triangles that the ray from a germ along an axis passes through,
    /// including those that contain the germ.
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
            // Ahead of the germ: the germ is behind the plane if its normal points along the ray,
            // in front of it otherwise.
            if height == 0.0 || (height < 0.0) == left {
                hit(Hit { triangle: t, coplanar: height == 0.0, along: left });
            }
        });
        self.work.take(visits);
    }
}

/// Returns the winding number of a closed mesh about a point that is not on it, in scaled units.
pub(crate) fn winding(welded: &Welded, tree: &Tree, point: [f64; 3]) -> i32 {
    const AXIS: usize = 2;
    let mut winding = 0;
    tree.along(welded, point, AXIS, |t| {
        let triangle = welded.triangle(t as usize);
        if is_seen_at(triangle, AXIS, across(AXIS, point)) {
            let [a, b, c] = triangle.map(|p| across(AXIS, p));
            let along = turn(a, b, c) > 0.0;
            // The point is behind the plane if the normal points along the ray.
            if (side(triangle, point) < 0.0) == along {
                winding += if along { 1 } else { -1 };
            }
        }
    });
    winding
}

/// Relative tolerance within which two volumes count as equal, to allow for rounding.
const SAME: f64 = 1e-12;

/// Returns the direction in which the line through a germ along an axis crosses a triangle: true if
/// its normal points along the axis, false if against it. `None` if the line does not meet the
/// triangle.
///
/// If the projections of the germ's three points are not collinear, the line meets no edges except
/// those whose projection is a point.
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

/// Returns true if the line along an axis through a point of the perpendicular plane meets the
/// triangle.
///
/// The line is displaced from the point by an infinitesimal ε along the next axis and ε² along the
/// one after it. So it never meets an edge, and of the two triangles at an edge it meets exactly
/// one.
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
