//! Rational numbers of any size.
//!
//! Integers have as many digits as needed, so that no operation overflows: coefficients of
//! remainder sequences grow beyond 128 bits already for polynomials of degree six.

use core::cmp::Ordering;
use core::fmt;
use core::str::FromStr;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::operators::operators;

/// Largest power of ten in a decimal; doubles end at 10^308.
const LARGEST_EXPONENT: i32 = 400;
/// Largest number of digits of a number in text.
const MOST_DIGITS: usize = 400;

/// Rational number in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: BigInt,
    denominator: BigInt,
}

/// Text that is not a rational number.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RationalError {
    /// Neither a decimal nor a quotient of two decimals.
    Form,
    /// Zero as the denominator.
    ZeroDenominator,
    /// More digits, or a larger power of ten, than allowed.
    TooLarge,
}

impl Rational {
    /// Returns the quotient in lowest terms; `None` if the denominator is zero.
    pub fn new(numerator: impl Into<BigInt>, denominator: impl Into<BigInt>) -> Option<Self> {
        let (numerator, denominator) = (numerator.into(), denominator.into());
        (!denominator.is_zero()).then(|| Self::reduced(&numerator, &denominator))
    }

    fn reduced(numerator: &BigInt, denominator: &BigInt) -> Self {
        let divisor = numerator.gcd(denominator) * denominator.signum();
        Self { numerator: numerator / &divisor, denominator: denominator / &divisor }
    }

    /// Returns the number zero.
    pub fn zero() -> Self {
        Self::from(0)
    }

    /// Returns the number one.
    pub fn one() -> Self {
        Self::from(1)
    }

    /// Returns the numerator, which has the sign.
    pub fn numerator(&self) -> &BigInt {
        &self.numerator
    }

    /// Returns the denominator, a positive integer.
    pub fn denominator(&self) -> &BigInt {
        &self.denominator
    }

    /// Returns true if the number is zero.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns true if the number is one.
    pub fn is_one(&self) -> bool {
        self.numerator.is_one() && self.is_integer()
    }

    /// Returns true if the number is an integer.
    pub fn is_integer(&self) -> bool {
        self.denominator.is_one()
    }

    /// Returns true if the number is less than zero.
    pub fn is_negative(&self) -> bool {
        self.numerator.is_negative()
    }

    /// Returns the absolute value.
    pub fn abs(&self) -> Self {
        Self { numerator: self.numerator.abs(), denominator: self.denominator.clone() }
    }

    /// Returns the sum.
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_integer() && other.is_integer() {
            return Self::from(&self.numerator + &other.numerator);
        }
        let numerator = &self.numerator * &other.denominator + &other.numerator * &self.denominator;
        Self::reduced(&numerator, &(&self.denominator * &other.denominator))
    }

    /// Returns the product.
    pub fn times(&self, other: &Self) -> Self {
        if self.is_integer() && other.is_integer() {
            return Self::from(&self.numerator * &other.numerator);
        }
        Self::reduced(&(&self.numerator * &other.numerator), &(&self.denominator * &other.denominator))
    }

    /// Returns the number with the other sign.
    pub fn negated(&self) -> Self {
        Self { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    /// Returns the quotient; `None` if the divisor is zero.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        Self::new(&self.numerator * &divisor.denominator, &self.denominator * &divisor.numerator)
    }

    /// Returns the largest positive number of which both are integer multiples; zero for two zeros.
    pub fn gcd(&self, other: &Self) -> Self {
        let numerator = self.numerator.gcd(&other.numerator);
        Self::reduced(&numerator, &self.denominator.lcm(&other.denominator))
    }

    /// Returns the power.
    pub fn pow(&self, exponent: u32) -> Self {
        Self { numerator: self.numerator.pow(exponent), denominator: self.denominator.pow(exponent) }
    }

    /// Returns the nearest double. Numbers beyond the range of doubles become infinite or zero.
    pub fn to_f64(&self) -> f64 {
        // The quotient has 66 or 67 bits. Its last bit is set if a remainder follows, so that the
        // conversion rounds correctly.
        let shift = 66 - (self.numerator.bits() as i64 - self.denominator.bits() as i64);
        let (above, below) = match shift {
            0.. => (self.numerator.abs() << shift, self.denominator.clone()),
            _ => (self.numerator.abs(), &self.denominator << -shift),
        };
        let (quotient, remainder) = above.div_rem(&below);
        let sticky = u128::from(!remainder.is_zero());
        let magnitude = (quotient.to_u128().unwrap_or_default() | sticky) as f64;
        let exponent = i32::try_from(-shift).unwrap_or(if shift > 0 { i32::MIN } else { i32::MAX });
        libm::scalbn(if self.is_negative() { -magnitude } else { magnitude }, exponent)
    }
}

operators!(Rational);

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self { numerator: value.into(), denominator: BigInt::one() }
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        Self { numerator: value, denominator: BigInt::one() }
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.numerator * &other.denominator).cmp(&(&other.numerator * &self.denominator))
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Rational {
    /// Writes `-2/3`, or `5` for an integer.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_integer() {
            return write!(f, "{}", self.numerator);
        }
        write!(f, "{}/{}", self.numerator, self.denominator)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl FromStr for Rational {
    type Err = RationalError;

    /// Reads `0.25`, `1e-3`, `2/3` or `-1.5/7` exactly.
    fn from_str(text: &str) -> Result<Self, RationalError> {
        match text.split_once('/') {
            Some((above, below)) => {
                decimal(above)?.over(&decimal(below)?).ok_or(RationalError::ZeroDenominator)
            }
            None => decimal(text),
        }
    }
}

fn decimal(text: &str) -> Result<Rational, RationalError> {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (sign, digits) = match digits.strip_prefix(['-', '−']) {
        Some(digits) => ("-", digits),
        None => ("", digits.strip_prefix('+').unwrap_or(digits)),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let written = [whole, fraction].concat();
    let unsigned = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
    if !is_number(&written) || !is_number(unsigned) {
        return Err(RationalError::Form);
    }
    let exponent = exponent.parse::<i32>().map_err(|_| RationalError::TooLarge)?;
    if written.len() > MOST_DIGITS || exponent.unsigned_abs() > LARGEST_EXPONENT.unsigned_abs() {
        return Err(RationalError::TooLarge);
    }
    let integer = BigInt::from_str(&format!("{sign}{written}")).map_err(|_| RationalError::Form)?;
    let power = exponent - fraction.len() as i32;
    let ten = BigInt::from(10).pow(power.unsigned_abs());
    let value = if power < 0 { Rational::reduced(&integer, &ten) } else { Rational::from(integer * ten) };
    Ok(value)
}

impl fmt::Display for RationalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form => write!(f, "expected a decimal such as 0.25 or 1e-3, or a quotient such as 2/3"),
            Self::ZeroDenominator => write!(f, "the denominator is zero"),
            Self::TooLarge => {
                write!(
                    f,
                    "a number has at most {MOST_DIGITS} digits and a power of ten within ±{LARGEST_EXPONENT}"
                )
            }
        }
    }
}

impl core::error::Error for RationalError {}
