//! Rows of four numbers, a vector or a quaternion in one register, and sums of products of their Taylor coefficients.
//!
//! Almost all the time of a step is spent in these sums. Two things count: the terms that need the newest coefficients come last, so that
//! the processor works on all others while those are still being made; and loops have few, foreseeable ends: they go by fours, over
//! coefficients that are not known yet and therefore zero.

use core::ops::{Add, Deref, Mul, Sub};

use crate::math::lanes::Fours;

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

    /// Divided by a whole number. To multiply by its rounded inverse would be off the same way in every step, and errors that do not
    /// change sign add up.
    #[inline(always)]
    pub(super) fn over(self, n: usize) -> Self {
        let n = n as f64;
        let [x, y, z, w] = self.0;
        Self([x / n, y / n, z / n, w / n])
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

/// The most terms of a series: a constant and whole groups of four.
pub(super) const TERMS: usize = 25;

/// Zeros before the first coefficient: as many as a loop by fours may read too far.
const MARGIN: usize = 3;

/// Taylor coefficients, from the constant on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Series([Row; MARGIN + TERMS]);

impl Series {
    pub(super) const ZERO: Self = Self([Row::ZERO; MARGIN + TERMS]);

    /// A series of nothing but its constant.
    pub(super) const fn constant(row: Row) -> Self {
        let mut series = Self::ZERO;
        series.0[MARGIN] = row;
        series
    }

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row) {
        self.0[MARGIN + n] = row;
    }

    /// Coefficient n.
    #[inline(always)]
    pub(super) fn at(&self, n: usize) -> Row {
        self.0[MARGIN + n]
    }

    /// Coefficients 1, 2, … by fours; what is beyond the known ones meets a zero of `backward`.
    #[inline(always)]
    pub(super) fn forward(&self) -> impl Iterator<Item = &[Row; 4]> {
        self.0[MARGIN + 1..].as_chunks().0.iter()
    }

    /// Coefficients n − 1, n − 2, … 0 and zeros by fours, each four in ascending order.
    #[inline(always)]
    pub(super) fn backward(&self, n: usize) -> impl Iterator<Item = &[Row; 4]> {
        self.0[..MARGIN + n].as_rchunks().1.iter().rev()
    }

    /// c₁ h + c₂ h² + … up to an order, h in all places: what the series adds to its constant.
    #[inline(always)]
    pub(super) fn increment<S: Fours>(&self, s: S, order: usize, h: S::Four) -> Row {
        // Odd and even powers by themselves: two short chains instead of a long one.
        let square = h * h;
        let (mut odd, mut even) = (s.splat(0.0), s.splat(0.0));
        let (pairs, last) = self.0[MARGIN + 1..=MARGIN + order].as_chunks();
        if let [last] = last {
            odd = s.load(&last.0);
        }
        for [first, second] in pairs.iter().rev() {
            odd = odd * square + s.load(&first.0);
            even = even * square + s.load(&second.0);
        }
        Row(s.numbers((odd + even * h) * h))
    }
}

/// The coefficients that there are places for.
impl Deref for Series {
    type Target = [Row];

    #[inline(always)]
    fn deref(&self) -> &[Row] {
        &self.0[MARGIN..]
    }
}

/// Taylor coefficients of a number, as the rows'.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers([f64; MARGIN + TERMS]);

impl Numbers {
    pub(super) const ZERO: Self = Self([0.0; MARGIN + TERMS]);

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, x: f64) {
        self.0[MARGIN + n] = x;
    }

    /// Coefficient n.
    #[inline(always)]
    pub(super) fn at(&self, n: usize) -> f64 {
        self.0[MARGIN + n]
    }

    /// As [`Series::backward`].
    #[inline(always)]
    pub(super) fn backward(&self, n: usize) -> impl Iterator<Item = &[f64; 4]> {
        self.0[..MARGIN + n].as_rchunks().1.iter().rev()
    }
}

/// Σ aₖ bₙ₋ₖ, k = 0 … n: the coefficient n of a product.
#[inline(always)]
pub(super) fn product<S: Fours>(s: S, a: &Series, b: &Series, n: usize) -> Row {
    let mut sum = s.splat(0.0);
    for (a, b) in a.forward().zip(b.backward(n)) {
        for k in 0..4 {
            sum = sum + s.load(&a[k].0) * s.load(&b[3 - k].0);
        }
    }
    Row(s.numbers(sum + s.load(&a.at(0).0) * s.load(&b.at(n).0)))
}

/// Taylor coefficients of a vector, with what its products need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors {
    pub(super) rows: Series,
    /// The same turned, as (a2 a3, a3 a1, a1 a2) needs it.
    pub(super) turned: Series,
    /// Each component by itself: it multiplies whole rows.
    pub(super) components: [Numbers; 3],
}

impl Vectors {
    pub(super) const ZERO: Self =
        Self { rows: Series::ZERO, turned: Series::ZERO, components: [Numbers::ZERO; 3] };

    #[inline(always)]
    pub(super) fn set(&mut self, n: usize, row: Row) {
        self.rows.set(n, row);
        self.turned.set(n, row.turned());
        let ([a, b, c], [x, y, z, _]) = (&mut self.components, row.0);
        a.set(n, x);
        b.set(n, y);
        c.set(n, z);
    }
}

/// Coefficients n of the rows x times each component of b.
#[inline(always)]
pub(super) fn outer<S: Fours>(s: S, x: &Series, b: &Vectors, n: usize) -> [Row; 3] {
    let [b1, b2, b3] = &b.components;
    let [mut p, mut q, mut r] = [s.splat(0.0); 3];
    for (x, ((b1, b2), b3)) in x.forward().zip(b1.backward(n).zip(b2.backward(n)).zip(b3.backward(n))) {
        for k in 0..4 {
            let x = s.load(&x[k].0);
            p = p + x * s.splat(b1[3 - k]);
            q = q + x * s.splat(b2[3 - k]);
            r = r + x * s.splat(b3[3 - k]);
        }
    }
    let x = s.load(&x.at(0).0);
    p = p + x * s.splat(b1.at(n));
    q = q + x * s.splat(b2.at(n));
    r = r + x * s.splat(b3.at(n));
    [p, q, r].map(|sum| Row(s.numbers(sum)))
}

/// Coefficient n of (a2 a3, a3 a1, a1 a2).
#[inline(always)]
pub(super) fn others<S: Fours>(s: S, a: &Vectors, n: usize) -> Row {
    // a and a turned: turning once more brings (a1 a2, a2 a3, a3 a1) there
    product(s, &a.rows, &a.turned, n).turned()
}

/// Coefficient n of v × b = Σ bᵢ v × eᵢ.
#[inline(always)]
pub(super) fn cross<S: Fours>(s: S, v: &Series, b: &Vectors, n: usize) -> Row {
    let [p, q, r] = outer(s, v, b, n).map(|sum| sum.0);
    Row([r[1] - q[2], p[2] - r[0], q[0] - p[1], 0.0])
}
