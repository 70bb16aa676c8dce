//! Triple-double arithmetic, about 159 bits: for the few constants for which double-double
//! precision is insufficient, such as the distance from the separatrix and the precession of a
//! nearly spherical body.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::double::Double;
use super::sum::{quick_two_sum, two_product_of_halves, two_sum, with_halves};

/// Sum of three f64 words of decreasing size, each below one ulp of the one before.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub(crate) struct Triple(pub(crate) [f64; 3]);

impl Triple {
    /// Constant 1 / 4π.
    pub(crate) const INVERSE_4_PI: Self =
        Self([0.079_577_471_545_947_67, -4.919_669_168_795_621_5e-18, -2.680_359_070_723_251e-34]);

    pub(crate) const fn value(self) -> f64 {
        self.0[0]
    }

    pub(crate) fn double(self) -> Double {
        Double::sum(self.0[0], self.0[1])
    }

    /// Normalises words of decreasing size, except that leading words may have cancelled; the
    /// remaining words move up.
    #[inline(always)]
    fn of([a, b, c, d]: [f64; 4]) -> Self {
        let (c, d) = two_sum(c, d);
        let (b, c) = two_sum(b, c);
        let (a, b) = two_sum(a, b);
        let (c, d) = two_sum(c, d);
        let (b, c) = two_sum(b, c);
        let (a, b) = two_sum(a, b);
        let (b, c) = two_sum(b, c);
        Self([a, b, c + d])
    }

    /// Normalises a product, whose first word did not cancel.
    #[inline(always)]
    fn of_product([a, b, c, d]: [f64; 4]) -> Self {
        let (c, d) = two_sum(c, d);
        let (b, c) = two_sum(b, c);
        let (a, b) = quick_two_sum(a, b);
        let (b, c) = two_sum(b, c);
        Self([a, b, c + d])
    }

    /// Returns the product with an f64.
    pub(crate) fn times(self, word: f64) -> Self {
        let word = with_halves(word);
        let [(high, e), (b, f), (c, rest)] = self.0.map(|x| two_product_of_halves(with_halves(x), word));
        let (middle, g) = two_sum(b, e);
        let (low, lost) = summed([c, f, g]);
        Self::of_product([high, middle, low, rest + lost])
    }

    /// Returns the sum with an f64.
    pub(crate) fn plus(self, word: f64) -> Self {
        let [a, b, c] = self.0;
        let (a, word) = two_sum(a, word);
        let (b, word) = two_sum(b, word);
        Self::of([a, b, c, word])
    }

    /// Returns √x for x ≥ 0, by one Newton step from the double-double root.
    pub(crate) fn sqrt(self) -> Self {
        let root = self.double().sqrt();
        if root.is_zero() {
            return Self::default();
        }
        let first = Self::from(root);
        let residual = self - first.square();
        first + Self::from(residual.double() / root.scaled(2.0))
    }

    pub(crate) fn square(self) -> Self {
        self * self
    }

    pub(crate) fn is_zero(self) -> bool {
        self.0[0] == 0.0
    }

    /// Returns the product with a power of two, which is exact.
    pub(crate) fn scaled(self, power_of_two: f64) -> Self {
        Self(self.0.map(|word| word * power_of_two))
    }
}

impl From<f64> for Triple {
    fn from(word: f64) -> Self {
        Self([word, 0.0, 0.0])
    }
}

impl From<Double> for Triple {
    fn from(two: Double) -> Self {
        Self([two.high, two.low, 0.0])
    }
}

impl Add for Triple {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        let (high, g) = two_sum(a, d);
        let (middle, h) = two_sum(b, e);
        let (middle, k) = two_sum(middle, g);
        let (low, lost) = summed([c, f, h, k]);
        Self::of([high, middle, low, lost])
    }
}

impl Neg for Triple {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|word| -word))
    }
}

impl Sub for Triple {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Triple {
    type Output = Self;
    /// Returns the product; the error is about 2⁻¹⁵⁸ |a b|.
    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0.map(with_halves), other.0.map(with_halves));
        let (ad, g) = two_product_of_halves(a, d);
        let [(ae, h), (bd, k)] = [two_product_of_halves(a, e), two_product_of_halves(b, d)];
        let (middle, l) = two_sum(ae, bd);
        let (middle, m) = two_sum(middle, g);
        let [(af, n), (be, o), (cd, p)] = [(a, f), (b, e), (c, d)].map(|(x, y)| two_product_of_halves(x, y));
        let (low, lost) = summed([be, af, cd, h, k, l, m]);
        let least = (n + o + p) + (b[0] * f[0] + c[0] * e[0]);
        Self::of_product([ad, middle, low, lost + least])
    }
}

impl Div for Triple {
    type Output = Self;
    /// Returns the quotient by long division: three partial quotients, each from an exact
    /// remainder.
    fn div(self, divisor: Self) -> Self {
        let first = self.0[0] / divisor.0[0];
        let rest = self - divisor.times(first);
        let second = rest.0[0] / divisor.0[0];
        let rest = rest - divisor.times(second);
        Self::of_product([first, second, rest.0[0] / divisor.0[0], 0.0])
    }
}

/// Returns the sum of words of similar size, and its rounding error.
#[inline(always)]
fn summed<const N: usize>(words: [f64; N]) -> (f64, f64) {
    let (mut sum, mut lost) = (0.0, 0.0);
    for word in words {
        let (next, error) = two_sum(sum, word);
        sum = next;
        lost += error;
    }
    (sum, lost)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_undoes_its_inverse_to_46_digits() {
        let third = Triple::from(1.0) / Triple::from(3.0);
        let root = Triple::from(0.7).sqrt();
        let small = |x: Triple| assert!(x.value().abs() < 2e-47, "{x:?}");
        small(third * Triple::from(3.0) - Triple::from(1.0));
        small(root.square() - Triple::from(0.7));
        small(root * third / third - root);
        small((third + root) - root - third);
        small(root.times(0.3) - root * Triple::from(0.3));
        small(root.plus(-0.3) - root + Triple::from(0.3));
        // A product that needs three words, and a cancellation that leaves only the third.
        let a = Triple::from(1.0 + 2f64.powi(-52));
        let cube = a * a * a;
        let rest = cube
            - Triple::from(1.0)
            - Triple::from(3.0 * 2f64.powi(-52))
            - Triple::from(3.0 * 2f64.powi(-104));
        assert_eq!(rest.value(), 2f64.powi(-156));
    }

    #[test]
    fn the_constant_is_one_over_four_pi() {
        // 4π to 48 digits, as a separate triple-double constant.
        let four_pi =
            Triple([12.566_370_614_359_172, 4.898_587_196_589_413e-16, -1.197_907_923_887_335_9e-32]);
        let one = Triple::INVERSE_4_PI * four_pi;
        assert!((one - Triple::from(1.0)).value().abs() < 1e-46);
    }
}
