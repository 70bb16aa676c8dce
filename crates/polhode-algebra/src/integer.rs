//! Integer factors by trial division.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Largest divisor that is tried. A number below 2³² without such divisors is prime.
const LARGEST_DIVISOR: u32 = 1 << 16;

/// Returns s and the primes p with n = s² ∏ p; `None` if n is negative, or if the factor that
/// remains after trial division is neither a square nor below 2³² (Knuth, *The Art of Computer
/// Programming*, §4.5.4, algorithm A).
pub(crate) fn square_factors(number: BigInt) -> Option<(BigInt, Vec<u32>)> {
    if number.is_negative() {
        return None;
    }
    if number.is_zero() {
        return Some((number, Vec::new()));
    }
    let (mut rest, mut outside, mut primes) = (number, BigInt::one(), Vec::new());
    for divisor in (2..=LARGEST_DIVISOR).filter(|d| *d < 4 || d % 2 == 1) {
        if BigInt::from(divisor) * divisor > rest {
            break;
        }
        let mut exponent = 0;
        while rest.is_multiple_of(&divisor.into()) {
            rest /= divisor;
            exponent += 1;
        }
        outside *= BigInt::from(divisor).pow(exponent / 2);
        if exponent % 2 == 1 {
            primes.push(divisor);
        }
    }
    let root = rest.sqrt();
    if &root * &root == rest {
        return Some((outside * root, primes));
    }
    primes.push(rest.to_u32()?);
    Some((outside, primes))
}
