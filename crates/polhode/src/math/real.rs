//! Numbers that kernels compute with: one f64, or several side by side.

use core::ops::{Add, Mul, Neg, Sub};

pub(crate) use core::f64::consts::PI;

/// One f64 or [`Lanes`](super::lanes::Lanes) of them. The law: every lane has the bits that the f64 would have; so there is
/// no fused multiply–add, and no operation here that rounds in another way.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The same number in every lane.
    fn splat(x: f64) -> Self;

    /// f of every lane.
    fn map(self, f: impl Fn(f64) -> f64) -> Self;

    /// f of every lane of two.
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;

    /// f of every lane of three.
    fn zip3(self, b: Self, c: Self, f: impl Fn(f64, f64, f64) -> f64) -> Self;

    /// The integer nearest to each, the even one of two; what is too large to have a fraction stays.
    fn nearest(self) -> Self;

    /// True if |x| ≤ limit in every lane; not of NaN.
    fn within(self, limit: Self) -> bool;
}

impl Real for f64 {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
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

    /// By adding 2⁵², where the fraction ends: without AVX or the like the instruction is a function call.
    #[inline(always)]
    fn nearest(self) -> Self {
        let big = 4_503_599_627_370_496.0_f64.copysign(self);
        if self.abs() < 4_503_599_627_370_496.0 { (self + big) - big } else { self }
    }

    #[inline(always)]
    fn within(self, limit: f64) -> bool {
        self.abs() <= limit
    }
}

/// sin x and cos x, x in rad: `libm`, so that no result depends on the platform's own.
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}
