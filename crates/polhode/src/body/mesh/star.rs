//! Star-shaped surfaces, which cannot intersect themselves.
//!
//! Let all corners of a closed surface be seen from a point o. If o lies strictly behind the plane
//! of every triangle, then the central projection from o maps each triangle onto a spherical
//! triangle and keeps its orientation. No edge is a boundary or a fold, so the number of triangles
//! over a direction is the same for almost all directions (the degree of a map is constant). If it
//! is one for one direction, the spherical triangles have no common interior points. Any
//! intersection of two triangles, beyond their common corners and edges, would be two layers over
//! the directions next to it.
//!
//! This is the test of `layer.rs` with a central projection of the whole surface. It takes one pass
//! over the triangles, and all its signs are exact. For convex bodies see K. Mehlhorn et al.,
//! Comput. Geom. 12 (1999) 85.

use super::edges::Edges;
use super::inside::centroid;
use super::predicate::side;
use super::weld::{Welded, is_proper};

/// Returns true if the mesh is one star-shaped surface, seen from the mean of its vertices. Its
/// triangles must have an area, except those with two equal corners.
pub(super) fn is_star_shaped(welded: &Welded, edges: &Edges) -> bool {
    let Edges { boundary, inconsistent, crowded, duplicates, .. } = edges;
    if !(boundary.is_empty() && inconsistent.is_empty() && crowded.is_empty() && duplicates.is_empty()) {
        return false;
    }
    let from = mean(&welded.points);
    let proper = || (0..welded.corners.len()).filter(|&t| is_proper(&welded.corners[t]));
    let Some(first) = proper().next().map(|t| welded.triangle(t)) else { return false };
    // 1 if all normals point away from the point, −1 if all point towards it.
    let sign = -side(first, from).signum();
    if !proper().all(|t| sign * side(welded.triangle(t), from) < 0.0) {
        return false;
    }
    let toward = centroid(first);
    // A direction is in the cone of a triangle if it is on no outer side of the cone's three faces.
    let is_over = |&t: &usize| {
        let [a, b, c] = welded.triangle(t);
        let is_within = |a, b| sign * side([a, b, toward], from) <= 0.0;
        is_within(a, b) && is_within(b, c) && is_within(c, a)
    };
    proper().filter(is_over).take(2).count() == 1
}

fn mean(points: &[[f64; 3]]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for p in points {
        sum = core::array::from_fn(|k| sum[k] + p[k]);
    }
    sum.map(|c| c / points.len() as f64)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use core::f64::consts::TAU;

    use super::super::TriangleMesh;
    use super::super::meeting::Meeting;
    use super::super::threads::Threads;
    use super::*;

    /// Returns a closed surface about an oblique axis with this many turns, whose radius is a
    /// function of two angles.
    fn ball(turns: u32, radius: impl Fn(f64, f64) -> f64) -> TriangleMesh {
        let (bands, n) = (9, 14 * turns);
        let point = |u: f64, v: f64| {
            let [x, y, z] = [u.sin() * v.cos(), u.sin() * v.sin(), u.cos()].map(|c| c * radius(u, v));
            [0.36 * x + 0.48 * y - 0.8 * z + 0.7, -0.8 * x + 0.6 * y, 0.48 * x + 0.64 * y + 0.6 * z - 0.2]
        };
        let angle = |k: u32, n: u32, all: f64| all * f64::from(k) / f64::from(n);
        let ring = |i: u32| (0..n).map(move |k| (angle(i, bands, 0.5 * TAU), angle(k, 14, TAU)));
        let mut points: Vec<[f64; 3]> = (1..bands).flat_map(ring).map(|(u, v)| point(u, v)).collect();
        let (first, last) = (points.len() as u32, points.len() as u32 + 1);
        points.extend([point(0.0, 0.0), point(0.5 * TAU, 0.0)]);
        let mut triangles = Vec::new();
        for k in 0..n {
            let at = |i: u32, k: u32| i * n + k % n;
            triangles
                .extend([[first, at(0, k), at(0, k + 1)], [last, at(bands - 2, k + 1), at(bands - 2, k)]]);
            for i in 0..bands - 2 {
                let [a, b, c, d] = [at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        TriangleMesh::new(points, triangles).unwrap()
    }

    /// Returns the verdict, and the number of pairs of triangles that intersect.
    fn judged(mesh: &TriangleMesh) -> (bool, usize) {
        let welded = Welded::of(mesh, Threads::of(1));
        let edges = Edges::of(&welded.corners, welded.points.len(), Threads::of(1));
        let place = |v: u32| welded.points[v as usize];
        let pairs = (0..welded.corners.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
        let meets = |[i, j]: &[usize; 2]| {
            Meeting::of(welded.corners[*i], welded.corners[*j], place) != Meeting::Apart
        };
        (is_star_shaped(&welded, &edges), pairs.filter(meets).count())
    }

    fn wavy(u: f64, v: f64) -> f64 {
        1.0 + 0.12 * (2.0 * u + 0.4).sin() * (v - 0.3).cos() + 0.05 * (3.0 * v).sin() * u.sin()
    }

    #[test]
    fn lumps_are_star_shaped_in_both_orientations() {
        let lump = ball(1, wavy);
        assert_eq!(judged(&lump), (true, 0));
        let turned = lump.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
        let inward = TriangleMesh::new(lump.coordinates().to_vec(), turned).unwrap();
        assert_eq!(judged(&inward), (true, 0));
        for (scale, shift) in [(1e-9, 3e-4), (1e100, 0.0), (7.0, 1e6)] {
            let moved = lump.coordinates().iter().map(|p| p.map(|c| c * scale + shift)).collect();
            assert!(judged(&TriangleMesh::new(moved, lump.triangles().to_vec()).unwrap()).0, "{scale}");
        }
    }

    #[test]
    fn two_turns_are_two_layers() {
        // Every triangle faces away from the centre, and two of them cover each direction.
        let (is_star, pairs) = judged(&ball(2, |u, v| 1.0 + 0.02 * u.sin() * (0.5 * v + 0.2).sin()));
        assert!(!is_star && pairs > 0, "{pairs}");
    }

    #[test]
    fn a_hole_a_turned_triangle_or_a_second_shell_is_not_star_shaped() {
        let lump = ball(1, wavy);
        let with = |change: &dyn Fn(&mut Vec<[u32; 3]>)| {
            let mut triangles = lump.triangles().to_vec();
            change(&mut triangles);
            judged(&TriangleMesh::new(lump.coordinates().to_vec(), triangles).unwrap()).0
        };
        assert!(with(&|triangles| triangles.push([3, 3, 7])));
        assert!(!with(&|triangles| triangles.truncate(40)));
        assert!(!with(&|triangles| triangles[40].swap(0, 1)));
        assert!(!with(&|triangles| triangles.push(triangles[40])));
        let shell = ball(1, |u, v| 1.4 * wavy(u, v));
        assert!(!judged(&lump.clone().joined(&shell).unwrap()).0);
        assert!(!judged(&TriangleMesh::default()).0);
    }

    #[test]
    fn a_star_shaped_surface_has_no_intersections() {
        let mut state = 5_u64;
        let mut chance = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / 9_007_199_254_740_992.0 - 0.5
        };
        let mut found = [0; 3];
        for round in 0..60 {
            // Corners are displaced more and more, until triangles fold over others.
            let lump = ball(1, wavy);
            let size = 0.012 * f64::from(round);
            let points = lump.coordinates().iter().map(|p| p.map(|c| c + size * chance()));
            let mesh = TriangleMesh::new(points.collect::<Vec<[f64; 3]>>(), lump.triangles().to_vec());
            let (is_star, pairs) = judged(&mesh.unwrap());
            assert!(!is_star || pairs == 0, "{round}: {pairs}");
            found[usize::from(!is_star) + usize::from(pairs > 0)] += 1;
        }
        assert!(found.iter().all(|&count| count > 2), "{found:?}");
    }
}
