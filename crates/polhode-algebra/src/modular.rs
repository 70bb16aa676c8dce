//! Images of polynomials modulo a prime, which bound the degrees of their gcd.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use crate::polynomial::Polynomial;
use crate::symbol::Variable;

/// The Mersenne prime 2⁶¹ − 1.
const PRIME: u64 = (1 << 61) - 1;

/// Returns the variables that the gcd of primitive polynomials may have: no other has.
///
/// All variables except x get values modulo a prime. The gcd of these images has at least the degree
/// in x of the gcd's image, which is the gcd's own unless both leading coefficients vanish (Geddes,
/// Czapor and Labahn, lemma 7.3). For coprime polynomials the images are coprime except for few
/// values.
pub(crate) fn variables_of_gcd(a: &Polynomial, b: &Polynomial) -> BTreeSet<Variable> {
    let common: Vec<Variable> = a.variables().intersection(&b.variables()).copied().collect();
    let may_have = |main: &Variable| {
        let [left, right] = [a, b].map(|p| image(p, *main));
        let is_lost = |image: &[u64], p: &Polynomial| image.len() <= p.degree_in(*main) as usize;
        (is_lost(&left, a) && is_lost(&right, b)) || degree_of_gcd(left, right) > 0
    };
    common.into_iter().filter(may_have).collect()
}

/// Returns the coefficients by ascending power of a variable, with values for all others; the last
/// one is not zero.
fn image(polynomial: &Polynomial, main: Variable) -> Vec<u64> {
    let mut coefficients = vec![0; polynomial.degree_in(main) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let number = coefficient.numerator().mod_floor(&BigInt::from(PRIME));
        let mut product = number.to_u64().unwrap_or_default();
        for &(variable, exponent) in monomial.powers().iter().filter(|(variable, _)| *variable != main) {
            product = times(product, power(value(variable), u64::from(exponent)));
        }
        let sum = &mut coefficients[monomial.exponent(main) as usize];
        *sum = (*sum + product) % PRIME;
    }
    trimmed(coefficients)
}

/// Returns a value for each variable, by the mixing function of SplitMix64.
const fn value(variable: Variable) -> u64 {
    let number = match variable {
        Variable::Root(prime) => prime as u64,
        Variable::Symbol(symbol) => 1 << 32 | (symbol.place as u64) << 8 | symbol.order as u64,
        Variable::Sine(symbol) => 2 << 32 | (symbol.place as u64) << 8 | symbol.order as u64,
        Variable::Cosine(symbol) => 3 << 32 | (symbol.place as u64) << 8 | symbol.order as u64,
    };
    let z = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z ^ (z >> 31)) % PRIME
}

/// Returns the degree of the gcd of two polynomials modulo the prime, by Euclid's algorithm.
fn degree_of_gcd(mut a: Vec<u64>, mut b: Vec<u64>) -> usize {
    while let Some(&leading) = b.last() {
        let inverse = power(leading, PRIME - 2);
        while a.len() >= b.len() {
            let factor = times(a[a.len() - 1], inverse);
            let start = a.len() - b.len();
            for (x, &y) in a[start..].iter_mut().zip(&b) {
                *x = (*x + PRIME - times(factor, y)) % PRIME;
            }
            a = trimmed(a);
        }
        (a, b) = (b, a);
    }
    a.len().saturating_sub(1)
}

fn trimmed(mut coefficients: Vec<u64>) -> Vec<u64> {
    while coefficients.last() == Some(&0) {
        coefficients.pop();
    }
    coefficients
}

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn power(base: u64, exponent: u64) -> u64 {
    let (mut result, mut square, mut rest) = (1, base, exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            result = times(result, square);
        }
        square = times(square, square);
        rest /= 2;
    }
    result
}
