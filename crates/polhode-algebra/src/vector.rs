//! Vectors with three components.

use crate::gcd::{gcd_of, lcm};
use crate::operators::operators;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;

/// Vector with its components along three axes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Vector(pub [RationalFunction; 3]);

impl Vector {
    /// Returns the zero vector.
    pub fn zero() -> Self {
        Self(core::array::from_fn(|_| RationalFunction::zero()))
    }

    /// Returns the unit vector along an axis 0, 1 or 2.
    pub fn unit(axis: usize) -> Self {
        Self(core::array::from_fn(|k| RationalFunction::from(i64::from(k == axis))))
    }

    /// Returns true for the zero vector.
    pub fn is_zero(&self) -> bool {
        self.0.iter().all(RationalFunction::is_zero)
    }

    /// Returns the vector with a function applied to each component.
    pub fn map(&self, function: impl FnMut(&RationalFunction) -> RationalFunction) -> Self {
        Self(self.0.each_ref().map(function))
    }

    /// Returns the sum.
    pub fn plus(&self, other: &Self) -> Self {
        Self(core::array::from_fn(|k| &self.0[k] + &other.0[k]))
    }

    /// Returns the vector with the other direction.
    pub fn negated(&self) -> Self {
        self.map(RationalFunction::negated)
    }

    /// Returns the product with a scalar.
    pub fn scaled(&self, factor: &RationalFunction) -> Self {
        self.map(|component| component * factor)
    }

    /// Returns the scalar product.
    pub fn dot(&self, other: &Self) -> RationalFunction {
        let [x, y, z] = core::array::from_fn(|k| &self.0[k] * &other.0[k]);
        x + y + z
    }

    /// Returns the vector product.
    pub fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (&self.0, &other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Returns the parallel vector whose components are polynomials without a common divisor; of
    /// those that are not zero the first has a positive leading coefficient.
    pub fn primitive(&self) -> Self {
        let denominator = self.0.iter().fold(Polynomial::one(), |all, c| lcm(&all, c.denominator()));
        let components = self.scaled(&RationalFunction::from(denominator)).0;
        let numerators: Vec<Polynomial> = components.iter().map(|c| c.numerator().clone()).collect();
        let divisor = gcd_of(&numerators);
        let parts: Vec<Polynomial> = numerators.iter().filter_map(|n| n.over(&divisor)).collect();
        let content = parts.iter().fold(Rational::zero(), |all, part| all.gcd(&part.content()));
        let first =
            parts.iter().find(|part| !part.is_zero()).map_or_else(Rational::zero, Polynomial::content);
        let content = if first.is_negative() { -content } else { content };
        let Some(scale) = Rational::one().over(&content) else { return self.clone() };
        Self(core::array::from_fn(|k| RationalFunction::from(parts[k].scaled(&scale))))
    }
}

operators!(Vector, Add, add, |a: &Vector, b: &Vector| a.plus(b));
operators!(Vector, Sub, sub, |a: &Vector, b: &Vector| a.plus(&b.negated()));
operators!(Vector, negative);
