//! The plane of a triangle, and what others have in it.

use super::super::predicate::{across, facing, side, turn};
use super::super::weld::Welded;
use crate::math::double::Double;

/// A triangle seen along an axis across which it has an area: from its corner with the least x to the one with the largest, the third one above
/// them.
///
/// What is computed here is rounded, but each point as a function of where it comes from: an edge of the mesh goes through the plane in one
/// point for all its triangles, and so what is closed stays closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    corners: [[f64; 3]; 3],
    /// The axes that are x, y and z here.
    axes: [usize; 3],
    /// 1 or −1: y here, for what is y.
    up: f64,
    /// 1 if x and y as they are here turn as seen from where the normal points, else −1.
    pub(super) turns: i32,
    /// −1 if they turn the other way than the coordinates across the axis.
    mirrored: f64,
    normal: [Double; 3],
    /// By how much z rises with x and y.
    slope: [f64; 2],
    origin: [f64; 3],
    /// The corner above, and the last one.
    pub(super) top: [f64; 2],
    pub(super) end: [f64; 2],
}

/// A line in a face's plane, and by how much what is counted rises where it is crossed: by so much for what is on the left of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    pub(super) rise: Counts,
}

/// How often the mesh winds about what is just above and just below a place of the face, and how many triangles before this one lie there.
pub(super) type Counts = [i32; 3];

impl Face {
    /// `None` of a triangle whose area is rounded to none.
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

    /// From the first corner.
    fn offset(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let mut p = [0.0; 3];
        p[self.axes[0]] = x;
        p[self.axes[1]] = self.up * y;
        p[self.axes[2]] = self.slope[0] * x + self.slope[1] * y;
        p
    }

    /// A point of the plane, from a reference.
    pub(super) fn point(&self, at: [f64; 2], reference: [f64; 3]) -> [f64; 3] {
        let p = self.offset(at);
        core::array::from_fn(|k| (self.origin[k] - reference[k]) + p[k])
    }

    /// What is so far below a point of the plane, in it.
    pub(super) fn below(&self, at: [f64; 2], by: f64) -> [[f64; 3]; 2] {
        [at, [at[0], at[1] - by]].map(|at| self.point(at, [0.0; 3]))
    }

    /// Adds what another triangle is for the face: where it goes through planes just above and just below it; or its edges, if it lies in its
    /// plane and `is_before` it.
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

    /// The edges of a triangle in the plane, if it has an area.
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

    /// From where the edge of a triangle goes down through a plane, to where one comes up again, if corners of such signs are above it: the
    /// inner side is on the left, as seen from where the normal points.
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

    /// Where an edge goes through the plane, whose ends are above it, in it or below it.
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

    /// Of a point above the plane, times the length of the normal: with all digits, as planes that are the same but for rounding are crossed
    /// in places that matter.
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

/// (b − a) × (c − a), in two words.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [Double; 3] {
    let from = |p: [f64; 3]| -> [Double; 3] { core::array::from_fn(|k| Double::sum(p[k], -a[k])) };
    let (u, v) = (from(b), from(c));
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i])
}
