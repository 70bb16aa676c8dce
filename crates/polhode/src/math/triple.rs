//! Numbers of three words, about 159 bits: for the few constants that even two words would spoil, such as the distance
//! from the separatrix and the precession of a nearly spherical body.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::double::Double;
use super::sum::{two_product, two_sum};

/// A sum of three words of falling size, each below an ulp of the one before.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub(crate) struct Triple(pub(crate) [f64; 3]);

impl Triple {
    /// 1 / 4π
    pub(crate) const INVERSE_4_PI: Self =
        Self([0.079_577_471_545_947_67, -4.919_669_168_795_621_5e-18, -2.680_359_070_723_251e-34]);

    pub(crate) const fn value(self) -> f64 {
        self.0[0]
    }

    pub(crate) fn double(self) -> Double {
        Double::sum(self.0[0], self.0[1])
    }

    /// Words of any sizes, added: passes of exact additions until the leading three carry the sum.
    fn of<const N: usize>(mut words: [f64; N]) -> Self {
        for _pass in 0..3 {
            for k in (1..N).rev() {
                (words[k - 1], words[k]) = two_sum(words[k - 1], words[k]);
            }
        }
        // Leading words that cancelled to zero give way to the next.
        let mut leading = [0.0; 3];
        let mut place = 0;
        for word in words {
            if word == 0.0 {
                continue;
            }
            if place == 3 {
                break;
            }
            leading[place] = word;
            place += 1;
        }
        let [a, b, c] = leading;
        let (b, c) = two_sum(b, c);
        let (a, b) = two_sum(a, b);
        let (b, c) = two_sum(b, c);
        Self([a, b, c])
    }

    /// √x for x ≥ 0: two Newton steps.
    pub(crate) fn sqrt(self) -> Self {
        let first = self.double().sqrt();
        if first.is_zero() {
            return Self::default();
        }
        let root = Self::from(first);
        let residual = self - root * root;
        root + Self::from(residual.double() / first.scaled(2.0))
    }

    pub(crate) fn square(self) -> Self {
        self * self
    }

    pub(crate) fn is_zero(self) -> bool {
        self.0[0] == 0.0
    }

    /// × a power of two: exact.
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
        Self::of([a, d, b, e, c, f])
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
    /// Error about 2⁻¹⁵⁶ |a b|.
    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        let (ad, ad1) = two_product(a, d);
        let (ae, ae1) = two_product(a, e);
        let (bd, bd1) = two_product(b, d);
        let (be, be1) = two_product(b, e);
        let (af, af1) = two_product(a, f);
        let (cd, cd1) = two_product(c, d);
        let tail = af1 + cd1 + be1 + b * f + c * e;
        Self::of([ad, ae, bd, ad1, be, af, cd, ae1, bd1, tail])
    }
}

impl Div for Triple {
    type Output = Self;
    /// Long division: three quotients, each of an exact remainder.
    fn div(self, divisor: Self) -> Self {
        let mut rest = self;
        let mut quotient = [0.0; 3];
        for word in &mut quotient {
            *word = rest.value() / divisor.value();
            rest = rest - divisor * Self::from(*word);
        }
        Self::of(quotient)
    }
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
        // a product that needs three words, and the cancellation that leaves only the third
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
        // 4π to 48 digits, as three doubles of its own
        let four_pi =
            Triple([12.566_370_614_359_172, 4.898_587_196_589_413e-16, -1.197_907_923_887_335_9e-32]);
        let one = Triple::INVERSE_4_PI * four_pi;
        assert!((one - Triple::from(1.0)).value().abs() < 1e-46);
    }
}
