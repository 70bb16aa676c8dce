//! Distance of a point from a convex body that is given by its support function.
//!
//! The support function returns the farthest point of the body in a direction. Let v be the point
//! of the body nearest to the origin so far, and w = support(−v). If v·w > 0, the plane through w
//! perpendicular to v separates the body from the origin, and
//!
//!   v·w / |v| ≤ distance ≤ |v|.
//!
//! The bounds become equal after finitely many steps for polytopes, whether a face, an edge or a
//! vertex is nearest. For round bodies they converge. The lower bound is returned, so a separating
//! plane proves every positive distance.
//!
//! Source: Gilbert, Johnson & Keerthi, IEEE J. Robot. Autom. 4 (1988) 193; the subset of the
//! simplex by exhaustion.

use crate::pose::{dot, sum};

/// Iteration limit; sufficient for polytopes of any size. Round bodies gain a digit every few
/// steps.
const STEPS: usize = 200;

/// Relative gap between the bounds at which the iteration stops.
const GAP: f64 = 1e-12;

/// Returns the distance of a point from a convex body, m; zero if the point is inside or on the
/// surface.
pub(super) fn distance(point: [f64; 3], support: impl Fn([f64; 3]) -> [f64; 3]) -> f64 {
    let away = |direction: [f64; 3]| sum(support(direction), point.map(|c| -c));
    let mut simplex = vec![away([1.0, 0.0, 0.0])];
    let mut proved = 0.0_f64;
    for _ in 0..STEPS {
        let Some((nearest, kept)) = nearest(&simplex) else { return proved };
        let size = simplex.iter().map(|v| dot(*v, *v)).fold(0.0, f64::max);
        let square = dot(nearest, nearest);
        if kept.len() == 4 || square <= f64::EPSILON * f64::EPSILON * size {
            return 0.0;
        }
        let farther = away(nearest.map(|c| -c));
        let along = dot(nearest, farther);
        proved = proved.max(along / square.sqrt());
        if square - along <= GAP * square || kept.contains(&farther) {
            return proved;
        }
        simplex = kept;
        simplex.push(farther);
    }
    proved
}

/// Returns the point of a simplex nearest to the origin, and the corners whose convex combination
/// it is.
///
/// Each subset of corners gives a candidate: the point of its affine hull nearest to the origin, if
/// its weights are positive.
fn nearest(simplex: &[[f64; 3]]) -> Option<([f64; 3], Vec<[f64; 3]>)> {
    let subsets = 1_usize..1 << simplex.len();
    let candidates = subsets.filter_map(|subset| {
        let corners: Vec<[f64; 3]> =
            simplex.iter().enumerate().filter(|(k, _)| subset >> k & 1 == 1).map(|(_, v)| *v).collect();
        let weights = weights(&corners)?;
        if !weights.iter().all(|w| *w > 0.0) {
            return None;
        }
        let weighted = corners.iter().zip(&weights).map(|(v, w)| v.map(|c| c * w));
        Some((weighted.fold([0.0; 3], sum), corners))
    });
    candidates.min_by(|(a, _), (b, _)| dot(*a, *a).total_cmp(&dot(*b, *b)))
}

/// Returns the barycentric weights of the point of the corners' affine hull nearest to the origin;
/// `None` if the corners are affinely dependent.
///
/// The edges e_i = v_i − v_0 give  Σ_j (e_i·e_j) w_j = −e_i·v_0,  w_0 = 1 − Σ w_j.
fn weights(corners: &[[f64; 3]]) -> Option<Vec<f64>> {
    let (&first, others) = corners.split_first()?;
    let edges: Vec<[f64; 3]> = others.iter().map(|v| sum(*v, first.map(|c| -c))).collect();
    let mut rows: Vec<Vec<f64>> =
        edges.iter().map(|e| edges.iter().map(|f| dot(*e, *f)).chain([-dot(*e, first)]).collect()).collect();
    let n = rows.len();
    // Gauss–Jordan elimination; the matrix is symmetric and positive definite.
    for k in 0..n {
        let pivot = rows.get(k)?.clone();
        let diagonal = *pivot.get(k)?;
        if !(diagonal > 1e-14 * dot(*edges.get(k)?, *edges.get(k)?)) {
            return None;
        }
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = *row.get(k)? / diagonal;
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x = if i == k { *x / diagonal } else { *x - factor * p };
            }
        }
    }
    let rest: Vec<f64> = rows.iter().filter_map(|row| row.last().copied()).collect();
    Some([1.0 - rest.iter().sum::<f64>()].into_iter().chain(rest).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rotated box, given by its corners: a face, an edge or a vertex is nearest, or the point is
    /// inside.
    #[test]
    fn faces_edges_and_vertices() {
        let pose =
            crate::model::Pose::new([0.31, -0.27, 0.43], crate::pose::of_roll_pitch_yaw([0.4, -0.7, 1.1]));
        let half = [0.11, 0.19, 0.31];
        let corners: Vec<[f64; 3]> = (0..8)
            .map(|k| pose.placed([0, 1, 2].map(|j| if k >> j & 1 == 0 { -half[j] } else { half[j] })))
            .collect();
        let support =
            |d: [f64; 3]| *corners.iter().max_by(|a, b| dot(**a, d).total_cmp(&dot(**b, d))).unwrap();
        for (local, expected) in [
            ([0.03, -0.07, 0.31 + 0.013], 0.013),
            ([-0.11 - 0.02, 0.1, -0.2], 0.02),
            ([0.11 + 0.03, 0.19 + 0.04, 0.12], 0.05),
            ([0.11 + 0.02, -0.19 - 0.03, 0.31 + 0.06], 0.07),
            ([0.05, -0.1, 0.25], 0.0),
            ([0.109999, 0.189999, 0.309999], 0.0),
            ([0.0, 0.0, 0.0], 0.0),
        ] {
            let found = distance(pose.placed(local), support);
            assert!((found - expected).abs() < 1e-12, "{local:?}: {found} {expected}");
        }
    }

    /// Round surfaces: a ball and a cylinder.
    #[test]
    fn round_bodies() {
        let ball = |d: [f64; 3]| {
            let length = dot(d, d).sqrt();
            sum([0.2, -0.1, 0.3], d.map(|c| 0.07 * c / length))
        };
        let from = [0.5, 0.3, -0.2];
        let apart = sum(from, [-0.2, 0.1, -0.3]);
        assert!((distance(from, ball) - (dot(apart, apart).sqrt() - 0.07)).abs() < 1e-9);
        assert_eq!(distance([0.22, -0.12, 0.33], ball), 0.0);
        // A point beyond the rim of a cylinder of radius 0.05 and half length 0.2 along z.
        let cylinder = |[x, y, z]: [f64; 3]| {
            let across = x.hypot(y).max(f64::MIN_POSITIVE);
            [0.05 * x / across, 0.05 * y / across, if z < 0.0 { -0.2 } else { 0.2 }]
        };
        let found = distance([0.03 + 0.05 * 0.6, 0.04 + 0.05 * 0.8, 0.2 + 0.12], cylinder);
        assert!((found - 0.05_f64.hypot(0.12)).abs() < 1e-9, "{found}");
    }
}
