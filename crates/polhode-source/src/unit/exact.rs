//! Positive rational numbers, exact until the one rounding at the end.
//!
//! A quantity is an integer of any length, times a power of ten, divided by a few small integers.
//! Multiplications are done immediately and divisions last. The quotient gets enough digits that
//! truncation cannot change the nearest double, which `str::parse` then finds.

const BASE: u64 = 1_000_000_000_000_000_000;
const BASE_DIGITS: usize = 18;

/// Number of limbs of the quotient x/D after the last digit of x, for n divisors with D < 10^(19.3
/// n).
///
/// Unit: that digit. A quotient that is not a midpoint between two doubles (a multiple of
/// 2^-1075) is at least 1/(2^1075 D) away from one, or 1/(2^54 D²) if the digit is before the
/// decimal point. The truncation error, 10^-(324 + 54 n), is smaller.
const fn precision(n: usize) -> usize {
    18 + 3 * n
}

/// π as a convergent of its continued fraction, with both terms in a `u64`; relative error 4.5e-39.
const PI: (u64, u64) = (2_646_693_125_139_304_345, 842_468_587_426_513_207);

/// Number limbs × 10^ten / Π divisors; limbs in base 10^18, least significant first.
pub(crate) struct Exact {
    limbs: Vec<u64>,
    ten: i64,
    divisors: Vec<u64>,
}

impl Exact {
    /// Creates the number from an unsigned decimal such as `12`, `.5` or `6.02e+23` of valid form.
    pub(crate) fn new(decimal: &str) -> Self {
        let (digits, exponent) = decimal.split_once(['e', 'E']).unwrap_or((decimal, "0"));
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let out_of_range = if exponent.starts_with('-') { i64::MIN / 2 } else { i64::MAX / 2 };
        let mut limbs: Vec<u64> = [whole, fraction]
            .concat()
            .as_bytes()
            .rchunks(BASE_DIGITS)
            .map(|chunk| chunk.iter().fold(0, |n, digit| 10 * n + u64::from(digit - b'0')))
            .collect();
        while limbs.last() == Some(&0) {
            limbs.pop();
        }
        let exponent = exponent.parse().unwrap_or(out_of_range).clamp(i64::MIN / 2, i64::MAX / 2);
        Self { limbs, ten: exponent - fraction.len() as i64, divisors: Vec::new() }
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.limbs.is_empty()
    }

    /// Multiplies by factor^power, with the factor in the form of the table of units: `0.3048`,
    /// `pi/180`.
    pub(crate) fn scale(&mut self, factor: &str, power: i8) {
        for (place, part) in factor.split('/').enumerate() {
            let (mut above, mut below, mut ten) = match part {
                "pi" => (PI.0, PI.1, 0),
                _ => {
                    let (integer, ten) = integer_and_power_of_ten(part);
                    (integer, 1, ten)
                }
            };
            if (place == 0) != (power > 0) {
                (above, below, ten) = (below, above, -ten);
            }
            for _ in 0..power.unsigned_abs() {
                self.multiply(above);
                self.divisors.extend((below != 1).then_some(below));
                self.ten += ten;
            }
        }
    }

    fn multiply(&mut self, factor: u64) {
        let mut carry: u128 = 0;
        for limb in &mut self.limbs {
            let product = u128::from(*limb) * u128::from(factor) + carry;
            *limb = (product % u128::from(BASE)) as u64;
            carry = product / u128::from(BASE);
        }
        while carry != 0 {
            self.limbs.push((carry % u128::from(BASE)) as u64);
            carry /= u128::from(BASE);
        }
    }

    /// Returns the nearest double; infinite on overflow.
    pub(crate) fn nearest(mut self) -> f64 {
        if !self.divisors.is_empty() {
            let zeros = precision(self.divisors.len());
            self.limbs.splice(0..0, std::iter::repeat_n(0, zeros));
            self.ten -= (zeros * BASE_DIGITS) as i64;
        }
        for &divisor in &self.divisors {
            let mut remainder = 0;
            for limb in self.limbs.iter_mut().rev() {
                let dividend = remainder * u128::from(BASE) + u128::from(*limb);
                *limb = (dividend / u128::from(divisor)) as u64; // < BASE, because remainder < divisor
                remainder = dividend % u128::from(divisor);
            }
        }
        let digits: String = self.limbs.iter().rev().map(|limb| format!("{limb:018}")).collect();
        // The decimal point goes first: `str::parse` reads any number of digits, but no exponent
        // below −65536.
        format!("0.{digits}0e{}", self.ten + digits.len() as i64).parse().unwrap_or(f64::NAN)
    }
}

/// Splits a decimal constant of the table: 0.0254 = 254 × 10⁻⁴.
fn integer_and_power_of_ten(decimal: &str) -> (u64, i64) {
    let integer =
        decimal.bytes().filter(u8::is_ascii_digit).fold(0, |n, digit| 10 * n + u64::from(digit - b'0'));
    let fraction = decimal.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    (integer, -(fraction as i64))
}
