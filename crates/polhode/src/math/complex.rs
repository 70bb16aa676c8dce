//! Minimal complex arithmetic.

use core::ops::{Add, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<T> {
    pub(crate) re: T,
    pub(crate) im: T,
}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Complex<T> {
    #[inline(always)]
    pub(crate) fn times(self, b: Self) -> Self {
        Self { re: self.re * b.re - self.im * b.im, im: self.re * b.im + self.im * b.re }
    }

    #[inline(always)]
    pub(crate) fn plus(self, b: Self) -> Self {
        Self { re: self.re + b.re, im: self.im + b.im }
    }

    #[inline(always)]
    pub(crate) fn minus(self, b: Self) -> Self {
        Self { re: self.re - b.re, im: self.im - b.im }
    }

    #[inline(always)]
    pub(crate) fn scaled(self, by: T) -> Self {
        Self { re: self.re * by, im: self.im * by }
    }

    /// Returns |z|².
    #[inline(always)]
    pub(crate) fn norm_squared(self) -> T {
        self.re * self.re + self.im * self.im
    }
}

impl<T: Neg<Output = T>> Complex<T> {
    #[inline(always)]
    pub(crate) fn conjugate(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// Returns i z.
    #[inline(always)]
    pub(crate) fn times_i(self) -> Self {
        Self { re: -self.im, im: self.re }
    }
}

impl Complex<f64> {
    #[inline(always)]
    pub(crate) fn abs(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    /// Returns the quotient by Smith's method, in which no square overflows.
    #[inline(always)]
    pub(crate) fn over(self, b: Self) -> Self {
        if b.re.abs() >= b.im.abs() {
            let ratio = b.im / b.re;
            let over = b.re + b.im * ratio;
            Self { re: (self.re + self.im * ratio) / over, im: (self.im - self.re * ratio) / over }
        } else {
            let ratio = b.re / b.im;
            let over = b.re * ratio + b.im;
            Self { re: (self.re * ratio + self.im) / over, im: (self.im * ratio - self.re) / over }
        }
    }
}
