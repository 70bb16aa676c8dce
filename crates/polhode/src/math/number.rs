//! What series have for coefficients: a number of one body, or one of each of several side by side.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::lanes::Lanes;
use super::real::Real;

/// One f64, or a vector by type with one of each of several bodies.
///
/// The law is that of [`Real`]: every lane has the bits that the f64 would have. Vectors by type know which machine they are for, so that
/// there is none without another one: [`Number::like`].
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// How many there are side by side.
    const LANES: usize;

    /// x in every lane.
    fn like(self, x: f64) -> Self;

    /// The number of a lane.
    fn lane(&self, lane: usize) -> f64;

    /// Sets that of a lane.
    fn put(&mut self, lane: usize, x: f64);

    /// f of every lane.
    fn map(self, f: impl Fn(f64) -> f64) -> Self;

    /// f of every lane of two.
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;

    /// f of every lane of three.
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self;
}

impl Number for f64 {
    const LANES: usize = 1;

    #[inline(always)]
    fn like(self, x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn put(&mut self, _: usize, x: f64) {
        *self = x;
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        f(self, other)
    }

    #[inline(always)]
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
        f(self, b, c)
    }
}

impl<const N: usize> Number for Lanes<N> {
    const LANES: usize = N;

    #[inline(always)]
    fn like(self, x: f64) -> Self {
        Self([x; N])
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self.0[lane]
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, x: f64) {
        self.0[lane] = x;
    }

    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Real::map(self, f)
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Real::zip(self, other, f)
    }

    #[inline(always)]
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
        Real::zip3(self, b, c, f)
    }
}

#[cfg(feature = "simd")]
impl<S: fearless_simd::Simd> Number for fearless_simd::f64x8<S> {
    const LANES: usize = 8;

    #[inline(always)]
    fn like(self, x: f64) -> Self {
        self.simd.splat_f64x8(x)
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> f64 {
        self[lane]
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, x: f64) {
        self[lane] = x;
    }

    #[inline(always)]
    fn map(mut self, f: impl Fn(f64) -> f64) -> Self {
        for x in self.iter_mut() {
            *x = f(*x);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        for lane in 0..8 {
            self[lane] = f(self[lane], other[lane]);
        }
        self
    }

    #[inline(always)]
    fn zip3(mut self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self {
        for lane in 0..8 {
            self[lane] = f(self[lane], b[lane], c[lane]);
        }
        self
    }
}
