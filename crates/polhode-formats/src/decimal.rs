//! Decimal numbers in text, to the nearest double, fast.
//!
//! A decimal is w·10^e with an integer w. Where w and the power of ten are doubles themselves, one product or one
//! quotient is correctly rounded. Where only w < 2^64 holds, w/10^k is a product with 128 bits of 5^-k, correctly rounded
//! unless its tail is all zeros or all ones. The standard library reads what is left over. All three ways give the
//! same bits, those of [`str::parse`]; eight digits are read at a time.

use std::ops::Range;

/// Powers of ten that are doubles.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Powers of ten for the digits of one word.
const WORD_POWERS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// Digits that always fit 64 bits.
const SAFE_DIGITS: usize = 19;

/// The number that starts at `start`, and the offset behind it.
///
/// The grammar is `[+-] digits [. digits] [e [+-] digits]`, with a digit before or behind the point; nothing else is a
/// number here, infinities least of all. What overflows is infinite.
#[inline(always)]
pub(crate) fn float(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let sign = byte(bytes, start);
    let first = start + usize::from(sign == b'-' || sign == b'+');
    let (mut w, mut at) = digits(bytes, first, 0);
    let (mut count, mut decimals) = (at - first, 0);
    if byte(bytes, at) == b'.' {
        let point = at + 1;
        (w, at) = digits(bytes, point, w);
        decimals = at - point;
        count += decimals;
    }
    let is_plain = (1..=SAFE_DIGITS).contains(&count) && byte(bytes, at) | 0x20 != b'e';
    let (magnitude, at) = match if is_plain { rounded(w, -(decimals as i64)) } else { None } {
        Some(magnitude) => (magnitude, at),
        None if count == 0 => return None,
        None => rare(bytes, first..at, w, decimals)?,
    };
    Some((f64::from_bits(magnitude.to_bits() | u64::from(sign == b'-') << 63), at))
}

/// The number whose mantissa w·10^-decimals is known, with an exponent or many digits.
#[inline(never)]
fn rare(bytes: &[u8], mantissa: Range<usize>, w: u64, decimals: usize) -> Option<(f64, usize)> {
    let (mut e, mut at) = (-(decimals as i64), mantissa.end);
    if byte(bytes, at) | 0x20 == b'e' {
        let (power, end) = integer(bytes, at + 1)?;
        (e, at) = (e.saturating_add(power), end);
    }
    let fits = significant(&bytes[mantissa.clone()]) <= SAFE_DIGITS;
    let magnitude = match if fits { rounded(w, e) } else { None } {
        Some(magnitude) => magnitude,
        None => str::from_utf8(&bytes[mantissa.start..at]).ok()?.parse().ok()?,
    };
    Some((magnitude, at))
}

/// The integer that starts at `start`, and the offset behind it; one of more than 18 digits is as large as can be.
#[inline(always)]
pub(crate) fn integer(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    short_integer(bytes, start).or_else(|| rare_integer(bytes, start))
}

/// The integer that starts at `start`, if it has one to seven digits and no sign, and the offset behind it.
#[inline(always)]
pub(crate) fn short_integer(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    match leading_digits(word(bytes, start)) {
        (value, length @ 1..8) => Some((value as i64, start + length)),
        _ => None,
    }
}

/// An integer with a sign or many digits.
#[inline(never)]
fn rare_integer(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    let sign = byte(bytes, start);
    let first = start + usize::from(sign == b'-' || sign == b'+');
    let (w, at) = digits(bytes, first, 0);
    if at == first {
        return None;
    }
    let fits = at - first < SAFE_DIGITS || significant(&bytes[first..at]) < SAFE_DIGITS;
    let magnitude = if fits { w as i64 } else { i64::MAX };
    Some((if sign == b'-' { -magnitude } else { magnitude }, at))
}

/// w·10^e, correctly rounded, or nothing where this would not be certain.
#[inline(always)]
fn rounded(w: u64, e: i64) -> Option<f64> {
    let k = e.unsigned_abs() as usize;
    match EXACT_POWERS.get(k) {
        // Clinger: two doubles and one rounding.
        Some(power) if w <= 1 << 53 => {
            Some(if e < 0 { w as i64 as f64 / power } else { w as i64 as f64 * power })
        }
        _ if w == 0 || e > 0 => None,
        _ => divided(w, k),
    }
}

/// w·10^-k for w > 0, correctly rounded, or nothing where this would not be certain.
fn divided(w: u64, k: usize) -> Option<f64> {
    // w·5^-k·2^-k with 5^-k = m·2^-(127+L): x = w'·m/2^64 is off by less than 2, with w' = w·2^z in [2^63, 2^64).
    let Reciprocal { high, low, shift } = *RECIPROCALS.get(k)?;
    let z = w.leading_zeros();
    let normal = u128::from(w << z);
    let x = normal * u128::from(high) + ((normal * u128::from(low)) >> 64);
    let (head, tail) = ((x >> 64) as u64, x as u64);
    // Both ends of the error have the same head ≥ 2^62, and something behind it. Doubles and their midpoints are even
    // there, so an odd head stands for all that lies between two of them.
    if tail == 0 || tail > u64::MAX - 2 {
        return None;
    }
    Some((head | 1) as f64 * power_of_two(1 - i64::from(z) - i64::from(shift)))
}

/// 2^n for a normal double.
fn power_of_two(n: i64) -> f64 {
    f64::from_bits(((1023 + n) as u64) << 52)
}

/// 5^-k = m·2^-(127+L), rounded down: m in two halves, and L + k.
#[derive(Clone, Copy)]
struct Reciprocal {
    high: u64,
    low: u64,
    shift: u32,
}

/// For k = 0 … 54: twice a remainder by 5^54 still fits 128 bits. The first is never asked for.
static RECIPROCALS: [Reciprocal; 55] = {
    let mut table = [Reciprocal { high: 0, low: 0, shift: 0 }; 55];
    let (mut k, mut power) = (1, 5_u128); // 5^k
    while k < table.len() {
        let length = 128 - power.leading_zeros(); // L: 2^(L-1) < 5^k < 2^L
        let (mut quotient, mut remainder, mut bit) = (0_u128, 1 << (length - 1), 0);
        while bit < 128 {
            remainder <<= 1;
            quotient <<= 1;
            if remainder >= power {
                remainder -= power;
                quotient |= 1;
            }
            bit += 1;
        }
        let (high, low) = ((quotient >> 64) as u64, quotient as u64);
        table[k] = Reciprocal { high, low, shift: length + k as u32 };
        (k, power) = (k + 1, power * 5);
    }
    table
};

/// Appends the digits at `at` to w, modulo 2^64; and the offset behind them.
#[inline(always)]
fn digits(bytes: &[u8], mut at: usize, mut w: u64) -> (u64, usize) {
    loop {
        let (value, length) = leading_digits(word(bytes, at));
        w = w.wrapping_mul(WORD_POWERS[length]).wrapping_add(value);
        at += length;
        if length < 8 {
            return (w, at);
        }
    }
}

/// The digits that a word starts with: their value, and how many.
#[inline(always)]
fn leading_digits(word: u64) -> (u64, usize) {
    const ONES: u64 = 0x0101_0101_0101_0101;
    // A digit is a byte 0 … 9 of t. The lowest other byte is found surely: no carry reaches it from below.
    let t = word ^ (0x30 * ONES);
    let others = (t.wrapping_add(0x76 * ONES) | t) & (0x80 * ONES);
    let length = others.trailing_zeros() / 8;
    // The missing digits become leading zeros; then pairs, fours, and all eight.
    let t = t.unbounded_shl(64 - 8 * length);
    let pairs = t.wrapping_mul(10).wrapping_add(t >> 8);
    let mask = 0x0000_00ff_0000_00ff;
    let outer = (pairs & mask).wrapping_mul(100 + (1_000_000 << 32));
    let inner = ((pairs >> 16) & mask).wrapping_mul(1 + (10_000 << 32));
    (outer.wrapping_add(inner) >> 32, length as usize)
}

/// Eight bytes, the first in the lowest place; zeros behind the end.
#[inline(always)]
pub(crate) fn word(bytes: &[u8], at: usize) -> u64 {
    match bytes.get(at..).and_then(<[u8]>::first_chunk) {
        Some(&chunk) => u64::from_le_bytes(chunk),
        None => last_word(bytes, at),
    }
}

#[cold]
fn last_word(bytes: &[u8], at: usize) -> u64 {
    let rest = bytes.get(at..).unwrap_or_default();
    rest.iter().take(8).rev().fold(0, |word, &byte| word << 8 | u64::from(byte))
}

/// A byte, or 0 behind the end.
#[inline(always)]
fn byte(bytes: &[u8], at: usize) -> u8 {
    bytes.get(at).copied().unwrap_or(0)
}

/// Digits from the first that is not zero.
fn significant(number: &[u8]) -> usize {
    number.iter().filter(|b| **b != b'.').skip_while(|b| **b == b'0').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Marsaglia's xorshift with a multiplier: any reproducible bits will do.
    struct Random(u64);

    impl Random {
        fn bits(&mut self) -> u64 {
            self.0 ^= self.0 >> 12;
            self.0 ^= self.0 << 25;
            self.0 ^= self.0 >> 27;
            self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
        }

        fn below(&mut self, n: u64) -> u64 {
            ((u128::from(self.bits()) * u128::from(n)) >> 64) as u64
        }
    }

    /// Read alone, and with text behind it.
    fn same_as_std(text: &str) {
        let expected: f64 = text.parse().unwrap();
        for tail in ["", " 7", "\n-1.5e3 ", "/12/13 14"] {
            let (value, end) = float(format!("{text}{tail}").as_bytes(), 0).unwrap();
            assert_eq!((value.to_bits(), end), (expected.to_bits(), text.len()), "{text}{tail}: {value:e}");
        }
    }

    #[test]
    fn random_decimals_are_read_as_the_standard_library_reads_them() {
        let mut random = Random(0x9e37_79b9_7f4a_7c15);
        for _ in 0..200_000 {
            let count = 1 + random.below(24) as usize;
            let mut text: String = (0..count).map(|_| char::from(b'0' + random.below(10) as u8)).collect();
            text.insert(random.below(count as u64 + 1) as usize, '.');
            text.insert_str(
                0,
                ["", "-", "+", "000", "-0.0000"]
                    [if text.starts_with('.') { 0 } else { random.below(4) as usize }],
            );
            if random.below(3) == 0 {
                let e = random.below(700) as i64 - 350;
                let e = if random.below(2) == 0 { e / 12 } else { e };
                text += &format!("{}{e:+}", ["e", "E"][random.below(2) as usize]);
            }
            same_as_std(&text);
        }
    }

    #[test]
    fn doubles_come_back_as_they_were_written() {
        let mut random = Random(77);
        for _ in 0..100_000 {
            let value = f64::from_bits(random.bits());
            let near_one = f64::from_bits(random.bits() & !(0x7ff << 52) | (990 + random.below(60)) << 52);
            for value in [value, near_one] {
                if value.is_finite() {
                    same_as_std(&format!("{value:e}"));
                    same_as_std(&format!("{value:.16e}"));
                }
            }
            for decimals in [6, 9, 15, 17, 20] {
                same_as_std(&format!("{near_one:.decimals$}"));
            }
        }
    }

    #[test]
    fn midpoints_between_doubles_go_to_the_even_one() {
        let mut random = Random(5);
        for _ in 0..20_000 {
            // (2n+1)·2^-j with 54 bits has j decimals: exact midpoints, and their neighbours in the last decimal.
            let odd = 1 << 53 | random.bits() >> 11 | 1;
            for j in [1, 2, 3] {
                let scaled = u128::from(odd) * 5_u128.pow(j);
                let text = |digits: u128| {
                    let digits = digits.to_string();
                    let (whole, fraction) = digits.split_at(digits.len() - j as usize);
                    format!("{whole}.{fraction}")
                };
                for neighbour in [scaled - 1, scaled, scaled + 1] {
                    same_as_std(&text(neighbour));
                }
            }
        }
    }

    #[test]
    fn edges_of_the_ranges() {
        for text in [
            "0",
            "-0",
            "0.0e-400",
            "9007199254740992",
            "9007199254740993",
            "9007199254740993e-3",
            "9999999999999999999e-54",
            "9999999999999999999e-55",
            "1e22",
            "1e23",
            "18446744073709551615e-1",
            "18446744073709551616e-1",
            "1e-54",
            "9007199254740993e-54",
            "1e999",
            "1e-999",
            "5e-324",
            "2.4703282292062327e-324",
            "1.7976931348623159e308",
            "1.",
            ".5",
            "0.000000000000000000000000000000000000012345678901234567",
            "1e99999999999999999999",
            "12345678",
            "123456789012345678901234567890",
            "1e-9223372036854775807",
            "0.1e-9223372036854775808",
        ] {
            same_as_std(text);
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in [
            "", "-", "+", ".", "-.", "e5", "x", "nan", "inf", "-inf", "1e", "1e+", "1.5e-", "--1", "+-1",
            " 1",
        ] {
            assert_eq!(float(text.as_bytes(), 0), None, "{text}");
        }
        assert_eq!(float(b"1.5.2", 0), Some((1.5, 3)));
        assert_eq!(float(b"0x10", 0), Some((0.0, 1)));
        assert_eq!(float(b"1", 5), None);
    }

    #[test]
    fn integers_saturate() {
        let read = |text: &str| integer(text.as_bytes(), 0);
        assert_eq!(read("-120345/7"), Some((-120_345, 7)));
        assert_eq!(read("+123456789012345678 "), Some((123_456_789_012_345_678, 19)));
        assert_eq!(read("000000000000000000000042"), Some((42, 24)));
        assert_eq!(read("-99999999999999999999"), Some((-i64::MAX, 21)));
        assert_eq!(read("18446744073709551617"), Some((i64::MAX, 20)));
        for text in ["", "-", "/", "a1", ":1"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
