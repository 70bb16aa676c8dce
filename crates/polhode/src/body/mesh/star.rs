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
