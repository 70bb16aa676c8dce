//! Greatest common divisors from those of integers.
//!
//! The heuristic algorithm of Char, Geddes and Gonnet (Geddes, Czapor and Labahn, §7.7):
//! one variable after the other gets a large integer as its value ξ. The gcd of the values, written
//! with digits to the base ξ between −ξ/2 and ξ/2, has the coefficients of the gcd as its digits,
//! unless the values have an additional common divisor. A result that divides both polynomials is
//! their gcd, because ξ > 2 + 2 min(‖a‖, ‖b‖) with the largest coefficients: another factor h(x) would
//! have |h(ξ)| > ξ/2, as its roots are at most 1 + min(‖a‖, ‖b‖), and would divide a digit.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

use crate::monomial::Monomial;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::symbol::Variable;

/// Number of values that are tried.
const TRIALS: usize = 4;
/// Largest number of bits of a value. Longer ones take longer than Euclid's algorithm.
const MOST_BITS: u64 = 100_000;

/// Returns the gcd of primitive polynomials, primitive and with a positive leading coefficient;
/// `None` if no value of a variable led to it.
pub(crate) fn heuristic_gcd(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    of_integral(a, b).map(|divisor| divisor.primitive())
}

/// Returns the gcd over the integers, with the gcd of the contents.
fn of_integral(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    let content = a.content().gcd(&b.content());
    let (a, b) = (a.primitive(), b.primitive());
    let common = a.variables().intersection(&b.variables()).next().copied();
    let Some(variable) = common else { return Some(Polynomial::constant(content)) };
    let mut value: BigInt = BigInt::from(2) * largest(&a).min(largest(&b)) + 29;
    let degree = u64::from(a.degree_in(variable).max(b.degree_in(variable)));
    for _ in 0..TRIALS {
        if degree * value.bits() > MOST_BITS {
            return None;
        }
        let number = Polynomial::from(Rational::from(value.clone()));
        let [at_a, at_b] = [&a, &b].map(|p| p.substituted(variable, &number));
        if !at_a.is_zero() && !at_b.is_zero() {
            let divisor = with_digits(&of_integral(&at_a, &at_b)?, &value, variable).primitive();
            if a.over(&divisor).is_some() && b.over(&divisor).is_some() {
                return Some(divisor.scaled(&content));
            }
        }
        // Other digits; the factor is from the implementation in Maple.
        value = value * 73_794 / 27_011;
    }
    None
}

/// Returns the largest absolute value of the coefficients, which are integers.
fn largest(polynomial: &Polynomial) -> BigInt {
    let sizes = polynomial.terms().map(|(_, c)| c.abs().numerator().clone());
    sizes.max().unwrap_or_else(BigInt::zero)
}

/// Returns Σ dₖ xᵏ for a number Σ dₖ ξᵏ with digits between −ξ/2 and ξ/2, for each coefficient.
fn with_digits(number: &Polynomial, base: &BigInt, variable: Variable) -> Polynomial {
    let (mut sum, mut rest, mut power) = (Polynomial::zero(), number.clone(), 0);
    while !rest.is_zero() {
        let mut next = Polynomial::zero();
        for (monomial, coefficient) in rest.terms() {
            let (mut quotient, mut digit) = coefficient.numerator().div_mod_floor(base);
            if BigInt::from(2) * &digit > *base {
                digit -= base;
                quotient += BigInt::one();
            }
            let shifted = monomial.times(&Monomial::power(variable, power));
            sum.add_term(shifted, &Rational::from(digit));
            next.add_term(monomial.clone(), &Rational::from(quotient));
        }
        rest = next;
        power += 1;
    }
    sum
}
