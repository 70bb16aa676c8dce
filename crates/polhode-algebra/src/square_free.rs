//! Factors of polynomials that gcds find.

use crate::gcd::{content_in, gcd};
use crate::polynomial::Polynomial;
use crate::rational::Rational;

/// Product c ∏ fᵢ^kᵢ of a number and powers of polynomials.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factors {
    /// Number c, with the sign.
    pub coefficient: Rational,
    /// Primitive polynomials of positive degree with their exponents. They are pairwise coprime, and
    /// none is divisible by a square.
    pub powers: Vec<(Polynomial, u32)>,
}

/// Returns a polynomial as a product of powers.
///
/// It splits by contents in each variable, which separates variables and factors that do not share
/// all variables, and by multiplicity (Yun's square-free factorization: Geddes, Czapor and Labahn,
/// algorithm 8.2). Factors with the same variables and multiplicity stay together: a² − b² is one
/// factor.
pub fn factors(polynomial: &Polynomial) -> Factors {
    let mut powers = Vec::new();
    split(&polynomial.primitive(), 1, &mut powers);
    Factors { coefficient: polynomial.content(), powers }
}

/// Appends the factors of a primitive polynomial, each with its exponent times `multiplicity`.
fn split(polynomial: &Polynomial, multiplicity: u32, powers: &mut Vec<(Polynomial, u32)>) {
    let variables = polynomial.variables();
    for &variable in &variables {
        let content = content_in(polynomial, variable);
        if content.degree() > 0 {
            split(&content, multiplicity, powers);
            return split(&polynomial.over(&content).unwrap_or_default(), multiplicity, powers);
        }
    }
    let Some(&main) = variables.first() else { return };
    // Yun: with a = ∏ fᵢⁱ, g = gcd(a, a′), w = a/g, y = a′/g, z = y − w′, then fᵢ = gcd(w, z).
    let derivative = polynomial.derivative(main);
    let repeated = gcd(polynomial, &derivative);
    let mut product = polynomial.over(&repeated).unwrap_or_default();
    let mut slope = derivative.over(&repeated).unwrap_or_default();
    let mut exponent = multiplicity;
    while product.degree() > 0 {
        let rest = slope - product.derivative(main);
        let factor = if rest.is_zero() { product.primitive() } else { gcd(&product, &rest) };
        product = product.over(&factor).unwrap_or_default();
        slope = rest.over(&factor).unwrap_or_default();
        if factor.degree() > 0 {
            powers.push((factor, exponent));
        }
        exponent += multiplicity;
    }
}
