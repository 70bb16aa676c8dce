//! Complex numbers, no more of them than is needed.

use super::real::Real;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<T> {
    pub(crate) re: T,
    pub(crate) im: T,
}

impl<T: Real> Complex<T> {
    #[inline(always)]
    pub(crate) fn times(self, b: Self) -> Self {
        Self { re: self.re * b.re - self.im * b.im, im: self.re * b.im + self.im * b.re }
    }
}
