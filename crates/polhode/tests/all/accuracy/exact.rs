//! Integers of 256 bits, and pairs of doubles to compare them with a result.

use std::ops::{Add, Mul, Neg, Sub};

/// Integer between ±2²⁵⁵ in two's complement, least significant word first.
#[derive(Clone, Copy, Default)]
pub(crate) struct Whole([u64; 4]);

impl Whole {
    /// Returns a b, exactly.
    pub(crate) fn product(a: i128, b: i128) -> Self {
        const LOW: u128 = u64::MAX as u128;
        let (x, y) = (a.unsigned_abs(), b.unsigned_abs());
        let [x0, x1, y0, y1] = [x & LOW, x >> 64, y & LOW, y >> 64];
        let (low, cross, other, high) = (x0 * y0, x0 * y1, x1 * y0, x1 * y1);
        let middle = (low >> 64) + (cross & LOW) + (other & LOW);
        let top = high + (cross >> 64) + (other >> 64) + (middle >> 64);
        let magnitude = Self([low as u64, middle as u64, top as u64, (top >> 64) as u64]);
        if (a < 0) != (b < 0) { -magnitude } else { magnitude }
    }

    /// Returns the nearest pair of doubles, to a relative error of 2⁻¹⁰⁴.
    pub(crate) fn pair(self) -> Pair {
        if self.0[3] >> 63 == 1 {
            return -(-self).pair();
        }
        let halves = self.0.iter().rev().flat_map(|word| [word >> 32, word & u64::from(u32::MAX)]);
        halves.fold(Pair::default(), |sum, half| sum * Pair::of(4_294_967_296.0) + Pair::of(half as f64))
    }
}

impl Add for Whole {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let mut carry = false;
        Self(std::array::from_fn(|k| {
            let (sum, first) = self.0[k].overflowing_add(b.0[k]);
            let (sum, second) = sum.overflowing_add(carry.into());
            carry = first || second;
            sum
        }))
    }
}

impl Neg for Whole {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|word| !word)) + Self([1, 0, 0, 0])
    }
}

/// Sum high + low, about 32 digits.
#[derive(Clone, Copy, Default)]
pub(crate) struct Pair {
    high: f64,
    low: f64,
}

impl Pair {
    pub(crate) const fn of(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// Returns the double nearest to the quotient, and the remainder.
    pub(crate) fn over(self, b: Self) -> Self {
        let high = self.high / b.high;
        let rest = self - b * Self::of(high);
        let low = rest.high / b.high;
        let rest = rest - b * Self::of(low);
        two_sum(high, low + rest.high / b.high)
    }

    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

impl Add for Pair {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let (high, low) = (two_sum(self.high, b.high), two_sum(self.low, b.low));
        let sum = two_sum(high.high, high.low + low.high);
        two_sum(sum.high, sum.low + low.low)
    }
}

impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for Pair {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Pair {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let high = self.high * b.high;
        let low = self.high.mul_add(b.high, -high) + (self.high * b.low + self.low * b.high);
        two_sum(high, low)
    }
}

/// Returns a + b as the nearest double and the rounding error (Knuth).
fn two_sum(a: f64, b: f64) -> Pair {
    let high = a + b;
    let of_b = high - a;
    Pair { high, low: (a - (high - of_b)) + (b - of_b) }
}

#[test]
fn whole_numbers_and_pairs_are_exact() {
    let (a, b) = (-(1_i128 << 100) + 12_345, (1_i128 << 90) + 6_789);
    // (a b + c) − a b = c through 256 bits and back
    let c = Whole::product(-987_654_321, 1_000_000_007);
    let back = Whole::product(a, b) + c + Whole::product(a, -b);
    assert_eq!(back.pair().value(), -987_654_321.0 * 1_000_000_007.0);
    assert_eq!(Whole::product(a, b).pair().high, a as f64 * b as f64);
    let third = Pair::of(1.0).over(Pair::of(3.0));
    assert!((third * Pair::of(3.0) - Pair::of(1.0)).value().abs() < 1e-31);
}
