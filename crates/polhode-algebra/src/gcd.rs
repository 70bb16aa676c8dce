//! Greatest common divisors of polynomials in several variables.
//!
//! First a heuristic, which is fast and proves its result. If it does not succeed, the primitive
//! Euclidean algorithm follows (Knuth, *The Art of Computer Programming*, §4.6.1, algorithm E;
//! Geddes, Czapor and Labahn, *Algorithms for Computer Algebra*, §7.2): polynomials in one main
//! variable, whose coefficients are polynomials in the others. Remainders are divided by their
//! contents, which keeps coefficients as small as possible; the contents are gcds of fewer variables.

use std::collections::{BTreeMap, BTreeSet};

use crate::heuristic_gcd::heuristic_gcd;
use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::symbol::Variable;

/// Returns the greatest common divisor, which is primitive with a positive leading coefficient; zero
/// only for two zeros.
pub fn gcd(a: &Polynomial, b: &Polynomial) -> Polynomial {
    if a.is_zero() || b.is_zero() {
        return if a.is_zero() { b.primitive() } else { a.primitive() };
    }
    let common = monomial_content(a).gcd(&monomial_content(b));
    let common = Polynomial::term(Rational::one(), common);
    if a.term_count() == 1 || b.term_count() == 1 {
        return common;
    }
    let [a, b] = [a, b].map(|p| {
        let monomial = Polynomial::term(Rational::one(), monomial_content(p));
        p.over(&monomial).unwrap_or_default().primitive()
    });
    common.times(&of_primitive(&a, &b))
}

/// Returns the greatest common divisor of several polynomials.
pub fn gcd_of<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Polynomial {
    let mut result = Polynomial::zero();
    for polynomial in polynomials {
        result = gcd(&result, polynomial);
        if result == Polynomial::one() {
            break;
        }
    }
    result
}

/// Returns the content of a polynomial in one variable: the gcd of its coefficients.
pub fn content_in(polynomial: &Polynomial, variable: Variable) -> Polynomial {
    gcd_of(&polynomial.coefficients_in(variable))
}

/// Returns the least common multiple, primitive and with a positive leading coefficient.
pub fn lcm(a: &Polynomial, b: &Polynomial) -> Polynomial {
    a.over(&gcd(a, b)).map_or_else(Polynomial::zero, |cofactor| cofactor.times(b).primitive())
}

/// Returns the gcd of the monomials of a polynomial.
fn monomial_content(polynomial: &Polynomial) -> Monomial {
    let monomials = polynomial.terms().map(|(monomial, _)| monomial.clone());
    monomials.reduce(|a, b| a.gcd(&b)).unwrap_or_default()
}

/// Returns the gcd of primitive polynomials without monomial factors.
fn of_primitive(a: &Polynomial, b: &Polynomial) -> Polynomial {
    if a == b {
        return a.clone();
    }
    let shared: BTreeSet<Variable> = a.variables().intersection(&b.variables()).copied().collect();
    if a.variables() != shared || b.variables() != shared {
        // The gcd divides all coefficients of products of the other variables.
        let mut parts = [a, b].map(|p| coefficients_over(p, &shared)).concat();
        parts.sort_by_key(Polynomial::term_count);
        return gcd_of(&parts);
    }
    heuristic_gcd(a, b).unwrap_or_else(|| euclidean(a, b, &shared))
}

/// Returns the coefficients of a polynomial in all variables except some.
fn coefficients_over(polynomial: &Polynomial, kept: &BTreeSet<Variable>) -> Vec<Polynomial> {
    let mut parts: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (mut inside, mut outside) = (Monomial::one(), Monomial::one());
        for &(variable, exponent) in monomial.powers() {
            let part = if kept.contains(&variable) { &mut inside } else { &mut outside };
            *part = part.times(&Monomial::power(variable, exponent));
        }
        parts.entry(outside).or_default().add_term(inside, coefficient);
    }
    parts.into_values().collect()
}

/// Returns the gcd of primitive polynomials in the same variables.
fn euclidean(a: &Polynomial, b: &Polynomial, variables: &BTreeSet<Variable>) -> Polynomial {
    let degree = |variable: &&Variable| a.degree_in(**variable).min(b.degree_in(**variable));
    let Some(&main) = variables.iter().min_by_key(degree) else { return Polynomial::one() };
    let [content_a, content_b] = [a, b].map(|p| content_in(p, main));
    let content = gcd(&content_a, &content_b);
    let (mut high, mut low) =
        (a.over(&content_a).unwrap_or_default(), b.over(&content_b).unwrap_or_default());
    if high.degree_in(main) < low.degree_in(main) {
        (high, low) = (low, high);
    }
    while low.degree_in(main) > 0 {
        let rest = pseudo_remainder(&high, &low, main);
        if rest.is_zero() {
            return content.times(&low).primitive();
        }
        high = low;
        low = rest.over(&content_in(&rest, main)).unwrap_or_default();
    }
    content
}

/// Returns the remainder of `high` times powers of the leading coefficient of `low`, divided by
/// `low` (Knuth, algorithm R); one power at each step that needs it.
fn pseudo_remainder(high: &Polynomial, low: &Polynomial, main: Variable) -> Polynomial {
    let degree = low.degree_in(main);
    let leading = |p: &Polynomial| p.coefficients_in(main).pop().unwrap_or_default();
    let divisor = leading(low);
    let mut rest = high.clone();
    while !rest.is_zero() && rest.degree_in(main) >= degree {
        let shift = Monomial::power(main, rest.degree_in(main) - degree);
        let factor = leading(&rest).times(&Polynomial::term(Rational::one(), shift));
        rest = rest.times(&divisor) - low.times(&factor);
    }
    rest
}
