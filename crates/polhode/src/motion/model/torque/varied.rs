//! Numbers and vectors of a graph with their derivative in one direction. A law evaluated over them
//! also records the operations of its derivative.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::recorder::{NumberNode, VectorNode};
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::formula::{Binary, Unary};

/// Number and its derivative; `None` if the derivative is zero.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct VariedNumber<'r> {
    pub(super) value: NumberNode<'r>,
    pub(super) slope: Option<NumberNode<'r>>,
}

/// Vector and its derivative; `None` if the derivative is zero.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct VariedVector<'r> {
    pub(super) value: VectorNode<'r>,
    pub(super) slope: Option<VectorNode<'r>>,
}

/// Returns a + b, where `None` is zero.
fn sum<T: Add<Output = T>>(a: Option<T>, b: Option<T>) -> Option<T> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a + b),
        (one, other) => one.or(other),
    }
}

/// Returns a − b, where `None` is zero.
fn difference<T: Sub<Output = T> + Neg<Output = T>>(a: Option<T>, b: Option<T>) -> Option<T> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a - b),
        (a, None) => a,
        (None, Some(b)) => Some(-b),
    }
}

impl<'r> VariedNumber<'r> {
    /// Returns f(a) with the derivative f′(a) a′.
    fn chain(self, value: NumberNode<'r>, rate: impl FnOnce(NumberNode<'r>) -> NumberNode<'r>) -> Self {
        Self { value, slope: self.slope.map(rate) }
    }

    /// Returns q = a/b with q′ = (a′ − q b′)/b.
    fn quotient(self, b: Self, value: NumberNode<'r>) -> Self {
        let slope = difference(self.slope, b.slope.map(|b| value * b)).map(|slope| slope / b.value);
        Self { value, slope }
    }
}

impl Neg for VariedNumber<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: self.slope.map(|a| -a) }
    }
}

impl Add for VariedNumber<'_> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self { value: self.value + b.value, slope: sum(self.slope, b.slope) }
    }
}

impl Sub for VariedNumber<'_> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self { value: self.value - b.value, slope: difference(self.slope, b.slope) }
    }
}

impl Mul for VariedNumber<'_> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let (left, right) = (self.slope.map(|a| a * b.value), b.slope.map(|b| self.value * b));
        Self { value: self.value * b.value, slope: sum(left, right) }
    }
}

impl Div for VariedNumber<'_> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        self.quotient(b, self.value / b.value)
    }
}

impl Scalar for VariedNumber<'_> {
    fn scaled(self, by: f64) -> Self {
        Self { value: self.value.scaled(by), slope: self.slope.map(|a| a.scaled(by)) }
    }

    fn unary(self, function: Unary) -> Self {
        let x = self.value;
        let one = || x.constant(1.0);
        let value = x.unary(function);
        match function {
            Unary::Negate => -self,
            Unary::Sqrt => self.chain(value, |slope| slope / value.scaled(2.0)),
            Unary::Exp => self.chain(value, |slope| slope * value),
            Unary::Log => self.chain(value, |slope| slope / x),
            Unary::Sin => self.chain(value, |slope| slope * x.unary(Unary::Cos)),
            Unary::Cos => self.chain(value, |slope| -(slope * x.unary(Unary::Sin))),
            Unary::Tan => self.chain(value, |slope| slope * (one() + value * value)),
            Unary::Asin => self.chain(value, |slope| slope / ((one() - x) * (one() + x)).sqrt()),
            Unary::Acos => self.chain(value, |slope| -(slope / ((one() - x) * (one() + x)).sqrt())),
            Unary::Atan => self.chain(value, |slope| slope / (one() + x * x)),
            Unary::Sinh => self.chain(value, |slope| slope * x.unary(Unary::Cosh)),
            Unary::Cosh => self.chain(value, |slope| slope * x.unary(Unary::Sinh)),
            Unary::Tanh => self.chain(value, |slope| slope * (one() - value * value)),
            Unary::Log1p => self.chain(value, |slope| slope / (one() + x)),
            Unary::Expm1 => self.chain(value, |slope| slope * x.unary(Unary::Exp)),
            Unary::Power(0) => Self { value, slope: None },
            Unary::Power(n) => {
                self.chain(value, |slope| slope * x.unary(Unary::Power(n - 1)).scaled(f64::from(n)))
            }
            // The value has no series, so its derivative has none either.
            Unary::Abs | Unary::Floor => self.chain(value, |_| value),
        }
    }

    fn binary(self, function: Binary, b: Self) -> Self {
        let a = self;
        match function {
            Binary::Add => a + b,
            Binary::Subtract => a - b,
            Binary::Multiply => a * b,
            Binary::Divide => a / b,
            Binary::Power => {
                let value = a.value.binary(function, b.value);
                let of_base = a.slope.map(|slope| match b.value.value() {
                    Some(p) => slope * a.value.binary(function, a.value.constant(p - 1.0)).scaled(p),
                    None => slope * b.value * value / a.value,
                });
                // ∂aᵇ/∂b = aᵇ log a
                let of_exponent = b.slope.map(|slope| slope * value * a.value.unary(Unary::Log));
                Self { value, slope: sum(of_base, of_exponent) }
            }
            // θ′ = (x y′ − y x′)/(x² + y²), y first
            Binary::Atan2 => {
                let (y, x) = (a.value, b.value);
                let turn = difference(a.slope.map(|slope| x * slope), b.slope.map(|slope| y * slope));
                let slope = turn.map(|turn| turn / (x * x + y * y));
                Self { value: y.binary(function, x), slope }
            }
            // h′ = (a a′ + b b′)/h
            Binary::Hypot => {
                let value = a.value.binary(function, b.value);
                let growth = sum(a.slope.map(|slope| a.value * slope), b.slope.map(|slope| b.value * slope));
                Self { value, slope: growth.map(|growth| growth / value) }
            }
            // These have no series, so their derivatives have none either.
            Binary::Min
            | Binary::Max
            | Binary::Mod
            | Binary::Less
            | Binary::LessOrEqual
            | Binary::Greater
            | Binary::GreaterOrEqual
            | Binary::And
            | Binary::Or => {
                let value = a.value.binary(function, b.value);
                Self { value, slope: a.slope.or(b.slope).map(|_| value) }
            }
        }
    }

    fn power(self, p: f64) -> Self {
        let x = self.value;
        self.chain(x.power(p), |slope| slope * x.power(p - 1.0).scaled(p))
    }

    fn power_difference(self, delta: Self, p: f64) -> Self {
        // D(p) = aᵖ − sᵖ, s = a + δ: D(p)′ = p (D(p−1) a′ − sᵖ⁻¹ δ′)
        let (a, of) = (self.value, delta.value);
        let of_base = self.slope.map(|slope| slope * a.power_difference(of, p - 1.0));
        let of_delta = delta.slope.map(|slope| slope * (a + of).power(p - 1.0));
        let slope = difference(of_base, of_delta).map(|slope| slope.scaled(p));
        Self { value: a.power_difference(of, p), slope }
    }

    /// The derivative is undefined where the divisor is zero.
    fn over_or_zero(self, d: Self) -> Self {
        self.quotient(d, self.value.over_or_zero(d.value))
    }

    fn wrapped(self) -> Self {
        Self { value: self.value.wrapped(), slope: self.slope }
    }

    fn half_angle_over_sine(self) -> Self {
        let x = self.value;
        self.chain(x.half_angle_over_sine(), |slope| slope * x.half_angle_slope())
    }
}

impl Neg for VariedVector<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: self.slope.map(|a| -a) }
    }
}

impl Add for VariedVector<'_> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self { value: self.value + b.value, slope: sum(self.slope, b.slope) }
    }
}

impl Sub for VariedVector<'_> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Self { value: self.value - b.value, slope: difference(self.slope, b.slope) }
    }
}

impl<'r> Mul<VariedNumber<'r>> for VariedVector<'r> {
    type Output = Self;
    fn mul(self, b: VariedNumber<'r>) -> Self {
        let (left, right) = (self.slope.map(|a| a * b.value), b.slope.map(|b| self.value * b));
        Self { value: self.value * b.value, slope: sum(left, right) }
    }
}

impl<'r> VectorAlgebra<VariedNumber<'r>> for VariedVector<'r> {
    fn scaled(self, by: f64) -> Self {
        Self { value: self.value.scaled(by), slope: self.slope.map(|a| a.scaled(by)) }
    }

    fn dot(self, b: Self) -> VariedNumber<'r> {
        let (left, right) = (self.slope.map(|a| a.dot(b.value)), b.slope.map(|b| self.value.dot(b)));
        VariedNumber { value: self.value.dot(b.value), slope: sum(left, right) }
    }

    fn cross(self, b: Self) -> Self {
        let (left, right) = (self.slope.map(|a| a.cross(b.value)), b.slope.map(|b| self.value.cross(b)));
        Self { value: self.value.cross(b.value), slope: sum(left, right) }
    }

    /// |v|′ = v · v′/|v|
    fn norm(self) -> VariedNumber<'r> {
        let value = self.value.norm();
        VariedNumber { value, slope: self.slope.map(|slope| self.value.dot(slope) / value) }
    }
}
