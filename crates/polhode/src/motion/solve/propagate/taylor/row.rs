//! Rows of four numbers, a vector or a quaternion, and their Taylor coefficients.
//!
//! The numbers N are f64, so that a row is a register and a series is of one body; or vectors with a number of each of several bodies. The
//! equations are written once, over N, and each lane has the bits that its body has alone.

use core::ops::{Add, Deref, Mul, Sub};

use crate::math::number::Number;

/// Four numbers, added and multiplied place by place.
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

    /// (y, z, x, w) of (x, y, z, w). A vector's w is zero; it is carried along, as a place that nobody reads is one that the compiler
    /// takes out of the register.
    #[inline(always)]
    pub(super) fn cycled(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([y, z, x, w])
    }

    /// A vector as a quaternion: (w, x, y, z) of (x, y, z, w), where w is zero.
    #[inline(always)]
    pub(super) fn pure(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([w, x, y, z])
    }

    /// The vector of such a quaternion.
    #[inline(always)]
    pub(super) fn imaginary(self) -> Self {
        let [w, x, y, z] = self.0;
        Self([x, y, z, w])
    }

    /// Divided by a whole number, as [`INVERSES`] has it.
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

    /// The largest magnitude, if none is NaN.
    #[inline(always)]
    pub(super) fn largest(self) -> N {
        let [x, y, z, w] = self.0.map(|x| x.map(f64::abs));
        larger(larger(x, y), larger(z, w))
    }

    /// A vector. Of several bodies w, a register of its own, is known to be zero.
    #[inline(always)]
    pub(super) fn vector(self) -> Self {
        let [x, y, z, w] = self.0;
        if N::LANES > 1 { Self([x, y, z, w.like(0.0)]) } else { self }
    }

    /// The length of a vector; only of what is finite.
    #[inline(always)]
    pub(super) fn norm(self) -> N {
        // Over a power of two near the largest, so that no square overflows or vanishes.
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

/// The larger of two numbers: one instruction, where f64::max has a few for NaN. Here that gives way if it is the first.
#[inline(always)]
pub(super) fn larger<N: Number>(a: N, b: N) -> N {
    a.zip(b, |a, b| if a > b { a } else { b })
}

/// The smaller of two, in the same way.
#[inline(always)]
pub(super) fn smaller<N: Number>(a: N, b: N) -> N {
    a.zip(b, |a, b| if a < b { a } else { b })
}

/// The bits of an exponent, and of its least that is normal.
const EXPONENT: u64 = 0x7ff << 52;
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

/// The most terms of a series: a constant and whole groups of four.
pub(super) const TERMS: usize = 25;

/// 1/n in two words. By the first alone quotients would be off the same way in every step, and errors that do not change sign add up.
pub(super) const INVERSES: [[f64; 2]; 2 * TERMS] = {
    let mut inverses = [[f64::INFINITY, 0.0]; 2 * TERMS];
    let mut n = 1;
    while n < 2 * TERMS {
        let number = n as f64;
        let inverse = 1.0 / number;
        // In halves, whose products with n are exact.
        let high = f64::from_bits(inverse.to_bits() & !0x3ff_ffff);
        inverses[n] = [inverse, ((1.0 - number * high) - number * (inverse - high)) / number];
        n += 1;
    }
    inverses
};

/// Zeros before the first coefficient: as many as a loop by fours may read too far.
pub(super) const MARGIN: usize = 3;

/// Taylor coefficients, from the constant on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series<N = f64>([Row<N>; MARGIN + TERMS]);

impl<N: Number> Series<N> {
    pub(super) fn all(x: N) -> Self {
        Self([Row::splat(x); MARGIN + TERMS])
    }

    /// A series of nothing but its constant.
    pub(super) fn constant(row: Row<N>) -> Self {
        let mut series = Self::all(row.0[0].like(0.0));
        series.0[MARGIN] = row;
        series
    }

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row<N>) {
        self.0[MARGIN + n] = row;
    }

    /// Coefficient n.
    #[inline(always)]
    pub(super) fn at(&self, n: usize) -> Row<N> {
        self.0[MARGIN + n]
    }

    /// Coefficients 1, 2, … by fours; what is beyond the known ones meets a zero of `backward`.
    #[inline(always)]
    pub(super) fn forward(&self) -> impl Iterator<Item = &[Row<N>; 4]> {
        self.0[MARGIN + 1..].as_chunks().0.iter()
    }

    /// Coefficients n − 1, n − 2, … 0 and zeros by fours, each four in ascending order.
    #[inline(always)]
    pub(super) fn backward(&self, n: usize) -> impl Iterator<Item = &[Row<N>; 4]> {
        self.0[..MARGIN + n].as_rchunks().1.iter().rev()
    }
}

/// The coefficients from the constant on.
impl<N: Number> Deref for Series<N> {
    type Target = [Row<N>];

    #[inline(always)]
    fn deref(&self) -> &[Row<N>] {
        &self.0[MARGIN..]
    }
}

/// Taylor coefficients of a vector, with what its products need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors<N = f64> {
    pub(super) rows: Series<N>,
    /// The same cycled, as (a2 a3, a3 a1, a1 a2) needs it. Several bodies need no copy: their components lie apart.
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
