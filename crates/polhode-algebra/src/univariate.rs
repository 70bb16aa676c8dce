//! Polynomials in one unknown, whose coefficients are rational functions.

use crate::gcd::{gcd, lcm};
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbol::{Symbol, Variable};

/// The unknown λ as a variable, which no table of symbols declares.
const UNKNOWN: Variable = Variable::Symbol(Symbol { place: u16::MAX, order: 0 });

/// Polynomial Σ cₖ λᵏ in an unknown λ.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Univariate {
    /// Coefficients by ascending power; the last one is not zero.
    coefficients: Vec<RationalFunction>,
}

impl Univariate {
    /// Returns the polynomial with coefficients by ascending power.
    pub fn new(mut coefficients: Vec<RationalFunction>) -> Self {
        while coefficients.last().is_some_and(RationalFunction::is_zero) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// Returns λ − root.
    pub fn linear(root: &RationalFunction) -> Self {
        Self::new(vec![-root, RationalFunction::one()])
    }

    /// Returns the coefficients by ascending power.
    pub fn coefficients(&self) -> &[RationalFunction] {
        &self.coefficients
    }

    /// Returns the degree; 0 for zero.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Returns the polynomial divided by its leading coefficient.
    pub fn monic(&self) -> Self {
        let divided = |leading: &RationalFunction| {
            self.coefficients.iter().map(|c| c.over(leading)).collect::<Option<Vec<_>>>()
        };
        let monic = self.coefficients.last().and_then(divided);
        monic.map_or_else(|| self.clone(), Self::new)
    }

    /// Returns the value at a rational function.
    pub fn at(&self, value: &RationalFunction) -> RationalFunction {
        self.coefficients.iter().rev().fold(RationalFunction::zero(), |sum, c| sum * value + c)
    }

    /// Returns the derivative with respect to the unknown.
    pub fn derivative(&self) -> Self {
        let terms = self.coefficients.iter().enumerate().skip(1);
        Self::new(terms.map(|(k, c)| c.scaled(&Rational::from(k as i64))).collect())
    }

    /// Returns quotient and remainder; `None` for a divisor of zero.
    pub fn divided(&self, divisor: &Self) -> Option<(Self, Self)> {
        let leading = divisor.coefficients.last()?;
        let mut rest = self.coefficients.clone();
        let mut quotient = Vec::new();
        while rest.len() >= divisor.coefficients.len() {
            let factor = rest.pop()?.over(leading)?;
            let start = rest.len() + 1 - divisor.coefficients.len();
            for (value, c) in rest[start..].iter_mut().zip(&divisor.coefficients) {
                *value = &*value - &factor * c;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Some((Self::new(quotient), Self::new(rest)))
    }

    /// Returns the monic greatest common divisor.
    ///
    /// It is that of polynomials with λ as one of their variables (Gauss's lemma). Where √p and sin θ
    /// exclude that, Euclid's algorithm over the field of the coefficients follows (Geddes, Czapor
    /// and Labahn, algorithm 2.1).
    pub fn gcd(&self, other: &Self) -> Self {
        if !self.has_algebraic() && !other.has_algebraic() {
            let divisor = gcd(&self.integral(), &other.integral());
            let coefficients = divisor.coefficients_in(UNKNOWN).into_iter().map(RationalFunction::from);
            return Self::new(coefficients.collect()).monic();
        }
        let (mut a, mut b) = (self.clone(), other.clone());
        while let Some((_, rest)) = a.divided(&b) {
            (a, b) = (b.monic(), rest);
        }
        a.monic()
    }

    /// Returns true if √p or sin θ occurs in a coefficient.
    pub(crate) fn has_algebraic(&self) -> bool {
        self.coefficients.iter().any(|c| c.numerator().variables().into_iter().any(Variable::is_algebraic))
    }

    /// Returns a multiple that is a polynomial in the symbols of the coefficients and λ.
    fn integral(&self) -> Polynomial {
        let denominator =
            self.coefficients.iter().fold(Polynomial::one(), |all, c| lcm(&all, c.denominator()));
        let scale = RationalFunction::from(denominator);
        let coefficients: Vec<Polynomial> =
            self.coefficients.iter().map(|c| (c * &scale).numerator().clone()).collect();
        Polynomial::from_coefficients(UNKNOWN, &coefficients)
    }
}
