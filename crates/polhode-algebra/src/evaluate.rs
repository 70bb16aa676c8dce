//! Values of rational functions.

use crate::angle::Angle;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbol::{Symbol, Variable};

impl RationalFunction {
    /// Returns the value in doubles; `None` if a symbol has no value, or for a denominator of zero.
    pub fn evaluate(&self, value: &dyn Fn(Symbol) -> Option<f64>) -> Option<f64> {
        let below = evaluated(self.denominator(), value)?;
        (below != 0.0).then_some(evaluated(self.numerator(), value)? / below)
    }

    /// Returns the exact value from a value of each variable; `None` if one is missing, or for a
    /// denominator of zero.
    pub fn evaluate_exactly(&self, value: &dyn Fn(Variable) -> Option<Rational>) -> Option<Rational> {
        let of = |polynomial: &Polynomial| {
            let mut sum = Rational::zero();
            for (monomial, coefficient) in polynomial.terms() {
                let mut product = coefficient.clone();
                for &(variable, exponent) in monomial.powers() {
                    product = product * value(variable)?.pow(exponent);
                }
                sum = sum + product;
            }
            Some(sum)
        };
        of(self.numerator())?.over(&of(self.denominator())?)
    }

    /// Returns the function with a value in place of a symbol. Its sine and cosine follow by the
    /// addition theorems.
    ///
    /// `None` for a denominator of zero; also if a sine or cosine of the symbol occurs, and the value
    /// is not an [`Angle`].
    pub fn substituted(&self, symbol: Symbol, value: &Self) -> Option<Self> {
        self.replaced(&|variable| match variable {
            Variable::Symbol(other) if other == symbol => Some(value.clone()),
            Variable::Sine(other) if other == symbol => Some(Angle::new(value)?.sine()),
            Variable::Cosine(other) if other == symbol => Some(Angle::new(value)?.cosine()),
            other => Some(Self::from(other)),
        })
    }
}

fn evaluated(polynomial: &Polynomial, value: &dyn Fn(Symbol) -> Option<f64>) -> Option<f64> {
    let mut sum = 0.0;
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = coefficient.to_f64();
        for &(variable, exponent) in monomial.powers() {
            let base = match variable {
                Variable::Root(prime) => f64::from(prime).sqrt(),
                Variable::Symbol(symbol) => value(symbol)?,
                Variable::Sine(angle) => libm::sin(value(angle)?),
                Variable::Cosine(angle) => libm::cos(value(angle)?),
            };
            product *= libm::pow(base, f64::from(exponent));
        }
        sum += product;
    }
    Some(sum)
}
