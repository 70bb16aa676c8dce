//! Pairs of rows: two vectors or quaternions, in one register if registers hold eight numbers.

use super::row::Row;
use crate::math::number::Number;

/// Two rows of four numbers each.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Pair<N = f64>(pub(super) [N; 8]);

impl<N: Number> Pair<N> {
    #[inline(always)]
    pub(super) fn new(first: Row<N>, second: Row<N>) -> Self {
        let ([w, x, y, z], [a, b, c, d]) = (first.0, second.0);
        Self([w, x, y, z, a, b, c, d])
    }

    #[inline(always)]
    pub(super) fn splat(x: N) -> Self {
        Self([x; 8])
    }

    #[inline(always)]
    pub(super) fn first(self) -> Row<N> {
        let [w, x, y, z, ..] = self.0;
        Row([w, x, y, z])
    }

    #[inline(always)]
    pub(super) fn second(self) -> Row<N> {
        let [.., a, b, c, d] = self.0;
        Row([a, b, c, d])
    }
}
