//! Rows of four numbers: a vector or a quaternion in one register, and sums of products of their Taylor coefficients.

use core::ops::{Add, Mul, Sub};

/// Four numbers, added and multiplied place by place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub(super) struct Row(pub(super) [f64; 4]);

impl Row {
    pub(super) const ZERO: Self = Self([0.0; 4]);

    #[inline(always)]
    pub(super) fn splat(x: f64) -> Self {
        Self([x; 4])
    }

    /// (y, z, x, w) of (x, y, z, w). A vector's w is zero; it is carried along, as a place that nobody reads is one that the compiler
    /// takes out of the register.
    #[inline(always)]
    pub(super) fn turned(self) -> Self {
        let [x, y, z, w] = self.0;
        Self([y, z, x, w])
    }

    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self.0, b.0);
        Self([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])])
    }

    /// The largest magnitude.
    pub(super) fn largest(self) -> f64 {
        self.0.iter().fold(0.0, |most, x| most.max(x.abs()))
    }
}

impl Add for Row {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, |x, y| x + y)
    }
}

impl Sub for Row {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, |x, y| x - y)
    }
}

impl Mul for Row {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, |x, y| x * y)
    }
}

/// The most terms of a series.
pub(super) const TERMS: usize = 25;

/// Taylor coefficients, from the constant on.
pub(super) type Series = [Row; TERMS];

/// Σ aₖ bₙ₋ₖ, k = 0 … n: the coefficient n of a product.
#[inline(always)]
pub(super) fn product(a: &Series, b: &Series, n: usize) -> Row {
    // Two sums, so that one need not wait for the other.
    let (a, b) = (&a[..=n], &b[..=n]);
    let mut sums = [Row::ZERO; 2];
    let (pairs, last) = a.as_chunks::<2>();
    let mut back = b.iter().rev();
    for &[a0, a1] in pairs {
        if let (Some(&b0), Some(&b1)) = (back.next(), back.next()) {
            sums[0] = sums[0] + a0 * b0;
            sums[1] = sums[1] + a1 * b1;
        }
    }
    if let ([a], Some(&b)) = (last, back.next()) {
        sums[0] = sums[0] + *a * b;
    }
    sums[0] + sums[1]
}

/// A vector's series, and the same turned, as cross products need it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors {
    pub(super) rows: Series,
    turned: Series,
}

impl Vectors {
    pub(super) const ZERO: Self = Self { rows: [Row::ZERO; TERMS], turned: [Row::ZERO; TERMS] };

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row) {
        self.rows[n] = row;
        self.turned[n] = row.turned();
    }

    /// Coefficient n of a × b: Σ (aₖ bₙ₋ₖ' − aₖ' bₙ₋ₖ)', ' for turned.
    #[inline(always)]
    pub(super) fn cross(&self, b: &Self, n: usize) -> Row {
        (product(&self.rows, &b.turned, n) - product(&self.turned, &b.rows, n)).turned()
    }

    /// Coefficient n of (a2 a3, a3 a1, a1 a2).
    #[inline(always)]
    pub(super) fn others(&self, n: usize) -> Row {
        // a turned and a turned twice: turning once more brings (a1 a2, a2 a3, a3 a1) there
        product(&self.rows, &self.turned, n).turned()
    }
}

/// c₁ h + c₂ h² + … up to an order: what a series adds to its constant.
#[inline(always)]
pub(super) fn increment(series: &Series, order: usize, h: f64) -> Row {
    let h = Row::splat(h);
    series[1..=order].iter().rev().fold(Row::ZERO, |sum, &c| (sum + c) * h)
}
