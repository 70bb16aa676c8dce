//! Series of a space vector in rotating body axes.

use super::row::{Row, Series};
use super::sums::SeriesSums;
use crate::math::number::Number;

/// Series of a vector along principal axes, which rotate at Ω: v̇ = v × Ω + s. s is its rate in
/// space, in the same axes.
#[derive(Clone, Debug)]
pub(super) struct BodyResolved<N = f64>(Series<N>);

impl<N: Number> BodyResolved<N> {
    pub(super) fn all(x: N) -> Self {
        Self(Series::all(x))
    }

    #[inline(always)]
    pub(super) fn start(&mut self, v: Row<N>) {
        self.0.set(0, v.vector());
    }

    /// Returns the coefficients known so far.
    #[inline(always)]
    pub(super) fn series(&self) -> &Series<N> {
        &self.0
    }

    /// Returns coefficient n.
    #[inline(always)]
    pub(super) fn coefficient(&self, n: usize) -> Row<N> {
        self.0.at(n)
    }

    /// Computes coefficient n + 1 from those up to n. `source` is coefficient n of s.
    #[inline(always)]
    pub(super) fn extend<M: SeriesSums<N = N>>(
        &mut self,
        s: M,
        n: usize,
        turning: &Series<N>,
        source: Row<N>,
    ) {
        let next = (s.cross(&self.0, turning, n) + source).over(n + 1);
        self.0.set(n + 1, next.vector());
    }
}
