//! Polynomials in several variables with rational coefficients.

use std::collections::{BTreeMap, BTreeSet};

use crate::monomial::Monomial;
use crate::operators::operators;
use crate::rational::Rational;
use crate::symbol::Variable;

/// Polynomial as its terms. Coefficients are not zero, so that equal polynomials have equal terms.
///
/// √p and sin θ are variables like others here; [`Polynomial::reduced`] applies (√p)² = p and
/// sin² θ = 1 − cos² θ.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Polynomial {
    terms: BTreeMap<Monomial, Rational>,
}

impl Polynomial {
    /// Returns the polynomial zero.
    pub const fn zero() -> Self {
        Self { terms: BTreeMap::new() }
    }

    /// Returns the polynomial one.
    pub fn one() -> Self {
        Self::constant(Rational::one())
    }

    /// Returns a polynomial of degree zero.
    pub fn constant(value: Rational) -> Self {
        Self::term(value, Monomial::one())
    }

    /// Returns a variable.
    pub fn variable(variable: Variable) -> Self {
        Self::term(Rational::one(), Monomial::power(variable, 1))
    }

    /// Returns the product of a coefficient and a monomial.
    pub fn term(coefficient: Rational, monomial: Monomial) -> Self {
        let terms = [(monomial, coefficient)].into_iter().filter(|(_, c)| !c.is_zero()).collect();
        Self { terms }
    }

    /// Returns Σ cₖ xᵏ of a variable x.
    pub fn from_coefficients(variable: Variable, coefficients: &[Self]) -> Self {
        let mut sum = Self::zero();
        for (k, coefficient) in (0..).zip(coefficients) {
            sum.add(&coefficient.times(&Self::term(Rational::one(), Monomial::power(variable, k))));
        }
        sum
    }

    /// Returns the terms, the greatest monomial first.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.terms.iter().rev()
    }

    /// Returns the number of terms.
    pub fn term_count(&self) -> usize {
        self.terms.len()
    }

    /// Returns true if the polynomial is zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Returns the value of a polynomial without variables.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.first_key_value() {
            None => Some(Rational::zero()),
            Some((monomial, value)) => (monomial.is_one() && self.terms.len() == 1).then(|| value.clone()),
        }
    }

    /// Returns the term with the greatest monomial.
    pub fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.last_key_value()
    }

    /// Returns the total degree; 0 for zero.
    pub fn degree(&self) -> u32 {
        self.leading().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// Returns the largest exponent of a variable.
    pub fn degree_in(&self, variable: Variable) -> u32 {
        self.terms.keys().map(|monomial| monomial.exponent(variable)).max().unwrap_or(0)
    }

    /// Returns the variables that occur.
    pub fn variables(&self) -> BTreeSet<Variable> {
        self.terms.keys().flat_map(|monomial| monomial.powers().iter().map(|&(v, _)| v)).collect()
    }

    /// Returns the sum.
    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add(other);
        sum
    }

    fn add(&mut self, other: &Self) {
        for (monomial, coefficient) in &other.terms {
            self.add_term(monomial.clone(), coefficient);
        }
    }

    /// Adds the product of a coefficient and a monomial.
    pub(crate) fn add_term(&mut self, monomial: Monomial, coefficient: &Rational) {
        let old = self.terms.remove(&monomial).unwrap_or_else(Rational::zero);
        let new = old + coefficient;
        if !new.is_zero() {
            self.terms.insert(monomial, new);
        }
    }

    /// Returns the product.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero();
        for (m, a) in &self.terms {
            for (n, b) in &other.terms {
                product.add_term(m.times(n), &(a * b));
            }
        }
        product
    }

    /// Returns the polynomial with the other sign.
    pub fn negated(&self) -> Self {
        self.scaled(&Rational::from(-1))
    }

    /// Returns the product with a number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self { terms: self.terms.iter().map(|(m, c)| (m.clone(), c * factor)).collect() }
    }

    /// Returns the power, by repeated squaring (Knuth, *The Art of Computer Programming*, §4.6.3).
    pub fn pow(&self, exponent: u32) -> Self {
        let (mut power, mut square, mut rest) = (Self::one(), self.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                power = power.times(&square);
            }
            rest /= 2;
            if rest > 0 {
                square = square.times(&square);
            }
        }
        power
    }

    /// Returns the quotient if the divisor is not zero and divides this polynomial.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        let (first, coefficient) = divisor.leading()?;
        let (mut quotient, mut rest) = (Self::zero(), self.clone());
        while let Some((monomial, value)) = rest.leading() {
            let (factor, scale) = (monomial.over(first)?, value.over(coefficient)?);
            for (monomial, c) in &divisor.terms {
                rest.add_term(monomial.times(&factor), &-(c * &scale));
            }
            quotient.terms.insert(factor, scale);
        }
        Some(quotient)
    }

    /// Returns the partial derivative with respect to a variable, for which all others are constant.
    pub fn derivative(&self, variable: Variable) -> Self {
        let one = Monomial::power(variable, 1);
        let terms = self.terms.iter().filter_map(|(monomial, coefficient)| {
            let exponent = Rational::from(i64::from(monomial.exponent(variable)));
            Some((monomial.over(&one)?, coefficient * exponent))
        });
        Self { terms: terms.collect() }
    }

    /// Returns the coefficients as a polynomial in one variable, by ascending power.
    pub fn coefficients_in(&self, variable: Variable) -> Vec<Self> {
        let mut coefficients = vec![Self::zero(); self.degree_in(variable) as usize + 1];
        for (monomial, value) in &self.terms {
            let power = monomial.exponent(variable) as usize;
            coefficients[power].add_term(monomial.without(variable), value);
        }
        coefficients
    }

    /// Returns the polynomial with a polynomial in place of a variable.
    pub fn substituted(&self, variable: Variable, value: &Self) -> Self {
        let coefficients = self.coefficients_in(variable).into_iter().rev();
        coefficients.fold(Self::zero(), |sum, coefficient| sum.times(value) + coefficient)
    }

    /// Returns the equal polynomial with exponents of at most 1 of each √p and sin θ.
    pub fn reduced(&self) -> Self {
        let is_square = |&(v, exponent): &(Variable, u32)| v.is_algebraic() && exponent > 1;
        let mut powers = self.terms.keys().flat_map(Monomial::powers);
        let Some(&(variable, _)) = powers.find(|power| is_square(power)) else { return self.clone() };
        let mut parts = [Self::zero(), Self::zero()];
        let mut square = Self::one();
        for (k, coefficient) in self.coefficients_in(variable).iter().enumerate() {
            if k > 1 && k % 2 == 0 {
                square = square.times(&square_of(variable));
            }
            parts[k % 2].add(&coefficient.times(&square));
        }
        Self::from_coefficients(variable, &parts).reduced()
    }

    /// Returns the content: the positive rational number that leaves integers without a common
    /// divisor, with the sign of the leading coefficient (Geddes, Czapor and Labahn, §2.7). Zero has
    /// the content 0.
    pub fn content(&self) -> Rational {
        let content = self.terms.values().fold(Rational::zero(), |content, c| content.gcd(c));
        let is_negative = self.leading().is_some_and(|(_, c)| c.is_negative());
        if is_negative { -content } else { content }
    }

    /// Returns the primitive part: integer coefficients without a common divisor, the leading one
    /// positive.
    pub fn primitive(&self) -> Self {
        Rational::one().over(&self.content()).map_or_else(Self::zero, |factor| self.scaled(&factor))
    }
}

/// Returns the square of an algebraic variable as a polynomial in other variables.
fn square_of(variable: Variable) -> Polynomial {
    match variable {
        Variable::Root(prime) => Polynomial::constant(Rational::from(i64::from(prime))),
        Variable::Sine(angle) => {
            Polynomial::one() - Polynomial::term(Rational::one(), Monomial::power(Variable::Cosine(angle), 2))
        }
        other => Polynomial::term(Rational::one(), Monomial::power(other, 2)),
    }
}

operators!(Polynomial);

impl From<Rational> for Polynomial {
    fn from(value: Rational) -> Self {
        Self::constant(value)
    }
}
