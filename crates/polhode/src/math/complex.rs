//! Complex numbers, no more of them than is needed.

use super::real::Real;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<T> {
    pub(crate) re: T,
    pub(crate) im: T,
}

impl<T: Real> Complex<T> {
    #[inline(always)]
    pub(crate) fn conjugate(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    #[inline(always)]
    pub(crate) fn times(self, b: Self) -> Self {
        Self { re: self.re * b.re - self.im * b.im, im: self.re * b.im + self.im * b.re }
    }

    #[inline(always)]
    pub(crate) fn square(self) -> Self {
        let product = self.re * self.im;
        Self { re: self.re * self.re - self.im * self.im, im: product + product }
    }

    /// + a real number.
    #[inline(always)]
    pub(crate) fn plus(self, b: T) -> Self {
        Self { re: self.re + b, im: self.im }
    }

    #[inline(always)]
    pub(crate) fn sum(self, b: Self) -> Self {
        Self { re: self.re + b.re, im: self.im + b.im }
    }

    /// × a real number.
    #[inline(always)]
    pub(crate) fn scaled(self, b: T) -> Self {
        Self { re: self.re * b, im: self.im * b }
    }

    /// |z|²
    #[inline(always)]
    pub(crate) fn norm2(self) -> T {
        self.re * self.re + self.im * self.im
    }
}
