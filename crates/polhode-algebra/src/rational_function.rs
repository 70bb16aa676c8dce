//! Rational functions: quotients of polynomials in canonical form.

use crate::gcd::gcd;
use crate::integer::square_factors;
use crate::monomial::Monomial;
use crate::operators::operators;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::symbol::{Symbol, Variable};

/// Quotient of two polynomials in symbols, sines, cosines and square roots of primes.
///
/// The form is canonical, so that `==` decides identities: each √p and sin θ has an exponent of at
/// most 1 in the numerator and does not occur in the denominator; the two have no common divisor;
/// the denominator has integer coefficients without a common divisor, the leading one positive.
///
/// Reason: over the field F of quotients in symbols and cosines, the products of different √p and
/// sin θ are a basis of the field that they generate, because each square is in F and no product of
/// them is. A denominator is in F after multiplication by its conjugates.
///
/// sin 2θ is written with sin θ and cos θ, and θ is a symbol unrelated to them.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// Returns a quotient in canonical form; `None` if the denominator is zero.
    pub fn new(numerator: &Polynomial, denominator: &Polynomial) -> Option<Self> {
        let (mut numerator, mut denominator) = (numerator.reduced(), denominator.reduced());
        while let Some(variable) = denominator.variables().into_iter().rev().find(|v| v.is_algebraic()) {
            // (a + b s)(a − b s) = a² − b² s², without s.
            let conjugate = denominator.substituted(variable, &-Polynomial::variable(variable));
            numerator = (numerator * &conjugate).reduced();
            denominator = (denominator * &conjugate).reduced();
        }
        Self::cancelled(&numerator, &denominator)
    }

    /// Divides reduced polynomials by their gcd; the denominator has no algebraic variables.
    fn cancelled(numerator: &Polynomial, denominator: &Polynomial) -> Option<Self> {
        if denominator.is_zero() {
            return None;
        }
        let divisor = gcd(numerator, denominator);
        let (numerator, denominator) = (numerator.over(&divisor)?, denominator.over(&divisor)?);
        Some(Self { numerator, denominator }.with_primitive_denominator())
    }

    /// Returns the numerator.
    pub const fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// Returns the denominator, which is primitive and has no √p and sin θ.
    pub const fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Returns the function zero.
    pub fn zero() -> Self {
        Self::from(0)
    }

    /// Returns the function one.
    pub fn one() -> Self {
        Self::from(1)
    }

    /// Returns √n as a product of an integer and square roots of primes; `None` for a number that
    /// is negative, or whose factors cannot be found by trial division up to 2¹⁶.
    pub fn square_root_of(number: &Rational) -> Option<Self> {
        // √(a/b) = √(a b)/b
        let (outside, primes) = square_factors(number.numerator() * number.denominator())?;
        let scale = Rational::new(outside, number.denominator().clone())?;
        let roots = primes.into_iter().map(|p| Self::from(Variable::Root(p)));
        Some(roots.fold(Self::from(scale), |product, root| product * root))
    }

    /// Returns true if the function is zero.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns true if the function is a polynomial.
    pub fn is_polynomial(&self) -> bool {
        self.denominator == Polynomial::one()
    }

    /// Returns the value of a function without variables.
    pub fn as_constant(&self) -> Option<Rational> {
        self.numerator.as_constant().filter(|_| self.is_polynomial())
    }

    /// Returns the sum. Only the gcd of the denominators may have a divisor in common with the new
    /// numerator (Knuth, *The Art of Computer Programming*, §4.5.1).
    pub fn plus(&self, other: &Self) -> Self {
        let divisor = gcd(&self.denominator, &other.denominator);
        let [left, right] = [self, other].map(|f| f.denominator.over(&divisor).unwrap_or_default());
        let sum = &self.numerator * &right + &other.numerator * &left;
        let common = gcd(&sum, &divisor);
        let [above, rest] = [&sum, &divisor].map(|p| p.over(&common).unwrap_or_default());
        Self { numerator: above, denominator: left * right * rest }.with_primitive_denominator()
    }

    /// Returns the product, after division by the gcds of a numerator and the other denominator.
    pub fn times(&self, other: &Self) -> Self {
        let [a, b] = [(self, other), (other, self)].map(|(f, g)| {
            let divisor = gcd(&f.numerator, &g.denominator);
            [&f.numerator, &g.denominator].map(|p| p.over(&divisor).unwrap_or_default())
        });
        let (above, below) = (&a[0] * &b[0], &a[1] * &b[1]);
        let reduced = above.reduced();
        if reduced == above {
            return Self { numerator: above, denominator: below }.with_primitive_denominator();
        }
        // sin² θ = 1 − cos² θ may have a divisor in common with the denominator.
        Self::cancelled(&reduced, &below).unwrap_or_else(Self::zero)
    }

    fn with_primitive_denominator(self) -> Self {
        match Rational::one().over(&self.denominator.content()) {
            Some(scale) if !scale.is_one() => Self {
                numerator: self.numerator.scaled(&scale),
                denominator: self.denominator.scaled(&scale),
            },
            _ => self,
        }
    }

    /// Returns the function with the other sign.
    pub fn negated(&self) -> Self {
        Self { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    /// Returns the product with a number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self { numerator: self.numerator.scaled(factor), denominator: self.denominator.clone() }
    }

    /// Returns the quotient; `None` if the divisor is zero.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        Self::new(&(&self.numerator * &divisor.denominator), &(&self.denominator * &divisor.numerator))
    }

    /// Returns the power; `None` for a negative power of zero.
    pub fn pow(&self, exponent: i32) -> Option<Self> {
        let power = |p: &Polynomial| p.pow(exponent.unsigned_abs());
        let (above, below) = (power(&self.numerator), power(&self.denominator));
        if exponent < 0 { Self::new(&below, &above) } else { Self::new(&above, &below) }
    }

    /// Returns the function with a value in place of each variable; `None` for a denominator of
    /// zero, or if a value is missing.
    pub fn replaced(&self, value: &dyn Fn(Variable) -> Option<Self>) -> Option<Self> {
        replaced(&self.numerator, value)?.over(&replaced(&self.denominator, value)?)
    }

    /// Returns true if every coefficient is positive, and no sine or cosine occurs, so that the
    /// function is positive wherever all symbols are.
    pub fn has_positive_coefficients(&self) -> bool {
        let is_angle = |v: &Variable| matches!(v, Variable::Sine(_) | Variable::Cosine(_));
        let is_positive =
            |p: &Polynomial| p.terms().all(|(_, c)| !c.is_negative()) && !p.variables().iter().any(is_angle);
        !self.is_zero() && is_positive(&self.numerator) && is_positive(&self.denominator)
    }
}

/// Returns the value of a polynomial with a value in place of each variable.
fn replaced(
    polynomial: &Polynomial,
    value: &dyn Fn(Variable) -> Option<RationalFunction>,
) -> Option<RationalFunction> {
    let mut sum = RationalFunction::zero();
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = RationalFunction::from(coefficient.clone());
        for &(variable, exponent) in monomial.powers() {
            product = product * value(variable)?.pow(i32::try_from(exponent).ok()?)?;
        }
        sum = sum + product;
    }
    Some(sum)
}

operators!(RationalFunction);

impl From<Polynomial> for RationalFunction {
    fn from(value: Polynomial) -> Self {
        Self { numerator: value.reduced(), denominator: Polynomial::one() }
    }
}

impl From<Rational> for RationalFunction {
    fn from(value: Rational) -> Self {
        Self::from(Polynomial::constant(value))
    }
}

impl From<i64> for RationalFunction {
    fn from(value: i64) -> Self {
        Self::from(Rational::from(value))
    }
}

impl From<Variable> for RationalFunction {
    fn from(variable: Variable) -> Self {
        Self::from(Polynomial::term(Rational::one(), Monomial::power(variable, 1)))
    }
}

impl From<Symbol> for RationalFunction {
    fn from(symbol: Symbol) -> Self {
        Self::from(Variable::Symbol(symbol))
    }
}
