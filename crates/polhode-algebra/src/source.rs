//! Values as formulas that [`parse`](crate::parse) reads back.

use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbol::Variable;
use crate::symbols::Symbols;

impl RationalFunction {
    /// Returns the value as users write it, in canonical form: `(2*m_1*g + m_2*g)/(4*m_1*b + m_2*b)`.
    pub fn to_source(&self, symbols: &Symbols) -> String {
        let above = polynomial(self.numerator(), symbols);
        if self.is_polynomial() {
            return above;
        }
        format!("({above})/({})", polynomial(self.denominator(), symbols))
    }
}

fn polynomial(polynomial: &Polynomial, symbols: &Symbols) -> String {
    let mut out = String::new();
    for (k, (monomial, coefficient)) in polynomial.terms().enumerate() {
        out.push_str(match (k, coefficient.is_negative()) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        });
        out.push_str(&term(monomial, &coefficient.abs(), symbols));
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

fn term(monomial: &Monomial, coefficient: &Rational, symbols: &Symbols) -> String {
    let is_written = monomial.is_one() || !coefficient.is_one();
    let powers = monomial.powers().iter().map(|&(variable, exponent)| {
        let base = match variable {
            Variable::Root(prime) => format!("sqrt({prime})"),
            Variable::Symbol(symbol) => symbols.name(symbol),
            Variable::Sine(angle) => format!("sin({})", symbols.name(angle)),
            Variable::Cosine(angle) => format!("cos({})", symbols.name(angle)),
        };
        if exponent == 1 { base } else { format!("{base}^{exponent}") }
    });
    let factors: Vec<String> =
        is_written.then(|| coefficient.to_string()).into_iter().chain(powers).collect();
    factors.join("*")
}
