//! A vector of space as the turning body sees it.

use crate::math::lanes::Fours;

use super::row::{Row, Series, Vectors, cross};

/// The series of a vector along principal axes, which turn at Ω: v̇ = v × Ω + s, s its rate in space, seen from the body too.
#[derive(Clone, Debug)]
pub(super) struct Seen(Series);

impl Seen {
    pub(super) const ZERO: Self = Self(Series::ZERO);

    pub(super) fn start(&mut self, v: Row) {
        self.0.set(0, v);
    }

    /// The coefficients known so far.
    #[inline(always)]
    pub(super) fn series(&self) -> &Series {
        &self.0
    }

    /// Coefficient n.
    #[inline(always)]
    pub(super) fn coefficient(&self, n: usize) -> Row {
        self.0.at(n)
    }

    /// Finds coefficient n + 1 from those up to n; `source` is coefficient n of s.
    #[inline(always)]
    pub(super) fn extend<S: Fours>(&mut self, s: S, n: usize, turning: &Vectors, source: Row) {
        let next = (cross(s, &self.0, turning, n) + source).over(n + 1);
        self.0.set(n + 1, next);
    }
}
