//! Roots of monic polynomials in the field of rational functions.
//!
//! Gauss's lemma: a root of a monic polynomial with polynomials over the integers as coefficients is
//! such a polynomial, if it is a rational function at all. It is found at one value of each variable,
//! and there modulo a prime, and lifted from there by Newton's iteration (Geddes, Czapor and
//! Labahn, §6.3). A lifted root counts only if it is an exact root.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::gcd::lcm;
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbol::Variable;
use crate::univariate::Univariate;

/// Largest prime that is tried.
const LARGEST_PRIME: i64 = 2000;
/// Largest absolute value of a variable that is tried.
const LARGEST_VALUE: i64 = 20;

/// Returns the roots that are rational functions of a polynomial without multiple roots.
///
/// `None` if √p or sin θ occur in it, where factorization is not unique, or if too many values had
/// to be tried.
pub(crate) fn rational_roots(polynomial: &Univariate) -> Option<Vec<RationalFunction>> {
    let monic = polynomial.monic();
    let coefficients = monic.coefficients();
    if monic.has_algebraic() {
        return None;
    }
    // With λ = μ/d the polynomial in μ has the coefficients cₖ d^(n−k), which are integral.
    let denominator = coefficients.iter().fold(Polynomial::one(), |all, c| lcm(&all, c.denominator()));
    let numbers = coefficients.iter().map(|c| c.numerator().content().denominator().clone());
    let number = numbers.fold(BigInt::one(), |all, n| all.lcm(&n));
    let scale = RationalFunction::from(denominator.scaled(&Rational::from(number)));
    let degree = monic.degree();
    let integral = coefficients.iter().enumerate().map(|(k, c)| {
        let power = scale.pow(i32::try_from(degree - k).ok()?)?;
        Some((c * &power).numerator().clone())
    });
    let roots = integral_roots(&integral.collect::<Option<Vec<_>>>()?)?;
    roots.into_iter().map(|root| RationalFunction::from(root).over(&scale)).collect()
}

/// Returns the roots of a monic square-free polynomial that are polynomials over the integers.
fn integral_roots(coefficients: &[Polynomial]) -> Option<Vec<Polynomial>> {
    let Some(variable) = coefficients.iter().find_map(|c| c.variables().first().copied()) else {
        let numbers = coefficients.iter().map(|c| Some(c.as_constant()?.numerator().clone()));
        let roots = integer_roots(&numbers.collect::<Option<Vec<_>>>()?)?;
        return Some(roots.into_iter().map(|root| Polynomial::from(Rational::from(root))).collect());
    };
    let values = (0..=LARGEST_VALUE).flat_map(|k| if k == 0 { vec![0] } else { vec![k, -k] });
    for value in values {
        let value = Polynomial::from(Rational::from(value));
        let special: Vec<Polynomial> = coefficients.iter().map(|c| c.substituted(variable, &value)).collect();
        if is_square_free(&special) {
            let shift = Polynomial::variable(variable) + &value;
            let shifted: Vec<Polynomial> =
                coefficients.iter().map(|c| c.substituted(variable, &shift)).collect();
            let back = Polynomial::variable(variable) - value;
            let starts = integral_roots(&special)?.into_iter();
            let roots = starts.filter_map(|start| lifted(&shifted, variable, start));
            return Some(roots.map(|root| root.substituted(variable, &back)).collect());
        }
    }
    None
}

fn is_square_free(coefficients: &[Polynomial]) -> bool {
    let polynomial = Univariate::new(coefficients.iter().cloned().map(RationalFunction::from).collect());
    polynomial.gcd(&polynomial.derivative()).degree() == 0
}

/// Returns the root that equals `start` at x = 0, by one power of x after the other.
fn lifted(coefficients: &[Polynomial], variable: Variable, start: Polynomial) -> Option<Polynomial> {
    // A root of degree m in x needs a coefficient cₖ of degree ≥ m (n − k) to cancel its power.
    let degree = coefficients.len() - 1;
    let bounds =
        coefficients[..degree].iter().enumerate().map(|(k, c)| c.degree_in(variable) / (degree - k) as u32);
    let slope = horner(&slopes(coefficients), &start).coefficients_in(variable).swap_remove(0);
    let mut root = start;
    for power in 1..=bounds.max().unwrap_or(0) {
        let residual = horner(coefficients, &root).coefficients_in(variable);
        if let Some(residual) = residual.get(power as usize) {
            let correction = residual.negated().over(&slope)?;
            root = root + correction * Polynomial::variable(variable).pow(power);
        }
    }
    horner(coefficients, &root).is_zero().then_some(root)
}

fn horner(coefficients: &[Polynomial], value: &Polynomial) -> Polynomial {
    coefficients.iter().rev().fold(Polynomial::zero(), |sum, c| sum * value + c)
}

/// Returns the coefficients of the derivative.
fn slopes(coefficients: &[Polynomial]) -> Vec<Polynomial> {
    coefficients.iter().enumerate().skip(1).map(|(k, c)| c.scaled(&Rational::from(k as i64))).collect()
}

/// Returns the integer roots of a monic polynomial without multiple roots, lifted from a prime.
fn integer_roots(coefficients: &[BigInt]) -> Option<Vec<BigInt>> {
    let slopes: Vec<BigInt> = coefficients.iter().enumerate().skip(1).map(|(k, c)| c * k).collect();
    let at = |c: &[BigInt], x: &BigInt| c.iter().rev().fold(BigInt::zero(), |sum, c| sum * x + c);
    // Cauchy's bound of the roots.
    let bound = coefficients.iter().map(Signed::abs).max()? + BigInt::one();
    let is_prime = |p: &i64| (2..).take_while(|d| d * d <= *p).all(|d| p % d != 0);
    for prime in (101..LARGEST_PRIME).step_by(2).filter(is_prime) {
        let modulus = BigInt::from(prime);
        let is_zero = |c: &[BigInt], x: &BigInt| at(c, x).mod_floor(&modulus).is_zero();
        let starts: Vec<BigInt> = (0..prime).map(BigInt::from).filter(|x| is_zero(coefficients, x)).collect();
        if starts.iter().any(|x| is_zero(&slopes, x)) {
            continue;
        }
        let lift = |start: BigInt| {
            let (mut root, mut modulus) = (start, modulus.clone());
            while modulus <= BigInt::from(2) * &bound {
                modulus = &modulus * &modulus;
                let inverse = at(&slopes, &root).modinv(&modulus)?;
                root = (&root - at(coefficients, &root) * inverse).mod_floor(&modulus);
            }
            let root = if BigInt::from(2) * &root > modulus { root - modulus } else { root };
            at(coefficients, &root).is_zero().then_some(root)
        };
        return Some(starts.into_iter().filter_map(lift).collect());
    }
    None
}
