//! Error-free transformations: sums and products with their rounding errors.

use core::ops::{Add, Sub};

use super::number::Splat;

/// Returns a + b as rounded sum and exact error (Knuth, TAOCP 2, §4.2.2, Theorem B).
#[inline(always)]
pub(crate) fn two_sum<T: Copy + Add<Output = T> + Sub<Output = T>>(a: T, b: T) -> (T, T) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// Returns a + b for |a| ≥ |b| (or a = 0), as rounded sum and exact error (Dekker).
#[inline(always)]
pub(crate) fn quick_two_sum<T: Splat>(a: T, b: T) -> (T, T) {
    let s = a + b;
    (s, b - (s - a))
}

/// Splits an f64 into the sum of two halves of 26 bits (Veltkamp).
#[inline(always)]
pub(crate) fn halves<T: Splat>(a: T) -> (T, T) {
    let c = T::splat(SPLITTER) * a;
    let high = c - (c - a);
    (high, a - high)
}

/// Returns an f64 and its halves.
#[inline(always)]
pub(crate) fn with_halves<T: Splat>(a: T) -> [T; 3] {
    let (high, low) = halves(a);
    [a, high, low]
}

/// Veltkamp's constant 2²⁷ + 1.
const SPLITTER: f64 = 134_217_729.0;

/// Returns a b as rounded product and exact error (Dekker), for |a|, |b| < 2⁹⁹⁵ and |a b| > 2⁻⁹⁶⁹.
#[inline(always)]
pub(crate) fn two_product<T: Splat>(a: T, b: T) -> (T, T) {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    two_product_of_halves([a, a1, a2], [b, b1, b2])
}

/// Works like [`two_product`] for numbers with precomputed halves.
#[inline(always)]
pub(crate) fn two_product_of_halves<T: Splat>([a, a1, a2]: [T; 3], [b, b1, b2]: [T; 3]) -> (T, T) {
    let p = a * b;
    (p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2)
}

/// Running sum of many terms, whose error does not grow with their number.
///
/// Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) 1955, algorithm 4.4 (`Sum2`):
/// |error| ≤ ε |Σ aᵢ| + γ² Σ |aᵢ|.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, term: f64) {
        let (high, error) = two_sum(self.high, term);
        self.high = high;
        self.low += error;
    }

    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_what_plain_addition_loses() {
        let mut sum = Sum::default();
        let terms = [1e16, 3.25, -1e16, 1e-3, 7e15, -7e15, -0.25];
        for t in terms {
            sum.add(t);
        }
        assert_eq!(sum.value(), 3.001);
        assert_ne!(terms.iter().sum::<f64>(), 3.001);
    }
}
