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

    /// The newest coefficient; the place of the next is cleared, for sums that do without it.
    #[inline(always)]
    pub(super) fn learn(&mut self, n: usize, pair: Pair<N>) {
        self.set(n, pair);
        if N::LANES == 1 {
            self.set(n + 1, Pair([pair.0[0].like(0.0); 8]));
        }
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

    /// Coefficients 1, 2, … by fours; what is beyond the known ones is zero, or meets a zero of `backward`.
    #[inline(always)]
    pub(super) fn forward(&self) -> impl Iterator<Item = &[Pair<N>; 4]> {
        self.pairs[MARGIN + 1..].as_chunks().0.iter()
    }
}

/// Coefficients n of all that is unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Newest<N = f64> {
    pub(super) omega: Row<N>,
    pub(super) pair: Pair<N>,
}

/// q ∘ Ω and v × Ω, of each component of Ω times (q, v).
#[inline(always)]
pub(super) fn turned_at<N: Number>([p, q, r]: [Pair<N>; 3]) -> [Row<N>; 2] {
    let ([pw, px, py, pz, p1, p2, p3, _], [qw, qx, qy, qz, q1, _, q3, _]) = (p.0, q.0);
    let [rw, rx, ry, rz, r1, r2, ..] = r.0;
    // q ∘ e1 = (−x, w, z, −y), q ∘ e2 = (−y, −z, w, x), q ∘ e3 = (−z, y, −x, w)
    let turn = Row([-px - qy - rz, pw - qz + ry, pz + qw - rx, qx - py + rw]);
    // v × Ω = Σ Ωᵢ v × eᵢ
    let seen = Row([r2 - q3, p3 - r1, q1 - p2, p1.like(0.0)]);
    [turn, seen]
}
