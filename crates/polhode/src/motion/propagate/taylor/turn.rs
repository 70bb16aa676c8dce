//! The turn since the start of a step: a quaternion's series.

use super::row::{Row, Series, TERMS, product};

/// Twice its rate is q ∘ ω, a sum of three products of rows:
///
/// (−x, w, w, w)(ω1, ω1, ω2, ω3) + (−y, y, z, x)(ω2, ω3, ω1, ω2) − (z, z, x, y)(ω3, ω2, ω3, ω1)
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    /// (w, x, y, z)
    pub(super) rows: Series,
    left: [Series; 3],
    right: [Series; 3],
}

impl Turn {
    pub(super) const NONE: Self =
        Self { rows: [Row::ZERO; TERMS], left: [[Row::ZERO; TERMS]; 3], right: [[Row::ZERO; TERMS]; 3] };

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, q: Row) {
        let [w, x, y, z] = q.0;
        self.rows[n] = q;
        self.left[0][n] = Row([-x, w, w, w]);
        self.left[1][n] = Row([-y, y, z, x]);
        self.left[2][n] = Row([z, z, x, y]);
    }

    #[inline(always)]
    pub(super) fn set_omega(&mut self, n: usize, omega: Row) {
        let [x, y, z, _] = omega.0;
        self.right[0][n] = Row([x, x, y, z]);
        self.right[1][n] = Row([y, z, x, y]);
        self.right[2][n] = Row([z, y, z, x]);
    }

    /// Coefficient n of q ∘ ω.
    #[inline(always)]
    pub(super) fn twice_rate(&self, n: usize) -> Row {
        let Self { left: [a, b, c], right: [x, y, z], .. } = self;
        (product(a, x, n) + product(b, y, n)) - product(c, z, n)
    }
}
