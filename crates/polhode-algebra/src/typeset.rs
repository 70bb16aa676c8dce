//! Values as formulas, in the order that is customary in physics: coefficient, symbols as declared,
//! functions; sums by descending degree; common factors outside.

use core::cmp::Reverse;

use crate::formula::{Fence, Formula, Operator};
use crate::gcd::gcd;
use crate::matrix::Matrix;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::printed::Printed;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::roots::RootPair;
use crate::square_root::SquareRoot;
use crate::symbol::{Symbol, Variable};
use crate::symbols::Symbols;
use crate::univariate::Univariate;
use crate::vector::Vector;

impl RationalFunction {
    /// Returns the value with its common factors outside: −(m₁ + m₂) b² ω² sin α cos α.
    pub fn to_formula(&self, symbols: &Symbols) -> Formula {
        let (numerator, denominator) = with_fewest_terms(self);
        Printed::new(&numerator, &denominator).with_fewest_signs().to_formula(symbols)
    }

    /// Returns the numerator as a sum over the powers of some variables, with the coefficient of each
    /// as [`to_formula`](Self::to_formula) has it: ½ (m₁ + m₂/4) b² θ̇² + (m₁ + m₂/2) g b cos θ.
    pub fn collected(&self, variables: &[Variable], symbols: &Symbols) -> Formula {
        let (numerator, denominator) = with_fewest_terms(self);
        let mut groups: Vec<(Monomial, Polynomial)> = Vec::new();
        for (monomial, coefficient) in numerator.terms() {
            let powers = monomial.powers().iter().filter(|(variable, _)| variables.contains(variable));
            let key =
                powers.fold(Monomial::one(), |key, &(v, exponent)| key.times(&Monomial::power(v, exponent)));
            let term = Polynomial::term(coefficient.clone(), monomial.clone());
            match groups.iter_mut().find(|(other, _)| *other == key) {
                Some((_, sum)) => *sum = &*sum + term,
                None => groups.push((key, term)),
            }
        }
        groups.sort_by_key(|(key, _)| Reverse(key.clone()));
        let terms = groups.iter().map(|(_, sum)| Printed::new(sum, &denominator).to_formula(symbols));
        Formula::sum(terms.collect())
    }

    /// Returns the value as a sum of products without parentheses.
    pub fn expanded(&self, symbols: &Symbols) -> Formula {
        let all: Vec<Variable> = self.numerator().variables().into_iter().collect();
        self.collected(&all, symbols)
    }
}

impl SquareRoot {
    /// Returns c √d.
    pub fn to_formula(&self, symbols: &Symbols) -> Formula {
        match self.inside.as_constant() {
            Some(inside) if inside.is_one() => self.outside.to_formula(symbols),
            _ => with_factor(&self.outside, self.inside.to_formula(symbols).root(), symbols),
        }
    }
}

impl RootPair {
    /// Returns (a ± c √d)/q.
    pub fn to_formula(&self, symbols: &Symbols) -> Formula {
        let [center, outside] = [&self.center, &self.deviation.outside];
        let denominator = crate::gcd::lcm(center.denominator(), outside.denominator());
        let content = center.numerator().content().gcd(&outside.numerator().content());
        let number = Rational::from(content.denominator().clone());
        let scale = RationalFunction::from(denominator.scaled(&number));
        // ± covers both signs of the deviation.
        let outside = outside * &scale;
        let is_negative = outside.numerator().content().is_negative();
        let outside = if is_negative { -outside } else { outside };
        let deviation = SquareRoot { outside, inside: self.deviation.inside.clone() }.to_formula(symbols);
        let above = match self.center.is_zero() {
            true => Formula::Operation(Operator::PlusMinus, vec![deviation]),
            false => {
                let center = (center * &scale).to_formula(symbols);
                Formula::Operation(Operator::PlusMinus, vec![center, deviation])
            }
        };
        if scale.as_constant().is_some_and(|scale| scale.is_one()) {
            return above;
        }
        above.over(scale.to_formula(symbols))
    }
}

impl Univariate {
    /// Returns the sum over the powers of an unknown: λ³ − 2 M b² λ² + ….
    pub fn to_formula(&self, unknown: &Formula, symbols: &Symbols) -> Formula {
        let powers = self.coefficients().iter().enumerate().rev().filter(|(_, c)| !c.is_zero());
        let terms = powers.map(|(power, coefficient)| {
            let power = match power {
                0 => return coefficient.to_formula(symbols),
                1 => unknown.clone(),
                _ => unknown.clone().power(Formula::integer(power as i64)),
            };
            with_factor(coefficient, power, symbols)
        });
        Formula::sum(terms.collect())
    }
}

impl Vector {
    /// Returns the components in parentheses: (1, 1, −2).
    pub fn to_formula(&self, symbols: &Symbols) -> Formula {
        let components = self.0.iter().map(|component| component.to_formula(symbols)).collect();
        Formula::List(components).grouped(Fence::Parentheses)
    }

    /// Returns the sum of components and unit vectors: ω sin α ŷ + ω cos α ẑ.
    pub fn in_basis(&self, basis: &[Formula; 3], symbols: &Symbols) -> Formula {
        let terms = self.0.iter().zip(basis).filter(|(component, _)| !component.is_zero());
        Formula::sum(terms.map(|(component, unit)| with_factor(component, unit.clone(), symbols)).collect())
    }
}

impl Matrix {
    /// Returns the elements in brackets.
    pub fn to_formula(&self, fence: Fence, symbols: &Symbols) -> Formula {
        let row = |row: &[RationalFunction; 3]| row.iter().map(|e| e.to_formula(symbols)).collect();
        Formula::Matrix(fence, self.0.iter().map(row).collect())
    }

    /// Returns the common factor and the matrix of the rest: M b² and a matrix of numbers. A number
    /// that all elements share is in the factor, so that the matrix has only 0, 1 and −1.
    pub fn factored_formula(&self, fence: Fence, symbols: &Symbols) -> Formula {
        let (mut factor, mut rest) = self.factored();
        let numbers = rest.0.iter().flatten().map(RationalFunction::as_constant);
        let sizes: Option<Vec<Rational>> = numbers.map(|number| Some(number?.abs())).collect();
        let mut sizes = sizes.unwrap_or_default().into_iter().filter(|size| !size.is_zero());
        if let Some(first) = sizes.next().filter(|first| sizes.all(|size| size == *first))
            && let Some(inverse) = Rational::one().over(&first)
        {
            (factor, rest) = (factor.scaled(&first), rest.map(|element| element.scaled(&inverse)));
        }
        with_factor(&factor, rest.to_formula(fence, symbols), symbols)
    }
}

/// Returns the product of a value and a formula, without a factor of 1.
fn with_factor(value: &RationalFunction, formula: Formula, symbols: &Symbols) -> Formula {
    match value.as_constant() {
        Some(one) if one.is_one() => formula,
        Some(one) if (-&one).is_one() => formula.negative(),
        _ => value.to_formula(symbols).times(formula),
    }
}

/// Returns numerator and denominator with sin² θ in place of 1 − cos² θ where that leaves fewer
/// terms.
fn with_fewest_terms(value: &RationalFunction) -> (Polynomial, Polynomial) {
    let (mut numerator, mut denominator) = (value.numerator().clone(), value.denominator().clone());
    for symbol in value.symbols() {
        let count = |[n, d]: &[Polynomial; 2]| n.term_count() + d.term_count();
        let old = [numerator, denominator];
        let everywhere = old.each_ref().map(|p| in_sines(p, symbol));
        let best = if count(&everywhere) < count(&old) { everywhere } else { old };
        let [above, below] = best.each_ref().map(|p| with_sine_pairs(p, symbol));
        // sin θ/(1 − cos² θ) = 1/sin θ
        let divisor = gcd(&above, &below);
        let quotient = |p: &Polynomial| p.over(&divisor).unwrap_or_default();
        (numerator, denominator) = (quotient(&above), quotient(&below));
    }
    (numerator, denominator)
}

/// Returns a polynomial with 1 − sin² θ in place of cos² θ.
fn in_sines(polynomial: &Polynomial, angle: Symbol) -> Polynomial {
    let cosine = Polynomial::variable(Variable::Cosine(angle));
    let square = Polynomial::one() - Polynomial::variable(Variable::Sine(angle)).pow(2);
    let coefficients = polynomial.coefficients_in(Variable::Cosine(angle)).into_iter().enumerate();
    coefficients.fold(Polynomial::zero(), |sum, (power, coefficient)| {
        let power = power as u32;
        sum + coefficient * cosine.pow(power % 2) * square.pow(power / 2)
    })
}

/// Returns a polynomial with a sin² θ in place of each pair of terms a − a cos² θ.
fn with_sine_pairs(polynomial: &Polynomial, angle: Symbol) -> Polynomial {
    let square = Monomial::power(Variable::Cosine(angle), 2);
    let difference = Polynomial::one() - Polynomial::term(Rational::one(), square.clone());
    let sine = Polynomial::variable(Variable::Sine(angle)).pow(2);
    let mut result = polynomial.clone();
    for (monomial, coefficient) in polynomial.terms() {
        let Some(rest) = monomial.over(&square) else { continue };
        let has_pair = result.terms().any(|(other, c)| *other == rest && *c == -coefficient);
        if has_pair && result.terms().any(|(other, c)| other == monomial && c == coefficient) {
            let factor = Polynomial::term(-coefficient, rest);
            result = result - &factor * &difference + factor * &sine;
        }
    }
    result
}
