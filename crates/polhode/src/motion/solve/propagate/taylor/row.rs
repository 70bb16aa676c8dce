//! Rows of four numbers (a vector or a quaternion), and their Taylor coefficients.
//!
//! The number type N is f64 for a single body, so that a row is a register. For several bodies it
//! is a SIMD vector with one number per body. The equations are written once, generic over N, and
//! each lane is bit-identical to its body alone.

use core::ops::{Add, Deref, Mul, Sub};

use crate::math::number::Number;

/// Four numbers, with elementwise addition and multiplication.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub(super) struct Row<N = f64>(pub(super) [N; 4]);

impl Row {
    pub(super) const ZERO: Self = Self([0.0; 4]);
}

impl<N: Number> Row<N> {
    #[inline(always)]
    pub(super) fn splat(x: N) -> Self {
        Self([x; 4])
    }

    /// Returns (y, z, x, w) for (x, y, z, w). The w of a vector is zero but is kept: the compiler
    /// would otherwise remove the unused element from the register.
    #[inline(always)]
    pub(super) fn cycled(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([y, z, x, w])
    }

    /// Returns a vector as a quaternion: (w, x, y, z) for (x, y, z, w), where w is zero.
    #[inline(always)]
    pub(super) fn pure(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([w, x, y, z])
    }

    /// Returns the vector part of such a quaternion.
    #[inline(always)]
    pub(super) fn imaginary(self) -> Self {
        let [w, x, y, z] = self.0;
        Self([x, y, z, w])
    }

    /// Divides by a whole number, with the two-word inverse of [`INVERSES`].
    #[inline(always)]
    pub(super) fn over(self, n: usize) -> Self {
        let [inverse, rest] = INVERSES[n].map(|x| Self::splat(self.0[0].like(x)));
        self.mul_add(inverse, self * rest)
    }

    #[inline(always)]
    pub(super) fn divided(self, by: N) -> Self {
        let [x, y, z, w] = self.0;
        Self([x / by, y / by, z / by, w / by])
    }

    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(N, N) -> N) -> Self {
        let (a, b) = (self.0, b.0);
        Self([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])])
    }

    /// Returns the largest absolute value, if no number is NaN.
    #[inline(always)]
    pub(super) fn largest(self) -> N {
        let [x, y, z, w] = self.0.map(|x| x.map(f64::abs));
        larger(larger(x, y), larger(z, w))
    }

    /// Returns the row as a vector. For several bodies, w, a separate register, is set to a
    /// constant zero.
    #[inline(always)]
    pub(super) fn vector(self) -> Self {
        let [x, y, z, w] = self.0;
        if N::LANES > 1 { Self([x, y, z, w.like(0.0)]) } else { self }
    }

    /// Returns the length of a vector whose components are finite.
    #[inline(always)]
    pub(super) fn norm(self) -> N {
        // Divide by a power of two near the largest component, so that no square overflows or
        // underflows.
        let power = self
            .largest()
            .map(|size| f64::from_bits((size.to_bits() & EXPONENT).clamp(LEAST, EXPONENT - 2 * LEAST)));
        let inverse = power.map(|power| f64::from_bits(EXPONENT - LEAST - power.to_bits()));
        let scaled = self * Self::splat(inverse);
        let [x, y, z, _] = (scaled * scaled).0;
        ((x + y) + z).sqrt() * power
    }

    #[inline(always)]
    pub(super) fn put(&mut self, lane: usize, row: Row) {
        for (x, value) in self.0.iter_mut().zip(row.0) {
            x.put(lane, value);
        }
    }

    #[inline(always)]
    pub(super) fn mul_add(self, b: Self, c: Self) -> Self {
        let (a, b, c) = (self.0, b.0, c.0);
        Self([
            a[0].mul_add(b[0], c[0]),
            a[1].mul_add(b[1], c[1]),
            a[2].mul_add(b[2], c[2]),
            a[3].mul_add(b[3], c[3]),
        ])
    }

    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> Row {
        Row([self.0[0].lane(lane), self.0[1].lane(lane), self.0[2].lane(lane), self.0[3].lane(lane)])
    }
}

/// Returns the larger of two numbers with one instruction; `f64::max` needs several because of NaN.
/// If `a` is NaN, the result is `b`.
#[inline(always)]
pub(super) fn larger<N: Number>(a: N, b: N) -> N {
    a.zip(b, |a, b| if a > b { a } else { b })
}

/// Returns the smaller of two numbers, with one instruction. If `a` is NaN, the result is `b`.
#[inline(always)]
pub(super) fn smaller<N: Number>(a: N, b: N) -> N {
    a.zip(b, |a, b| if a < b { a } else { b })
}

/// Bit mask of the exponent of an f64.
const EXPONENT: u64 = 0x7ff << 52;
/// Bits of the least normal f64.
const LEAST: u64 = 1 << 52;

impl<N: Number> Add for Row<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, |x, y| x + y)
    }
}

impl<N: Number> Sub for Row<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, |x, y| x - y)
    }
}

impl<N: Number> Mul for Row<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, |x, y| x * y)
    }
}

/// Largest number of terms of a series: a constant and whole groups of four.
pub(super) const TERMS: usize = 25;

/// 1/n in two words. With one word the rounding errors of quotients would have the same sign in
/// every step and would add up.
pub(super) const INVERSES: [[f64; 2]; 2 * TERMS] = {
    let mut inverses = [[f64::INFINITY, 0.0]; 2 * TERMS];
    let mut n = 1;
    while n < 2 * TERMS {
        let number = n as f64;
        let inverse = 1.0 / number;
        // In two halves, whose products with n are exact.
        let high = f64::from_bits(inverse.to_bits() & !0x3ff_ffff);
        inverses[n] = [inverse, ((1.0 - number * high) - number * (inverse - high)) / number];
        n += 1;
    }
    inverses
};

/// Number of zeros before the first coefficient. A loop by fours may read this many.
pub(super) const MARGIN: usize = 3;

/// Taylor coefficients of a row, in ascending order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<N = f64>([Row<N>; MARGIN + TERMS]);

impl<N: Number> Series<N> {
    pub(super) fn all(x: N) -> Self {
        Self([Row::splat(x); MARGIN + TERMS])
    }

    /// Returns a series that is constant.
    pub(super) fn constant(row: Row<N>) -> Self {
        let mut series = Self::all(row.0[0].like(0.0));
        series.0[MARGIN] = row;
        series
    }

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row<N>) {
        self.0[MARGIN + n] = row;
    }

    /// Returns coefficient n.
    #[inline(always)]
    pub(super) fn at(&self, n: usize) -> Row<N> {
        self.0[MARGIN + n]
    }

    /// Returns coefficients 1, 2, … in groups of four. Unknown coefficients are multiplied by a
    /// zero of `backward`.
    #[inline(always)]
    pub(super) fn forward(&self) -> impl Iterator<Item = &[Row<N>; 4]> {
        self.0[MARGIN + 1..].as_chunks().0.iter()
    }

    /// Returns coefficients n − 1, n − 2, … 0 and zeros in groups of four. Each group is in
    /// ascending order.
    #[inline(always)]
    pub(super) fn backward(&self, n: usize) -> impl Iterator<Item = &[Row<N>; 4]> {
        self.0[..MARGIN + n].as_rchunks().1.iter().rev()
    }
}

/// Gives access to the coefficients in ascending order.
impl<N: Number> Deref for Series<N> {
    type Target = [Row<N>];

    #[inline(always)]
    fn deref(&self) -> &[Row<N>] {
        &self.0[MARGIN..]
    }
}

/// Taylor coefficients of a vector, also in the form that its products need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors<N = f64> {
    pub(super) rows: Series<N>,
    /// The same coefficients cycled, for (a2 a3, a3 a1, a1 a2). Several bodies need no copy,
    /// because their components are in separate registers.
    pub(super) cycled: Series<N>,
}

impl<N: Number> Vectors<N> {
    pub(super) fn all(x: N) -> Self {
        Self { rows: Series::all(x), cycled: Series::all(x) }
    }

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row<N>) {
        self.rows.set(n, row.vector());
        if N::LANES == 1 {
            self.cycled.set(n, row.cycled());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_is_one_at_any_size() {
        for size in [0.0, 5e-324, 3e-310, 1e-200, 0.7, 1.0, 2.0, 1e200, 4e307] {
            let norm = Row([2.0 * size, -size, 2.0 * size, 0.0]).norm();
            assert!((norm - 3.0 * size).abs() <= 4.0 * f64::EPSILON * size + 5e-324, "{size:e}: {norm:e}");
        }
    }
}
