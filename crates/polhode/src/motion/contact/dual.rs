//! Dual numbers: a value with its derivative in one direction.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::algebra::Field;

/// Dual number a + b ε with ε² = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dual {
    pub(super) value: f64,
    pub(super) slope: f64,
}

impl Dual {
    pub(super) const ONE: Self = Self { value: 1.0, slope: 0.0 };

    pub(super) const fn new(value: f64, slope: f64) -> Self {
        Self { value, slope }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self::new(self.value + b.value, self.slope + b.slope)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self::new(self.value - b.value, self.slope - b.slope)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::new(self.value * b.value, self.value * b.slope + self.slope * b.value)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let quotient = self.value / b.value;
        Self::new(quotient, (self.slope - quotient * b.slope) / b.value)
    }
}

impl Field for Dual {
    fn times(self, constant: f64) -> Self {
        Self::new(self.value * constant, self.slope * constant)
    }

    fn root(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, 0.5 * self.slope / root)
    }
}
