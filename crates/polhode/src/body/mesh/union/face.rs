//! Plane of a triangle, and the intersections of other triangles with it.

use super::super::predicate::{across, facing, side, turn};
use super::super::weld::Welded;
use crate::math::double::Double;

/// A triangle projected along an axis for which its projected area is not zero. It extends from its
/// corner with the smallest x to the one with the largest; the third corner is above them.
///
/// The coordinates computed here are rounded, but each point is a function of its origin only. An
/// edge of the mesh intersects the plane in the same point for all its triangles, so that closed
/// lines remain closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    corners: [[f64; 3]; 3],
    /// Axes of the mesh that are x, y and z here.
    axes: [usize; 3],
    /// Sign of the y axis, 1 or −1.
    up: f64,
    /// Orientation of (x, y) here as seen from the side to which the normal points: 1 if
    /// counter-clockwise, else −1.
    pub(super) turns: i32,
    /// Sign of this orientation relative to that of the coordinates perpendicular to the axis.
    mirrored: f64,
    normal: [Double; 3],
    /// Slope of z with respect to x and y.
    slope: [f64; 2],
    origin: [f64; 3],
    /// The upper corner, and the last one.
    pub(super) top: [f64; 2],
    pub(super) end: [f64; 2],
}

/// A line in a face's plane, with the change of the counts across it, from its right side to its
/// left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    pub(super) rise: Counts,
}

/// Winding numbers just above and just below a place of the face, and the number of earlier
/// triangles that cover it.
pub(super) type Counts = [i32; 3];

impl Face {
    /// Returns the face of a triangle; `None` if its area is rounded to zero.
    pub(super) fn of(corners: [[f64; 3]; 3]) -> Option<Self> {
        let (axis, sign) = facing(corners)?;
        let extent = |k: usize| {
            let all = corners.map(|p| p[k]);
            all[0].max(all[1]).max(all[2]) - all[0].min(all[1]).min(all[2])
        };
        let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
        let (axes, swapped) = if extent(i) >= extent(j) { ([i, j, axis], 1.0) } else { ([j, i, axis], -1.0) };
        let mut by_x = corners;
        by_x.sort_by(|p, q| p[axes[0]].total_cmp(&q[axes[0]]));
        let [origin, top, end] = by_x;
        let flat = |p: [f64; 3], up: f64| [p[axes[0]] - origin[axes[0]], up * (p[axes[1]] - origin[axes[1]])];
        let up = if cross(flat(end, 1.0), flat(top, 1.0)) < 0.0 { -1.0 } else { 1.0 };
        let [top, end] = [top, end].map(|p| flat(p, up));
        if !(cross(end, top) > 0.0 && end[0] > 0.0) {
            return None;
        }
        let mirrored = swapped * up;
        let normal = normal(corners);
        let steepness = |k: usize| -(normal[axes[k]] / normal[axis]).value();
        let slope = [steepness(0), up * steepness(1)];
        if !slope.iter().all(|s| s.is_finite()) {
            return None;
        }
        let turns = if mirrored * sign > 0.0 { 1 } else { -1 };
        Some(Self { corners, axes, up, turns, mirrored, normal, slope, origin, top, end })
    }

    pub(super) fn place(&self, p: [f64; 3]) -> [f64; 2] {
        let [x, y, _] = self.axes;
        [p[x] - self.origin[x], self.up * (p[y] - self.origin[y])]
    }

    /// Returns the vector from the first corner to a point of the plane.
    fn offset(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let mut p = [0.0; 3];
        p[self.axes[0]] = x;
        p[self.axes[1]] = self.up * y;
        p[self.axes[2]] = self.slope[0] * x + self.slope[1] * y;
        p
    }

    /// Returns a point of the plane relative to a reference point.
    pub(super) fn point(&self, at: [f64; 2], reference: [f64; 3]) -> [f64; 3] {
        let p = self.offset(at);
        core::array::from_fn(|k| (self.origin[k] - reference[k]) + p[k])
    }

    /// Returns a point of the plane and the point in the plane at the distance `by` below it (in
    /// −y).
    pub(super) fn below(&self, at: [f64; 2], by: f64) -> [[f64; 3]; 2] {
        [at, [at[0], at[1] - by]].map(|at| self.point(at, [0.0; 3]))
    }

    /// Adds the lines where another triangle crosses the planes just above and just below the face.
    /// If it lies in the face's plane and `is_before` is true, adds its edges instead.
    pub(super) fn cut(&self, welded: &Welded, t: usize, times: i32, is_before: bool, lines: &mut Vec<Line>) {
        let (numbers, points) = (welded.corners[t], welded.triangle(t));
        let signs = points.map(|p| sign(side(self.corners, p)));
        if signs == [0; 3] {
            if is_before {
                self.outline(points, lines);
            }
            return;
        }
        let by = self.turns * times;
        let above = self.section(numbers, points, signs, |s| s > 0);
        let below = self.section(numbers, points, signs, |s| s >= 0);
        let mut add = |section: Option<[[f64; 2]; 2]>, rise: Counts| {
            lines.extend(section.map(|[from, to]| Line { from, to, rise }));
        };
        if signs.contains(&0) {
            add(above, [by, 0, 0]);
            add(below, [0, by, 0]);
        } else {
            add(above, [by, by, 0]);
        }
    }

    /// Adds the edges of a coplanar triangle, if it has an area.
    fn outline(&self, points: [[f64; 3]; 3], lines: &mut Vec<Line>) {
        let axis = self.axes[2];
        let [a, b, c] = points.map(|p| across(axis, p));
        let left = sign(turn(a, b, c) * self.mirrored);
        if left == 0 {
            return;
        }
        let [a, b, c] = points.map(|p| self.place(p));
        lines.extend([[a, b], [b, c], [c, a]].map(|[from, to]| Line { from, to, rise: [0, 0, left] }));
    }

    /// Returns the section of a triangle by a plane, from the edge that goes down through it to the
    /// edge that comes up again. `is_above` classifies the corners by their signs. The inner side
    /// is on the left, seen from the side to which the normal points.
    fn section(
        &self,
        numbers: [u32; 3],
        points: [[f64; 3]; 3],
        signs: [i32; 3],
        is_above: impl Fn(i32) -> bool,
    ) -> Option<[[f64; 2]; 2]> {
        let above = signs.map(is_above);
        let crossing = |goes_down: bool| {
            let k = (0..3).find(|&k| above[k] == goes_down && above[(k + 1) % 3] != goes_down)?;
            let l = (k + 1) % 3;
            let [low, high] = if numbers[k] < numbers[l] { [k, l] } else { [l, k] };
            Some(self.through([points[low], points[high]], [signs[low], signs[high]]))
        };
        Some([crossing(true)?, crossing(false)?])
    }

    /// Returns the point where an edge intersects the plane, given the signs of its ends (above, in
    /// or below the plane).
    fn through(&self, ends: [[f64; 3]; 2], signs: [i32; 2]) -> [f64; 2] {
        let [p, q] = ends.map(|end| self.place(end));
        match signs {
            [0, _] => return p,
            [_, 0] => return q,
            _ => {}
        }
        let [of_p, of_q] = ends.map(|end| self.height(end).abs());
        let part = |height: f64, other: f64| {
            let whole = height + other;
            if whole > 0.0 { height / whole } else { 0.5 }
        };
        let between = |from: [f64; 2], to: [f64; 2], part: f64| {
            let c =
                |k: usize| (from[k] + part * (to[k] - from[k])).clamp(from[k].min(to[k]), from[k].max(to[k]));
            [c(0), c(1)]
        };
        if of_p <= of_q { between(p, q, part(of_p, of_q)) } else { between(q, p, part(of_q, of_p)) }
    }

    /// Returns the height of a point above the plane times the length of the normal. It uses
    /// double-double arithmetic, because the intersections of nearly coincident planes depend on
    /// the last digits.
    fn height(&self, p: [f64; 3]) -> f64 {
        let term = |k: usize| self.normal[k] * Double::sum(p[k], -self.corners[0][k]);
        (term(0) + term(1) + term(2)).value()
    }
}

pub(super) fn cross(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

fn sign(x: f64) -> i32 {
    i32::from(x > 0.0) - i32::from(x < 0.0)
}

/// Returns (b − a) × (c − a) in double-double arithmetic.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [Double; 3] {
    let from = |p: [f64; 3]| -> [Double; 3] { core::array::from_fn(|k| Double::sum(p[k], -a[k])) };
    let (u, v) = (from(b), from(c));
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i])
}
