//! Polygons into triangles.
//!
//! A polygon of n corners gives n − 2 triangles between them: each of its edges is an edge of one triangle, in the same
//! direction, and each diagonal is an edge of two, in both. So a surface of polygons is closed exactly if that of the
//! triangles is.
//!
//! A convex polygon is a fan from its first corner. Of any other the ears are cut, in its own plane: an ear is a
//! triangle of three consecutive corners that turns left and has no corner of the rest in it. A polygon that crosses
//! itself runs out of ears, and one with thousands of dents out of patience. The triangles overlap then; in a plane
//! their signed areas and moments still sum to those of the polygon.

use std::mem;

use polhode::{Finding, Severity};

/// Splits polygons; keeps its lists from one to the next.
#[derive(Debug, Default)]
pub(super) struct Polygons {
    /// Polygons so far whose triangles overlap.
    pub(super) crossed: usize,
    /// The corners in the plane.
    points: Vec<[f64; 2]>,
    /// Of each corner that is left, the one before and the one after.
    ring: Vec<[usize; 2]>,
    /// Those that do not turn left.
    dents: Vec<usize>,
}

impl Polygons {
    /// Appends the triangles of the polygon with these corners; all of them exist.
    pub(super) fn split(&mut self, vertices: &[[f64; 3]], corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
        match *corners {
            [] | [_] | [_, _] => return,
            [a, b, c] => return triangles.push([a, b, c]),
            _ => {}
        }
        self.project(vertices, corners);
        let n = corners.len();
        let turns_left =
            |k: usize| turn(self.points[(k + n - 1) % n], self.points[k], self.points[(k + 1) % n]) > 0.0;
        if (0..n).all(turns_left) {
            triangles.extend(corners[1..].windows(2).map(|edge| [corners[0], edge[0], edge[1]]));
        } else {
            self.cut_ears(corners, triangles);
        }
    }

    /// What is to be said about them all.
    pub(super) fn finding(&self) -> Option<Finding> {
        if self.crossed == 0 {
            return None;
        }
        let message = format!(
            "{} faces were split into triangles that overlap: they cross themselves, have no area, or have thousands of dents",
            self.crossed
        );
        Some(Finding { code: "mesh.crossed_polygons", severity: Severity::Warning, message, place: None })
    }

    /// The corners as points of a plane in which the polygon turns left, without a rounding: two of the three coordinates.
    fn project(&mut self, vertices: &[[f64; 3]], corners: &[u32]) {
        let at = |k: &u32| vertices.get(*k as usize).copied().unwrap_or_default();
        let origin = at(&corners[0]);
        let from_origin = |k: &u32| -> [f64; 3] {
            let p = at(k);
            [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]]
        };
        // Newell: twice the area is Σ p_k × p_(k+1), about a corner.
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

    /// Cuts ears until a triangle is left.
    fn cut_ears(&mut self, corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
        /// Points compared per corner: far more than real faces need, and few enough for hostile ones to end.
        const PATIENCE: usize = 4096;
        let Self { points, ring, dents, crossed } = self;
        let n = corners.len();
        let mut push = |triangle: [usize; 3]| triangles.push(triangle.map(|k| corners[k]));
        let is_dent = |ring: &[[usize; 2]], k: usize| {
            let [a, c] = ring[k];
            !(turn(points[a], points[k], points[c]) > 0.0)
        };
        ring.clear();
        ring.extend((0..n).map(|k| [(k + n - 1) % n, (k + 1) % n]));
        dents.clear();
        dents.extend((0..n).filter(|&k| is_dent(ring, k)));

        let mut patience = PATIENCE.saturating_mul(n);
        let (mut left, mut k, mut failures, mut is_crossed) = (n, 1, 0, false);
        while left > 3 && patience > 0 {
            patience = patience.saturating_sub(1 + dents.len());
            let [a, c] = ring[k];
            let is_forced = failures > left;
            if is_forced || is_ear(points, dents, [a, k, c]) {
                push([a, k, c]);
                is_crossed |= is_forced;
                (ring[a][1], ring[c][0]) = (c, a);
                // The neighbours may turn left now. They never stop to, unless the polygon crosses itself.
                dents.retain(|&dent| dent != k && ((dent != a && dent != c) || is_dent(ring, dent)));
                (left, failures) = (left - 1, 0);
            } else {
                failures += 1;
            }
            k = c;
        }
        *crossed += usize::from(is_crossed || left > 3);
        // What is left, a triangle as a rule, is a fan.
        let [_, mut b] = ring[k];
        for _ in 2..left {
            let [_, c] = ring[b];
            push([k, b, c]);
            b = c;
        }
    }
}

/// Twice the signed area of a triangle: (b − a) × (c − a), positive if it turns left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the triangle turns left and has no dent in it or on its edge. A dent on its first corner is no obstacle:
/// there a polygon touches itself, as one with a hole does along its cut.
fn is_ear(points: &[[f64; 2]], dents: &[usize], corners: [usize; 3]) -> bool {
    let [a, b, c] = corners.map(|k| points[k]);
    turn(a, b, c) > 0.0
        && !dents.iter().any(|&dent| {
            let p = points[dent];
            !corners.contains(&dent)
                && p != a
                && turn(a, b, p) >= 0.0
                && turn(b, c, p) >= 0.0
                && turn(c, a, p) >= 0.0
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// A plane in general position, and points in it.
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

    /// n − 2 triangles; the polygon's edges are used once, all other edges as often in both directions.
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

    /// Boundary kept, and no triangle turns right: in a simple polygon they cannot overlap then.
    fn is_clean(points: &[[f64; 2]]) {
        let (triangles, crossed) = split(points);
        keeps_the_boundary(points.len(), &triangles);
        assert_eq!(crossed, 0);
        for triangle in triangles {
            let [a, b, c] = triangle.map(|k| points[k as usize]);
            assert!(turn(a, b, c) > 0.0, "{triangle:?} of {points:?}");
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
        // A comb, a spiral, and a star of unequal rays.
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
                // The dent is corner 2: the diagonal starts there.
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
}
