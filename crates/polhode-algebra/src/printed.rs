//! Quotient of products as it is printed.

use num_bigint::BigInt;
use num_traits::One;

use crate::formula::Formula;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::square_free::factors;
use crate::symbol::Variable;
use crate::symbols::Symbols;

/// Quotient c ∏ fᵢ^kᵢ / ∏ gᵢ^lᵢ.
pub(crate) struct Printed {
    coefficient: Rational,
    above: Product,
    below: Product,
}

/// Powers of polynomials, in the order of printing.
#[derive(Clone, Default)]
struct Product(Vec<(Polynomial, u32)>);

impl Printed {
    /// Factors a quotient whose denominator is not zero.
    ///
    /// Factors that are sums have integers as coefficients, or the coefficient 1 in the leading term:
    /// whichever leaves fewer numbers in the formula. (m₁ + m₂/2)/(m₁ + m₂/4) has two, and 2 (2 m₁ +
    /// m₂)/(4 m₁ + m₂) three. If the numbers are as many, sums of first degree get the coefficient 1:
    /// ½ (m₁ + m₂/4), but 1/12 (3 r² + h²).
    pub(crate) fn new(numerator: &Polynomial, denominator: &Polynomial) -> Self {
        let (above, below) = (factors(numerator), factors(denominator));
        let coefficient = above.coefficient.over(&below.coefficient).unwrap_or_else(Rational::zero);
        let integral = Self { coefficient, above: Product(above.powers), below: Product(below.powers) };
        let monic = integral.monic();
        let is_linear = |(factor, _): &(Polynomial, u32)| factor.degree() == 1;
        let wins_tie = monic.sums().all(is_linear);
        let chosen = match monic.number_count().cmp(&integral.number_count()) {
            core::cmp::Ordering::Less => monic,
            core::cmp::Ordering::Equal if wins_tie && monic.has_unit_fractions() => monic,
            _ => integral,
        };
        chosen.unless_longer_than(numerator, denominator)
    }

    /// Returns the quotient with the coefficient 1 in the leading terms of its sums.
    fn monic(&self) -> Self {
        let mut coefficient = self.coefficient.clone();
        let mut scaled = |product: &Product, is_above: bool| {
            let factor = |(polynomial, exponent): &(Polynomial, u32)| {
                let leading = polynomial.leading().map_or_else(Rational::one, |(_, c)| c.clone());
                let power = leading.pow(*exponent);
                let quotient = if is_above { Some(&coefficient * &power) } else { coefficient.over(&power) };
                coefficient = quotient.unwrap_or_else(Rational::zero);
                let scale = Rational::one().over(&leading).unwrap_or_else(Rational::one);
                (polynomial.scaled(&scale), *exponent)
            };
            Product(product.0.iter().map(factor).collect())
        };
        let (above, below) = (scaled(&self.above, true), scaled(&self.below, false));
        Self { coefficient, above, below }
    }

    /// Returns a single sum without a coefficient before it, unless that has fewer numbers: m₁/2 +
    /// m₂/8, but 2 (a + b).
    fn unless_longer_than(self, numerator: &Polynomial, denominator: &Polynomial) -> Self {
        let one = Polynomial::one();
        let is_single =
            matches!(self.above.0[..], [(_, 1)]) && *denominator == one && numerator.term_count() > 1;
        if is_single && numbers(numerator) <= self.number_count() {
            return Self {
                coefficient: Rational::one(),
                above: Product(vec![(numerator.clone(), 1)]),
                below: Product::default(),
            };
        }
        self
    }

    /// Returns the quotient with the minus sign in a sum that has as many negative terms as positive
    /// ones, or more: (I₃ − I₁) ω₃ for −(I₁ − I₃) ω₃.
    pub(crate) fn with_fewest_signs(mut self) -> Self {
        let is_mostly_negative = |factor: &Polynomial| {
            let negative = factor.terms().filter(|(_, c)| c.is_negative()).count();
            negative > 0 && 2 * negative >= factor.term_count()
        };
        let candidate =
            |(factor, exponent): &&mut (Polynomial, u32)| exponent % 2 == 1 && is_mostly_negative(factor);
        if self.coefficient.is_negative()
            && let Some((factor, _)) = self.above.0.iter_mut().find(candidate)
        {
            *factor = factor.negated();
            self.coefficient = -self.coefficient;
        }
        self
    }

    fn sums(&self) -> impl Iterator<Item = &(Polynomial, u32)> {
        self.above.0.iter().chain(&self.below.0).filter(|(factor, _)| factor.term_count() > 1)
    }

    /// Returns the number of coefficients other than ±1.
    fn number_count(&self) -> usize {
        let is_written = |n: &BigInt| !n.magnitude().is_one();
        let [above, below] = [self.coefficient.numerator(), self.coefficient.denominator()].map(is_written);
        let outside = if self.below.0.is_empty() {
            usize::from(above || below)
        } else {
            usize::from(above) + usize::from(below)
        };
        outside + self.sums().map(|(factor, _)| numbers(factor)).sum::<usize>()
    }

    /// Returns true if all coefficients in sums are integers or their reciprocals.
    fn has_unit_fractions(&self) -> bool {
        let is_unit = |c: &Rational| c.is_integer() || c.numerator().magnitude().is_one();
        self.sums().all(|(factor, _)| factor.terms().all(|(_, c)| is_unit(c)))
    }

    /// Returns the formula.
    pub(crate) fn to_formula(&self, symbols: &Symbols) -> Formula {
        let magnitude = self.coefficient.abs();
        let whole = |n: &BigInt| Rational::from(n.clone());
        let (over, under) = (whole(magnitude.numerator()), whole(magnitude.denominator()));
        let formula = if self.below.0.is_empty() {
            self.above.with_coefficient(&magnitude, symbols)
        } else if let (Some([a, b]), Some([c, d])) = (self.above.split(), self.below.split()) {
            // Quotient of the sums times quotient of the others: (m₁ + m₂)/(m₁ + m₃) · g/b.
            let one = Rational::one();
            let [a, b, c, d] = [a, b, c, d].map(|part| part.with_coefficient(&one, symbols));
            let quotients = Formula::product(vec![a.over(c), b.over(d)]);
            if magnitude.is_one() { quotients } else { number(&magnitude).times(quotients) }
        } else {
            let above = self.above.with_coefficient(&over, symbols);
            above.over(self.below.with_coefficient(&under, symbols))
        };
        if self.coefficient.is_negative() { formula.negative() } else { formula }
    }
}

impl Product {
    /// Splits the factors into sums and others; `None` unless there are both.
    fn split(&self) -> Option<[Self; 2]> {
        let (sums, others): (Vec<_>, Vec<_>) =
            self.0.iter().cloned().partition(|(factor, _)| factor.term_count() > 1);
        (!sums.is_empty() && !others.is_empty()).then_some([Self(sums), Self(others)])
    }

    /// Returns the product with a positive coefficient.
    fn with_coefficient(&self, coefficient: &Rational, symbols: &Symbols) -> Formula {
        let mut factors = self.0.clone();
        // The order of declaration decides, of a sum by its first symbol: (m₁ + m₂) b², M (a² + b²).
        factors.sort_by_key(|(factor, _)| (factor.variables().first().copied(), factor.term_count() > 1));
        let mut formulas = Vec::new();
        let mut radicand = BigInt::one();
        for (factor, exponent) in &factors {
            match single_root(factor) {
                Some(prime) => radicand *= prime,
                None => formulas.push(powered(sum(factor, symbols), *exponent)),
            }
        }
        let coefficient = match radicand.is_one() {
            true => number(coefficient),
            false => number_with_root(coefficient, &radicand),
        };
        match (&formulas[..], &coefficient) {
            ([], _) => coefficient,
            (_, Formula::Number(one)) if one == "1" => Formula::product(formulas),
            // m/2, but 1/4 M b² and 1/2 sin θ.
            ([single], Formula::Fraction(one, below))
                if **one == Formula::integer(1) && !single.is_function() =>
            {
                single.clone().over((**below).clone())
            }
            _ => coefficient.times(Formula::product(formulas)),
        }
    }
}

/// Returns p for the polynomial √p.
fn single_root(polynomial: &Polynomial) -> Option<u32> {
    match polynomial.variables().first() {
        Some(&Variable::Root(prime)) if polynomial.term_count() == 1 => Some(prime),
        _ => None,
    }
}

fn powered(base: Formula, exponent: u32) -> Formula {
    if exponent == 1 { base } else { base.power(Formula::integer(i64::from(exponent))) }
}

/// Returns a polynomial as the sum of its terms by descending degree.
///
/// A positive term comes first if the order among terms is free, that is among those of one degree
/// and in sums of two: I₃ − I₁ and 1 − cos θ.
fn sum(polynomial: &Polynomial, symbols: &Symbols) -> Formula {
    let mut terms: Vec<(&Monomial, &Rational)> = polynomial.terms().collect();
    let is_free =
        terms.len() == 2 || terms.iter().all(|(monomial, _)| monomial.degree() == polynomial.degree());
    if let Some(first) = terms.iter().position(|(_, c)| !c.is_negative()).filter(|_| is_free) {
        terms[..=first].rotate_right(1);
    }
    Formula::sum(terms.into_iter().map(|(monomial, c)| term(monomial, c, symbols)).collect())
}

fn term(monomial: &Monomial, coefficient: &Rational, symbols: &Symbols) -> Formula {
    if let ([(variable, 1)], true) = (monomial.powers(), coefficient.is_one()) {
        return symbol(*variable, symbols);
    }
    let powers =
        monomial.powers().iter().map(|&(variable, exponent)| (Polynomial::variable(variable), exponent));
    let product = Product(powers.collect()).with_coefficient(&coefficient.abs(), symbols);
    if coefficient.is_negative() { product.negative() } else { product }
}

fn symbol(variable: Variable, symbols: &Symbols) -> Formula {
    match variable {
        Variable::Root(prime) => Formula::integer(i64::from(prime)).root(),
        Variable::Symbol(symbol) => symbols.notation(symbol),
        Variable::Sine(angle) => symbols.notation(angle).applied("sin"),
        Variable::Cosine(angle) => symbols.notation(angle).applied("cos"),
    }
}

/// Returns a number that is not negative.
fn number(value: &Rational) -> Formula {
    let digits = |n: &BigInt| Formula::Number(n.to_string());
    match value.is_integer() {
        true => digits(value.numerator()),
        false => digits(value.numerator()).over(digits(value.denominator())),
    }
}

/// Returns 3 √5/2 for 3/2 and 5.
fn number_with_root(value: &Rational, radicand: &BigInt) -> Formula {
    let root = Formula::Number(radicand.to_string()).root();
    let above = match value.numerator().is_one() {
        true => root,
        false => Formula::Number(value.numerator().to_string()).times(root),
    };
    if value.is_integer() { above } else { above.over(Formula::Number(value.denominator().to_string())) }
}

fn numbers(polynomial: &Polynomial) -> usize {
    let one = Rational::one();
    polynomial.terms().filter(|(_, c)| c.abs() != one).count()
}
