//! Numbers between two bounds, rounded outward: what is proved with them holds of the real numbers.

use core::ops::{Add, Mul, Neg, Sub};

/// From `low` to `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Interval {
    pub(super) const ZERO: Self = Self { low: 0.0, high: 0.0 };
    pub(super) const ONE: Self = Self { low: 1.0, high: 1.0 };

    fn outward(low: f64, high: f64) -> Self {
        Self { low: low.next_down(), high: high.next_up() }
    }

    pub(super) const fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// The greatest magnitude in it.
    pub(super) fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    pub(super) fn is_zero(self) -> bool {
        self == Self::ZERO
    }

    pub(super) fn square(self) -> Self {
        let square = self * self;
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { square.low };
        Self { low: least.max(0.0), high: square.high }
    }

    /// The root; of what is below zero by rounding, zero.
    pub(super) fn sqrt(self) -> Self {
        let root = Self::outward(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Self { low: root.low.max(0.0), ..root }
    }

    /// Over a positive number.
    pub(super) fn over(self, by: Self) -> Self {
        let all = [self.low / by.low, self.low / by.high, self.high / by.low, self.high / by.high];
        let least = all.iter().fold(f64::INFINITY, |least, x| least.min(*x));
        Self::outward(least, all.iter().fold(f64::NEG_INFINITY, |most, x| most.max(*x)))
    }
}

impl From<f64> for Interval {
    fn from(x: f64) -> Self {
        Self { low: x, high: x }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        // Sums with zero are exact.
        if self.is_zero() {
            return b;
        }
        if b.is_zero() { self } else { Self::outward(self.low + b.low, self.high + b.high) }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        if self.is_zero() || b.is_zero() {
            return Self::ZERO;
        }
        if self == Self::ONE {
            return b;
        }
        if b == Self::ONE {
            return self;
        }
        let all = [self.low * b.low, self.low * b.high, self.high * b.low, self.high * b.high];
        let least = all.iter().fold(f64::INFINITY, |least, x| least.min(*x));
        Self::outward(least, all.iter().fold(f64::NEG_INFINITY, |most, x| most.max(*x)))
    }
}

impl core::iter::Sum for Interval {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::ZERO, |sum, x| sum + x)
    }
}

/// a·b
pub(super) fn dot<const N: usize>(a: &[Interval; N], b: &[Interval; N]) -> Interval {
    a.iter().zip(b).map(|(a, b)| *a * *b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_contain_what_is_exact() {
        // 0.1, 0.2 and 0.3 are not what they are called; their sums and products in integers of 2⁻¹²⁰ are.
        let exact = |x: f64| {
            let bits = x.to_bits();
            let exponent = (bits >> 52 & 0x7ff) as i32 - 1075;
            i128::from(bits & ((1 << 52) - 1) | 1 << 52) << (exponent + 60)
        };
        let (a, b) = (0.1, 0.2);
        let sum = Interval::from(a) + Interval::from(b);
        assert!(exact(sum.low) < exact(a) + exact(b) && exact(a) + exact(b) < exact(sum.high));
        let third = Interval::ONE.over(Interval::from(3.0));
        let product = third * Interval::from(3.0);
        assert!(product.low < 1.0 && product.high > 1.0 && product.high - product.low < 1e-15);
        let root = Interval::from(2.0).sqrt();
        assert!(root.square().low < 2.0 && root.square().high > 2.0);
        let wide = Interval { low: -2.0, high: 3.0 };
        assert_eq!(wide.square().low, 0.0);
        assert!(wide.square().high >= 9.0 && (wide * -wide).low <= -9.0 && (wide * -wide).high >= 6.0);
    }
}
