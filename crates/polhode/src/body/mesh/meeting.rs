//! Intersection of two triangles.
//!
//! Every decision is an exact sign: triangles that only share a corner or an edge are never
//! reported as crossing.

use super::predicate::{across, facing, side, turn};

/// Intersection of two triangles, beyond the corners that they share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Meeting {
    /// No intersection, or only a point inside an edge of each triangle: if surfaces cross there,
    /// they also cross at another pair of triangles (`overlap.rs`).
    Apart,
    /// Corners of the first triangle that lie on the second, and of the second on the first,
    /// without shared corners.
    Touching([[bool; 3]; 2]),
    /// The interiors cross along a line through about this point.
    Crossing([f64; 3]),
    /// The triangles are coplanar and have a common area; true if they have the same orientation.
    Overlapping(bool),
}

impl Meeting {
    /// Determines the intersection of two triangles, each with an area, from the indices and
    /// coordinates of their corners.
    #[inline]
    pub(crate) fn of(t: [u32; 3], u: [u32; 3], place: impl Fn(u32) -> [f64; 3]) -> Self {
        let shared = |k: usize, v: [u32; 3], w: [u32; 3]| v[k] == w[0] || v[k] == w[1] || v[k] == w[2];
        let [t_shared, u_shared] = [[0, 1, 2].map(|k| shared(k, t, u)), [0, 1, 2].map(|k| shared(k, u, t))];
        let common = u_shared.iter().filter(|&&shared| shared).count();
        if common == 3 {
            return Self::Apart; // the same triangle: reported as a duplicate
        }
        let (a, b) = (t.map(&place), u.map(&place));
        let sides = |plane, p: [[f64; 3]; 3], shared: [bool; 3]| {
            [0, 1, 2].map(|k| if shared[k] { 0.0 } else { side(plane, p[k]) })
        };
        let apart = |s: [f64; 3], shared: [bool; 3]| {
            (0..3).all(|k| shared[k] || s[k] > 0.0) || (0..3).all(|k| shared[k] || s[k] < 0.0)
        };
        let of_u = sides(a, b, u_shared);
        if apart(of_u, u_shared) {
            return Self::Apart;
        }
        if of_u == [0.0; 3] {
            return in_one_plane(a, b);
        }
        let of_t = sides(b, a, t_shared);
        if common == 2 || apart(of_t, t_shared) {
            return Self::Apart;
        }
        if let Some(point) = crossing((a, of_t), (b, of_u)) {
            return Self::Crossing(point);
        }
        let on = [corners_on(a, of_t, t_shared, b), corners_on(b, of_u, u_shared, a)];
        if on.as_flattened().contains(&true) { Self::Touching(on) } else { Self::Apart }
    }
}

/// Returns a point where the interiors of two triangles cross, if they do. `of_a` and `of_b` are
/// the sides of their corners relative to each other's planes.
///
/// The planes intersect in a line. Each triangle with corners on both sides of the other's plane
/// meets this line in a segment, bounded by two edges from one corner. Let p and q be these
/// corners, and p e and q f such edges. The sign of the determinant of p, e, q, f is the order of
/// the two edges' points on the line, up to a common sign (after P. Guigue, O. Devillers, J. Graph.
/// Tools 8 (2003) 25). The segments overlap unless all points of one precede all of the other.
fn crossing((a, of_a): ([[f64; 3]; 3], [f64; 3]), (b, of_b): ([[f64; 3]; 3], [f64; 3])) -> Option<[f64; 3]> {
    let ([p, q], ends) = ([apex(of_a)?, apex(of_b)?], |k: usize| [(k + 1) % 3, (k + 2) % 3]);
    let order = |e: usize, f: usize| side([a[p], a[e], b[q]], b[f]);
    let orders = ends(p).map(|e| ends(q).map(|f| order(e, f)));
    let orders = orders.as_flattened();
    if !(orders.iter().any(|&s| s > 0.0) && orders.iter().any(|&s| s < 0.0)) {
        return None;
    }
    let through = |t: [[f64; 3]; 3], sides: [f64; 3], k: usize| {
        ends(k).map(|l| {
            let part = sides[k].abs() / (sides[k].abs() + sides[l].abs());
            core::array::from_fn::<f64, 3, _>(|i| t[k][i] + part * (t[l][i] - t[k][i]))
        })
    };
    // The point is midway between the second and the third of the four points along the line.
    let [mut points, others] = [through(a, of_a, p), through(b, of_b, q)].map(|points| points.to_vec());
    points.extend(others);
    let along: [f64; 3] = core::array::from_fn(|i| points[1][i] - points[0][i]);
    let place = |p: &[f64; 3]| p[0] * along[0] + p[1] * along[1] + p[2] * along[2];
    points.sort_by(|p, q| place(p).total_cmp(&place(q)));
    Some(core::array::from_fn(|i| 0.5 * (points[1][i] + points[2][i])))
}

/// Returns a corner that is alone on its side of a plane, unless both others are in the plane.
fn apex(sides: [f64; 3]) -> Option<usize> {
    let signs = sides.map(|s| i32::from(s > 0.0) - i32::from(s < 0.0));
    (0..3).find(|&k| {
        signs.contains(&-signs[k]) && signs[k] != 0 && signs.iter().filter(|&&s| s == signs[k]).count() == 1
    })
}

/// Returns which corners of a triangle that are not shared lie on another triangle.
fn corners_on(p: [[f64; 3]; 3], sides: [f64; 3], shared: [bool; 3], other: [[f64; 3]; 3]) -> [bool; 3] {
    let in_plane = |k: usize| !shared[k] && sides[k] == 0.0;
    if !(0..3).any(in_plane) {
        return [false; 3];
    }
    let Some((axis, _)) = facing(other) else { return [false; 3] };
    let [a, b, c] = other.map(|q| across(axis, q));
    let on = |k: usize| {
        let q = across(axis, p[k]);
        let turns = [turn(a, b, q), turn(b, c, q), turn(c, a, q)];
        !(turns.iter().any(|&s| s > 0.0) && turns.iter().any(|&s| s < 0.0))
    };
    [0, 1, 2].map(|k| in_plane(k) && on(k))
}

/// Classifies two coplanar triangles. They have no common area if an edge of one has the other on
/// its outer side.
fn in_one_plane(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> Meeting {
    let Some((axis, of_a)) = facing(a) else { return Meeting::Apart };
    let [p, q] = [a, b].map(|triangle| triangle.map(|corner| across(axis, corner)));
    let of_b = turn(q[0], q[1], q[2]).signum();
    let separates = |p: &[[f64; 2]; 3], sign: f64, q: &[[f64; 2]; 3]| {
        (0..3).any(|k| q.iter().all(|&corner| sign * turn(p[k], p[(k + 1) % 3], corner) <= 0.0))
    };
    if separates(&p, of_a, &q) || separates(&q, of_b, &p) {
        return Meeting::Apart;
    }
    Meeting::Overlapping(of_a == of_b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn meeting(points: &[[f64; 3]], t: [u32; 3], u: [u32; 3]) -> Meeting {
        Meeting::of(t, u, |v| points[v as usize])
    }

    #[test]
    fn triangles_meet_as_they_look() {
        let points = [
            [0.0, 0.0, 0.0], // 0
            [4.0, 0.0, 1.0],
            [0.0, 4.0, 2.0],
            [1.0, 1.0, -3.0], // 3
            [1.2, 0.9, 3.0],
            [9.0, 8.0, 0.5],
            [2.0, 0.0, 0.5], // 6: on the edge 0 1
            [2.0, 2.0, 1.5], // 7: on the edge 1 2
            [2.0, -1.0, 3.0],
        ];
        let at = |t, u| meeting(&points, t, u);
        for (t, u) in [([0, 1, 2], [3, 4, 5]), ([3, 4, 5], [2, 0, 1])] {
            let Meeting::Crossing([x, y, z]) = at(t, u) else { unreachable!("{:?}", at(t, u)) };
            assert!(
                (z - 0.25 * x - 0.5 * y).abs() < 1e-14 && x > -1e-12 && y > -1e-12 && x + y < 4.0 + 1e-12
            );
        }
        assert_eq!(at([0, 1, 2], [0, 3, 5]), Meeting::Apart); // one corner in common
        assert_eq!(at([0, 1, 2], [1, 0, 3]), Meeting::Apart); // one edge
        assert_eq!(at([0, 1, 2], [0, 1, 2]), Meeting::Apart);
        let touching = |on: [usize; 2]| {
            let mut corners = [[false; 3]; 2];
            corners[on[0]][on[1]] = true;
            Meeting::Touching(corners)
        };
        assert_eq!(at([0, 1, 2], [6, 8, 3]), touching([1, 0]));
        assert!(matches!(at([0, 6, 2], [0, 1, 2]), Meeting::Overlapping(true))); // folded over their edge
        assert!(matches!(at([0, 7, 1], [1, 2, 0]), Meeting::Overlapping(false)));
        assert_eq!(at([0, 7, 1], [7, 0, 2]), Meeting::Apart); // side by side
        assert_eq!(at([0, 1, 2], [0, 3, 7]), touching([1, 2])); // from a common corner on
        assert_eq!(at([8, 3, 6], [1, 2, 0]), touching([0, 2]));
        let crossed = at([0, 1, 2], [0, 3, 4]);
        assert!(matches!(crossed, Meeting::Crossing(_)), "{crossed:?}"); // beyond a common corner
        // The interiors cross although no edge passes through an interior: the common line ends on
        // edges of both.
        let grid = [
            [0.0, -1.0, 0.0],
            [0.0, 1.0, 0.0],
            [4.0, 0.0, 0.0],
            [0.0, 0.0, -1.0],
            [0.0, 0.0, 1.0],
            [4.0, 0.0, 0.5],
        ];
        assert!(matches!(meeting(&grid, [0, 1, 2], [3, 4, 5]), Meeting::Crossing(_)));
        assert!(matches!(meeting(&grid, [2, 0, 1], [5, 3, 4]), Meeting::Crossing(_)));
    }
}
