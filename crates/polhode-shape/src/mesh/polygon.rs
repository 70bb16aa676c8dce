//! Triangulation of polygons.
//!
//! A small convex polygon becomes a fan from its first corner. Other polygons are triangulated by
//! ear clipping in their plane. An ear is a triangle of three consecutive corners that turns left
//! and contains no other corner. Signs are exact. A self-intersecting polygon runs out of ears, and
//! a malicious one reaches an iteration limit. The triangles then overlap; in a plane, their signed
//! areas and moments still sum to those of the polygon.
//!
//! The time for n corners is of order n log n. Every second ear of a row is cut in one round, so
//! that the triangles grow evenly and no corner has many. A tree finds the reflex corners, the only
//! ones that can lie in an ear. Ears hidden by a reflex corner are tested again only after it is
//! gone.

mod dents;
mod ears;

use std::mem;

use polhode::body::Finding;
use robust::{Coord, orient2d};

use ears::Ears;

use crate::finding::warning;

/// Maximum number of corners of a polygon that becomes a fan.
const SMALL: usize = 16;

/// Splits polygons into triangles; reuses its buffers.
///
/// ```
/// use polhode_shape::mesh::Polygons;
/// let square = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 3.0, 0.0], [0.0, 3.0, 0.0]];
/// let mut triangles = Vec::new();
/// Polygons::default().split(&square, &[0, 1, 2, 3], &mut triangles);
/// assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
/// ```
#[derive(Debug, Default)]
pub struct Polygons {
    /// Number of polygons so far whose triangles overlap.
    pub crossed: usize,
    /// Corners in the plane.
    points: Vec<[f64; 2]>,
    ears: Ears,
}

impl Polygons {
    /// Appends the triangles of the polygon with these corners, which must exist.
    pub fn split(&mut self, vertices: &[[f64; 3]], corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
        match *corners {
            [] | [_] | [_, _] => return,
            [a, b, c] => return triangles.push([a, b, c]),
            _ => {}
        }
        self.project(vertices, corners);
        let Self { points, ears, crossed } = self;
        let n = corners.len();
        let turns_left = |k: usize| turn(points[(k + n - 1) % n], points[k], points[(k + 1) % n]) > 0.0;
        if n <= SMALL && (0..n).all(turns_left) {
            triangles.extend(corners[1..].windows(2).map(|edge| [corners[0], edge[0], edge[1]]));
        } else {
            let is_clean = ears.cut(points, |triangle| triangles.push(triangle.map(|k| corners[k as usize])));
            *crossed += usize::from(!is_clean);
        }
    }

    /// Returns the finding about all polygons so far.
    pub(crate) fn finding(&self) -> Option<Finding> {
        if self.crossed == 0 {
            return None;
        }
        let message = format!(
            "{} faces were split into overlapping triangles: they intersect themselves, have no area, or have thousands of concave corners",
            self.crossed
        );
        Some(warning("mesh.crossed_polygons", message))
    }

    /// Projects the corners to a plane in which the polygon turns left. It selects two of the three
    /// coordinates, so it is exact.
    fn project(&mut self, vertices: &[[f64; 3]], corners: &[u32]) {
        let at = |k: &u32| vertices.get(*k as usize).copied().unwrap_or_default();
        let origin = at(&corners[0]);
        let from_origin = |k: &u32| -> [f64; 3] {
            let p = at(k);
            [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]]
        };
        // Newell's formula: twice the area is Σ p_k × p_(k+1), relative to a corner.
        let mut area = [0.0; 3];
        for edge in corners.windows(2) {
            let (p, q) = (from_origin(&edge[0]), from_origin(&edge[1]));
            area[0] += p[1] * q[2] - p[2] * q[1];
            area[1] += p[2] * q[0] - p[0] * q[2];
            area[2] += p[0] * q[1] - p[1] * q[0];
        }
        let [x, y, z] = area.map(f64::abs);
        let normal = if x > y && x > z {
            0
        } else if y > z {
            1
        } else {
            2
        };
        let (mut u, mut v) = ((normal + 1) % 3, (normal + 2) % 3);
        if area[normal] < 0.0 {
            mem::swap(&mut u, &mut v);
        }
        self.points.clear();
        self.points.extend(corners.iter().map(|k| {
            let p = at(k);
            [p[u], p[v]]
        }));
    }
}

/// Returns twice the signed area of a triangle: (b − a) × (c − a), positive if it turns left. The
/// sign is exact.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let coord = |[x, y]: [f64; 2]| Coord { x, y };
    orient2d(coord(a), coord(b), coord(c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Returns points in a plane in general position.
    fn in_space(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
        let (u, v, origin) = ([0.36, 0.48, -0.8], [0.8, -0.6, 0.0], [3.1, -2.7, 11.3]);
        points.iter().map(|p| std::array::from_fn(|i| origin[i] + p[0] * u[i] + p[1] * v[i])).collect()
    }

    fn split(points: &[[f64; 2]]) -> (Vec<[u32; 3]>, usize) {
        let (vertices, mut triangles) = (in_space(points), Vec::new());
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let mut polygons = Polygons::default();
        polygons.split(&vertices, &corners, &mut triangles);
        (triangles, polygons.crossed)
    }

    /// Asserts n − 2 triangles. Edges of the polygon must be used once, all others equally often in
    /// both directions.
    fn keeps_the_boundary(n: usize, triangles: &[[u32; 3]]) {
        assert_eq!(triangles.len(), n - 2);
        let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
        for [a, b, c] in triangles {
            for (p, q) in [(a, b), (b, c), (c, a)] {
                *balance.entry((*p.min(q), *p.max(q))).or_default() += if p < q { 1 } else { -1 };
            }
        }
        for k in 0..n as u32 {
            let next = (k + 1) % n as u32;
            *balance.entry((k.min(next), k.max(next))).or_default() -= if k < next { 1 } else { -1 };
        }
        assert!(balance.values().all(|b| *b == 0), "{triangles:?}");
    }

    /// Asserts that the boundary is kept and no triangle turns right. In a simple polygon the
    /// triangles then do not overlap.
    fn is_clean(points: &[[f64; 2]]) {
        let (triangles, crossed) = split(points);
        keeps_the_boundary(points.len(), &triangles);
        assert_eq!(crossed, 0);
        for triangle in triangles {
            let [a, b, c] = triangle.map(|k| points[k as usize]);
            // Tolerance for the rounding of the corners in space.
            let rounding = 1e-14 * points.as_flattened().iter().fold(0.0_f64, |max, c| max.max(c * c));
            assert!(turn(a, b, c) > -rounding, "{triangle:?} of {points:?}");
        }
    }

    #[test]
    fn convex_polygons_are_fans() {
        let pentagon = [[0.3, 0.1], [2.2, -0.4], [3.1, 1.7], [1.9, 3.3], [-0.6, 2.1]];
        assert_eq!(split(&pentagon), (vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]], 0));
        assert_eq!(split(&pentagon[..3]), (vec![[0, 1, 2]], 0));
        assert_eq!(split(&pentagon[..2]), (vec![], 0));
    }

    #[test]
    fn dents_are_no_obstacle() {
        let arrow = [[0.0, 0.0], [4.1, -1.3], [1.2, 0.4], [-0.7, 3.9]];
        for turned in 0..4 {
            let mut arrow = arrow;
            arrow.rotate_left(turned);
            is_clean(&arrow);
        }
        // A comb, a spiral, and a star with unequal rays.
        let comb =
            (0..41).map(|k| [f64::from(40 - k), if k % 2 == 0 { 5.3 } else { 0.7 + 0.01 * f64::from(k) }]);
        is_clean(&[[-1.5, 0.0], [41.5, -0.3]].into_iter().chain(comb).collect::<Vec<_>>());
        let arm = |r: f64, k: i32| [r * (0.3 * f64::from(k)).cos(), r * (0.3 * f64::from(k)).sin()];
        let out = (0..60).map(|k| arm(1.5 + 0.1 * f64::from(k), k));
        let back = (0..60).rev().map(|k| arm(1.0 + 0.1 * f64::from(k), k));
        is_clean(&out.chain(back).collect::<Vec<_>>());
        let star = (0..25).map(|k| {
            let (r, angle) = (if k % 2 == 0 { 7.3 } else { 1.1 + 0.04 * f64::from(k) }, 0.25 * f64::from(k));
            [r * angle.cos(), r * angle.sin()]
        });
        is_clean(&star.collect::<Vec<_>>());
    }

    #[test]
    fn corners_on_a_straight_edge_stay() {
        let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.5], [2.0, 2.0], [0.0, 2.0], [0.0, 0.5]];
        for turned in 0..square.len() {
            let mut square = square;
            square.rotate_left(turned);
            let mut triangles = Vec::new();
            let flat: Vec<_> = square.iter().map(|p| [p[0], p[1], 0.75]).collect();
            let mut polygons = Polygons::default();
            polygons.split(&flat, &[0, 1, 2, 3, 4, 5, 6], &mut triangles);
            keeps_the_boundary(7, &triangles);
            assert_eq!(polygons.crossed, 0);
            assert!(triangles.iter().all(|t| {
                let [a, b, c] = t.map(|k| square[k as usize]);
                turn(a, b, c) > 0.0
            }));
        }
    }

    #[test]
    fn a_hole_is_reached_through_a_cut() {
        let outer = [[0.0, 0.0], [5.0, 0.5], [6.0, 4.0], [1.0, 5.0]];
        let hole = [[2.0, 1.5], [1.5, 3.0], [3.5, 3.5], [4.0, 2.0]];
        let cut: Vec<_> = outer.iter().chain(&outer[..1]).chain(&hole).chain(&hole[..1]).copied().collect();
        is_clean(&cut);
    }

    #[test]
    fn the_plane_may_face_any_way() {
        let arrow = [[0.0, 0.0], [4.1, -1.3], [1.2, 0.4], [-0.7, 3.9]];
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let space = arrow.map(|[x, y]| {
                    let mut p = [0.0; 3];
                    (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (0.25 * x + 7.0, x, sign * y);
                    p
                });
                let mut triangles = Vec::new();
                Polygons::default().split(&space, &[0, 1, 2, 3], &mut triangles);
                // The reflex corner is corner 2: the diagonal starts there.
                assert!(triangles.iter().all(|t| t.contains(&2) && t.contains(&0)), "{triangles:?}");
            }
        }
    }

    #[test]
    fn what_crosses_itself_ends_too_and_keeps_its_boundary() {
        let bow = [[0.0, 0.0], [3.0, 2.0], [3.0, 0.0], [0.0, 2.0], [-1.0, 1.1]];
        let (triangles, _) = split(&bow);
        keeps_the_boundary(5, &triangles);
        let line: Vec<_> = (0..9).map(|k| [f64::from(k * k % 5), 0.0]).collect();
        let (triangles, crossed) = split(&line);
        keeps_the_boundary(9, &triangles);
        assert_eq!(crossed, 1);
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 40) as f64
        };
        for n in [4, 7, 20, 3000] {
            let chaos: Vec<_> = (0..n).map(|_| [random(), random()]).collect();
            keeps_the_boundary(n, &split(&chaos).0);
        }
        let vast = [[1e308, -1e308, 0.0], [-1e308, 1e308, 1e308], [1.0, 2.0, 3.0], [1e308, 1e308, -1e308]];
        let mut triangles = Vec::new();
        Polygons::default().split(&vast, &[0, 1, 2, 3], &mut triangles);
        keeps_the_boundary(4, &triangles);
    }

    #[test]
    fn thousands_of_corners_end_without_a_corner_that_has_them_all() {
        let n = 20_000;
        let on = |r: f64, turns: f64| {
            let angle = std::f64::consts::TAU * turns;
            [r * angle.cos(), r * angle.sin()]
        };
        let part = |k: u32| f64::from(k) / f64::from(n);
        let circle: Vec<_> = (0..n).map(|k| on(1.7, part(k))).collect();
        let star: Vec<_> = (0..n).map(|k| on(1.3 + f64::from(k * 7919 % 101), part(k))).collect();
        let arm = |r: f64, k: u32| on(r + 30.0 * part(k), 31.0 * part(k));
        let spiral = (0..n / 2).map(|k| arm(1.5, k)).chain((0..n / 2).rev().map(|k| arm(1.1, k))).collect();
        let comb = |k: u32| {
            [-f64::from(k), if k.is_multiple_of(2) { 1e5 + 3.0 * f64::from(k) } else { 0.7 * f64::from(k) }]
        };
        let comb = (0..n).map(comb).chain([[-f64::from(n), -1.0], [0.0, -1.0]]).collect();
        // Straight sides with thousands of corners.
        let walls = |k: u32| {
            let along = f64::from(k % 5000);
            match k / 5000 {
                0 => [along, 0.0],
                1 => [5000.0, along],
                2 => [5000.0 - along, 5000.0],
                _ => [0.0, 5000.0 - along],
            }
        };
        for points in [circle, star, spiral, comb, (0..n).map(walls).collect()] {
            let vertices: Vec<_> = points.iter().map(|p| [p[0], p[1], 0.75]).collect();
            let mut triangles = Vec::new();
            let corners: Vec<u32> = (0..points.len() as u32).collect();
            let mut polygons = Polygons::default();
            polygons.split(&vertices, &corners, &mut triangles);
            keeps_the_boundary(points.len(), &triangles);
            assert_eq!(polygons.crossed, 0);
            assert!(triangles.iter().all(|t| {
                let [a, b, c] = t.map(|k| points[k as usize]);
                turn(a, b, c) > 0.0
            }));
            let mut count = vec![0; points.len()];
            triangles.as_flattened().iter().for_each(|&k| count[k as usize] += 1);
            let several = count.iter().filter(|&&count| count > 100).count();
            assert!(several < 5, "{several}");
        }
    }
}
