//! Double-double numbers with about 31 digits.
//!
//! Source: T. J. Dekker, Numer. Math. 18 (1971) 224.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Sum of two doubles, the second below half an ulp of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Double(pub(crate) f64, pub(crate) f64);

impl Double {
    pub(crate) const ZERO: Self = Self(0.0, 0.0);

    pub(crate) const fn of(x: f64) -> Self {
        Self(x, 0.0)
    }

    pub(crate) fn sqrt(self) -> Self {
        // One Newton step from the root of the first word.
        let root = Self::of(self.0.sqrt());
        root + (self - root * root) / (root + root)
    }
}

fn two_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let part = sum - a;
    Double(sum, (a - (sum - part)) + (b - part))
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (Double(high, low), Double(more, least)) = (two_sum(self.0, other.0), two_sum(self.1, other.1));
        let Double(high, low) = two_sum(high, low + more);
        two_sum(high, low + least)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let rest = self.0.mul_add(other.0, -product);
        two_sum(product, rest + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = Self::of(self.0 / other.0);
        let rest = self - first * other;
        first
            + Self::of(rest.0 / other.0)
            + Self::of(((rest - Self::of(rest.0 / other.0) * other).0) / other.0)
    }
}

#[test]
fn arithmetic_has_thirty_digits() {
    let third = Double::of(1.0) / Double::of(3.0);
    let rest = third * Double::of(3.0) - Double::of(1.0);
    assert!(rest.0.abs() < 1e-31, "{rest:?}");
    let root = Double::of(2.0).sqrt();
    let rest = root * root - Double::of(2.0);
    assert!(rest.0.abs() < 1e-31 && root.1 != 0.0, "{rest:?}");
    let cancelled = (Double::of(1e16) + Double::of(0.3)) - Double::of(1e16);
    assert_eq!(cancelled.0, 0.3);
}
