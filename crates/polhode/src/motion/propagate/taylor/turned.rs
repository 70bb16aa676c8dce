//! What turns with the body, side by side: the turn since the start of a step, and one vector of space.
//!
//! Both are multiplied by the same numbers, q̇ = ½ q ∘ Ω and v̇ = v × Ω + …, so that a vector costs little where registers have eight places.

use super::row::{MARGIN, Row, TERMS};
use crate::math::number::Number;

/// A quaternion (w, x, y, z), and a vector of space as the turning body sees it with a zero after it.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Pair<N = f64>(pub(super) [N; 8]);

impl<N: Number> Pair<N> {
    #[inline(always)]
    pub(super) fn new(turn: Row<N>, seen: Row<N>) -> Self {
        let ([w, x, y, z], [a, b, c, d]) = (turn.0, seen.0);
        Self([w, x, y, z, a, b, c, d])
    }

    #[inline(always)]
    pub(super) fn turn(self) -> Row<N> {
        let [w, x, y, z, ..] = self.0;
        Row([w, x, y, z])
    }

    #[inline(always)]
    pub(super) fn seen(self) -> Row<N> {
        let [.., a, b, c, d] = self.0;
        Row([a, b, c, d])
    }
}

/// Their Taylor coefficients.
#[derive(Clone, Debug)]
pub(super) struct Turned<N = f64> {
    pairs: [Pair<N>; MARGIN + TERMS],
    /// Is there a vector?
    pub(super) carries: bool,
}

impl<N: Number> Turned<N> {
    pub(super) fn all(zero: N) -> Self {
        Self { pairs: [Pair([zero; 8]); MARGIN + TERMS], carries: false }
    }

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, pair: Pair<N>) {
        self.pairs[MARGIN + n] = pair;
    }

    /// Coefficient n.
    #[inline(always)]
    pub(super) fn at(&self, n: usize) -> Pair<N> {
        self.pairs[MARGIN + n]
    }

    /// All that there are places for, from the constants on.
    #[inline(always)]
    pub(super) fn pairs(&self) -> &[Pair<N>] {
        &self.pairs[MARGIN..]
    }

    /// Coefficients 2, 3, … by fours.
    #[inline(always)]
    pub(super) fn forward_from_second(&self) -> impl Iterator<Item = &[Pair<N>; 4]> {
        self.pairs[MARGIN + 2..].as_chunks().0.iter()
    }
}

/// Coefficients n of all that is unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Newest<N = f64> {
    pub(super) omega: Row<N>,
    pub(super) pair: Pair<N>,
}

impl Pair {
    /// The numbers of (q ∘ eᵢ, v × eᵢ) in their places; [`SIGNS`] has their signs, and zeros.
    #[inline(always)]
    pub(super) fn about(self, axis: usize) -> Self {
        let [w, x, y, z, a, b, c, d] = self.0;
        Self(match axis {
            0 => [x, w, z, y, a, c, b, d],
            1 => [y, z, w, x, c, b, a, d],
            _ => [z, y, x, w, b, a, c, d],
        })
    }
}

/// q ∘ e1 = (−x, w, z, −y), q ∘ e2 = (−y, −z, w, x), q ∘ e3 = (−z, y, −x, w); v × e1 = (0, v3, −v2) and so on.
pub(super) const SIGNS: [[f64; 8]; 3] = [
    [-1.0, 1.0, 1.0, -1.0, 0.0, 1.0, -1.0, 0.0],
    [-1.0, -1.0, 1.0, 1.0, -1.0, 0.0, 1.0, 0.0],
    [-1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 0.0, 0.0],
];

impl<N: Number> Pair<N> {
    /// Plus (q ∘ Ω, v × Ω) of another one, component of Ω by component.
    #[inline(always)]
    pub(super) fn plus_turned(self, pair: Self, turning: Row<N>) -> Self {
        let [w, x, y, z, a, b, c, _] = pair.0;
        let [o1, o2, o3, _] = turning.0;
        let add = |sum: N, [p, q, r]: [N; 3]| r.mul_add(o3, q.mul_add(o2, p.mul_add(o1, sum)));
        let [sw, sx, sy, sz, sa, sb, sc, zero] = self.0;
        Self([
            add(sw, [-x, -y, -z]),
            add(sx, [w, -z, y]),
            add(sy, [z, w, -x]),
            add(sz, [-y, x, w]),
            b.mul_add(o3, (-c).mul_add(o2, sa)),
            (-a).mul_add(o3, c.mul_add(o1, sb)),
            a.mul_add(o2, (-b).mul_add(o1, sc)),
            zero,
        ])
    }
}
