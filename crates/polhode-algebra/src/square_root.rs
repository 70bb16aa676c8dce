//! Square roots of rational functions.

use crate::integer::square_factors;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::square_free::factors;
use crate::symbols::Symbols;

/// Product c √d of a rational function and the square root of another one.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SquareRoot {
    /// Factor c before the root.
    pub outside: RationalFunction,
    /// Radicand d under the root.
    pub inside: RationalFunction,
}

impl RationalFunction {
    /// Returns the square root, with squares taken out of it where they are those of positive
    /// factors: √(4 b² c) is 2 b √c if b is positive.
    pub fn square_root(&self, symbols: &Symbols) -> SquareRoot {
        if self.is_zero() {
            return SquareRoot { outside: Self::zero(), inside: Self::one() };
        }
        let is_positive = |p: &Polynomial| {
            p.terms().all(|(_, c)| !c.is_negative())
                && p.variables().into_iter().all(|v| symbols.is_positive(v))
        };
        let (outside_above, above) = taken_out(self.numerator(), &is_positive);
        let (outside_below, below) = taken_out(self.denominator(), &is_positive);
        let quotient = |a: &Polynomial, b: &Polynomial| Self::new(a, b).unwrap_or_else(Self::zero);
        SquareRoot { outside: quotient(&outside_above, &outside_below), inside: quotient(&above, &below) }
    }

    /// Returns c and a polynomial d of least degree with ±c √d = ±√f, where the sign is open.
    pub(crate) fn square_split(&self) -> SquareRoot {
        // √(n/d) = √(n d)/d
        let (outside, inside) = taken_out(&(self.numerator() * self.denominator()), &|_| true);
        let outside = Self::new(&outside, self.denominator()).unwrap_or_else(Self::zero);
        SquareRoot { outside, inside: Self::from(inside) }
    }
}

impl SquareRoot {
    /// Returns the value if the radicand is a number whose root is known.
    pub fn as_rational_function(&self) -> Option<RationalFunction> {
        let root = RationalFunction::square_root_of(&self.inside.as_constant()?)?;
        Some(&self.outside * root)
    }

    /// Returns the value in doubles; `None` if a symbol has no value, or the radicand is negative.
    pub fn evaluate(&self, value: &dyn Fn(crate::Symbol) -> Option<f64>) -> Option<f64> {
        let inside = self.inside.evaluate(value)?;
        (inside >= 0.0).then_some(self.outside.evaluate(value)? * inside.sqrt())
    }
}

/// Returns s and d with p = s² d, where s has the factors that may be taken out of the root.
fn taken_out(
    polynomial: &Polynomial,
    may_be_taken_out: &dyn Fn(&Polynomial) -> bool,
) -> (Polynomial, Polynomial) {
    let all = factors(polynomial);
    let (number, rest) = number_taken_out(&all.coefficient);
    let (mut outside, mut inside) = (Polynomial::constant(number), Polynomial::constant(rest));
    for (factor, exponent) in all.powers {
        let taken = if may_be_taken_out(&factor) { exponent / 2 } else { 0 };
        outside = outside * factor.pow(taken);
        inside = inside * factor.pow(exponent - 2 * taken);
    }
    (outside.reduced(), inside.reduced())
}

/// Returns s and r with c = s² r, where numerator and denominator of r have no square factor, as far
/// as it is known.
fn number_taken_out(number: &Rational) -> (Rational, Rational) {
    let kept = || (Rational::one(), number.clone());
    let Some(above) = square_factors(number.abs().numerator().clone()) else { return kept() };
    let Some(below) = square_factors(number.denominator().clone()) else { return kept() };
    let square = Rational::new(&above.0 * &above.0, &below.0 * &below.0);
    let root = Rational::new(above.0, below.0);
    match (root, square.and_then(|square| number.over(&square))) {
        (Some(root), Some(rest)) => (root, rest),
        _ => kept(),
    }
}
