//! How two triangles meet.
//!
//! Every decision is an exact sign: what only shares a corner or an edge is never taken for what crosses.

use super::predicate::{across, facing, side, turn};

/// How two triangles meet, beyond the corners that they share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Meeting {
    Apart,
    /// An edge or a corner of one lies on the other, near this point.
    Touching([f64; 3]),
    /// An edge of one goes through the inside of the other at this point.
    Crossing([f64; 3]),
    /// They lie in one plane and have an area in common; true if they are the same way round.
    Overlapping(bool),
}

impl Meeting {
    /// Of two triangles, each with an area, by their corners' numbers and places.
    #[inline]
    pub(crate) fn of(t: [u32; 3], u: [u32; 3], place: impl Fn(u32) -> [f64; 3]) -> Self {
        let shared = |k: usize, v: [u32; 3], w: [u32; 3]| v[k] == w[0] || v[k] == w[1] || v[k] == w[2];
        let [t_shared, u_shared] = [[0, 1, 2].map(|k| shared(k, t, u)), [0, 1, 2].map(|k| shared(k, u, t))];
        let common = u_shared.iter().filter(|&&shared| shared).count();
        if common == 3 {
            return Self::Apart; // the same triangle: said elsewhere
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
        let first = edges_through(a, of_t, b);
        if matches!(first, Self::Crossing(_)) {
            return first;
        }
        let second = edges_through(b, of_u, a);
        if matches!(second, Self::Crossing(_)) || first == Self::Apart {
            return second.or(|| corners_on(a, of_t, t_shared, b)).or(|| corners_on(b, of_u, u_shared, a));
        }
        first
    }

    fn or(self, other: impl FnOnce() -> Self) -> Self {
        if self == Self::Apart { other() } else { self }
    }
}

/// Do edges of a triangle, whose corners are on these sides of another's plane, go through the other?
fn edges_through(p: [[f64; 3]; 3], sides: [f64; 3], other: [[f64; 3]; 3]) -> Meeting {
    let mut meeting = Meeting::Apart;
    for k in 0..3 {
        let l = (k + 1) % 3;
        if !(sides[k] < 0.0 && sides[l] > 0.0 || sides[k] > 0.0 && sides[l] < 0.0) {
            continue;
        }
        // The edge turns the same way about all three edges of the other.
        let [a, b, c] = other;
        let turns = [side([p[k], p[l], a], b), side([p[k], p[l], b], c), side([p[k], p[l], c], a)];
        let (some_left, some_right) = (turns.iter().any(|&s| s > 0.0), turns.iter().any(|&s| s < 0.0));
        if some_left && some_right {
            continue;
        }
        let part = sides[k].abs() / (sides[k].abs() + sides[l].abs());
        let point = core::array::from_fn(|i| p[k][i] + part * (p[l][i] - p[k][i]));
        if turns.iter().all(|&s| s != 0.0) {
            return Meeting::Crossing(point);
        }
        meeting = Meeting::Touching(point);
    }
    meeting
}

/// Do corners of a triangle lie on another?
fn corners_on(p: [[f64; 3]; 3], sides: [f64; 3], shared: [bool; 3], other: [[f64; 3]; 3]) -> Meeting {
    let in_plane = |k: usize| !shared[k] && sides[k] == 0.0;
    if !(0..3).any(in_plane) {
        return Meeting::Apart;
    }
    let Some((axis, _)) = facing(other) else { return Meeting::Apart };
    let [a, b, c] = other.map(|q| across(axis, q));
    let on = |k: usize| {
        let q = across(axis, p[k]);
        let turns = [turn(a, b, q), turn(b, c, q), turn(c, a, q)];
        !(turns.iter().any(|&s| s > 0.0) && turns.iter().any(|&s| s < 0.0))
    };
    (0..3)
        .find(|&k| !shared[k] && sides[k] == 0.0 && on(k))
        .map_or(Meeting::Apart, |k| Meeting::Touching(p[k]))
}

/// Two triangles in one plane have no area in common if an edge of one has the other on its outer side.
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
        assert_eq!(at([0, 1, 2], [6, 8, 3]), Meeting::Touching(points[6]));
        assert!(matches!(at([0, 6, 2], [0, 1, 2]), Meeting::Overlapping(true))); // folded over their edge
        assert!(matches!(at([0, 7, 1], [1, 2, 0]), Meeting::Overlapping(false)));
        assert_eq!(at([0, 7, 1], [7, 0, 2]), Meeting::Apart); // side by side
        assert!(matches!(at([0, 1, 2], [0, 3, 7]), Meeting::Touching(_))); // from a common corner on
        let crossed = at([0, 1, 2], [0, 3, 4]);
        assert!(matches!(crossed, Meeting::Crossing(_)), "{crossed:?}"); // beyond a common corner
    }
}
