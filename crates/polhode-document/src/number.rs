//! Formatting of numbers.

/// No-break space, as before a unit. [`crate::layout::plain_spaces`] replaces it by an ordinary one.
pub const NO_BREAK: char = '\u{a0}';

/// Significant digits of every printed quantity whose error is not larger.
pub const DIGITS: usize = 6;

/// Decimal exponents in fixed notation; others use powers of ten.
const FIXED: std::ops::RangeInclusive<i32> = -3..=5;

/// Rounding threshold: components below this part of the largest count as zero.
const ROUNDING: f64 = 1e-14;

/// Formats a number with at most `digits` significant digits and no trailing zeros. `-0` is `0`; a
/// number that is not finite is a dash.
pub fn number(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return "—".to_owned();
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    let exponent = exponent(x, digits);
    if FIXED.contains(&exponent) {
        return trimmed(&fixed(x, digits, exponent)).to_owned();
    }
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    match scientific.split_once('e') {
        Some((mantissa, power)) => format!("{}e{power}", trimmed(mantissa)),
        None => scientific,
    }
}

/// Returns the shortest decimal that parses to the same double; a number that is not finite is a
/// dash.
pub fn exact(x: f64) -> String {
    if !x.is_finite() {
        return "—".to_owned();
    }
    let shortest = format!("{x:?}");
    shortest.strip_suffix(".0").map_or(shortest.clone(), str::to_owned)
}

/// Formats related numbers with the same number of decimals if their sizes are similar, else each
/// on its own.
pub fn alike(values: &[f64], digits: usize) -> Vec<String> {
    let nonzero = || values.iter().map(|x| x.abs()).filter(|x| *x > 0.0);
    let largest = nonzero().fold(0.0, f64::max);
    let least = nonzero().fold(f64::INFINITY, f64::min);
    let near = values.iter().all(|x| x.is_finite()) && least >= 1e-3 * largest;
    if largest == 0.0 || !near || !FIXED.contains(&exponent(largest, digits)) {
        return values.iter().map(|&x| number(x, digits)).collect();
    }
    let exponent = exponent(largest, digits);
    let all: Vec<String> = values.iter().map(|&x| fixed(x, digits, exponent)).collect();
    let spare = |s: &String| s.len() - trimmed(s).len();
    let spare = all.iter().zip(values).filter(|(_, x)| **x != 0.0).map(|(s, _)| spare(s)).min().unwrap_or(0);
    let shown =
        |(s, x): (&String, &f64)| if *x == 0.0 { "0".to_owned() } else { s[..s.len() - spare].to_owned() };
    all.iter().zip(values).map(shown).collect()
}

/// Formats a vector as `(x, y, z)`.
pub fn vector(values: [f64; 3], digits: usize) -> String {
    let [x, y, z] = values.map(|x| number(x, digits));
    format!("({x}, {y}, {z})")
}

/// Formats a number up to the first digit that the error changes, with at most `digits` digits.
/// Returns 0 if the error is larger than the number; callers check [`has_digits`] unless other
/// numbers are next to it.
pub fn within(x: f64, error: f64, digits: usize) -> String {
    if !(error > 0.0) || x == 0.0 || !x.is_finite() {
        return number(x, digits);
    }
    let spare = (x.abs() / error).log10().floor();
    if spare < 0.0 { "0".to_owned() } else { number(x, digits.min(spare as usize + 1)) }
}

/// Returns true if the error is smaller than the size of a number or vector, so that it has a
/// correct digit.
pub fn has_digits(size: f64, error: f64) -> bool {
    error < size || error == 0.0
}

/// Formats a vector as `(x, y, z)`, with the same error for each component.
pub fn vector_within(values: [f64; 3], error: f64, digits: usize) -> String {
    let [x, y, z] = values.map(|x| within(x, error, digits));
    format!("({x}, {y}, {z})")
}

/// Formats an integer with a comma between thousands.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Formats a count with its noun: `1 flight`, `1,200 flights`.
pub fn counted(n: usize, noun: &str) -> String {
    if n == 1 { format!("1 {noun}") } else { format!("{} {noun}s", count(n as u64)) }
}

/// Formats an error estimate with two digits; it has no better accuracy.
pub fn error(x: f64) -> String {
    number(x, 2)
}

/// Largest number of decimals in fixed notation; beyond it numbers have exponents.
const DECIMALS: i32 = 7;

/// Formats `1.2340 ± 0.0012`. The error has two digits, the value as many decimals as the error. A
/// nonzero value has at least one digit.
pub fn with_error(value: f64, sd: f64) -> String {
    /// Threshold relative to the error below which the value is a rounded zero.
    const NOTHING: f64 = 1e-9;
    if !(sd.is_finite() && sd > 0.0) {
        return number(value, 6);
    }
    let value = if value.abs() < NOTHING * sd { 0.0 } else { value };
    let places = power(sd) - 1;
    if value != 0.0 && value.abs() < 0.5 * 10.0_f64.powi(places) {
        return format!("{} ± {}", number(value, 1), number(sd, 2));
    }
    if (-DECIMALS..=0).contains(&places) {
        let decimals = usize::try_from(-places).unwrap_or(0);
        return format!("{value:.decimals$} ± {sd:.decimals$}");
    }
    let shown = number(sd, 2);
    let size = if value == 0.0 { places } else { power(value) };
    let digits = usize::try_from(size - places + 1).unwrap_or(1).clamp(1, 15);
    format!("{} ± {shown}", number(value, digits))
}

/// Returns n of x = d.ddd · 10ⁿ.
fn power(x: f64) -> i32 {
    format!("{x:e}").split_once('e').and_then(|(_, n)| n.parse().ok()).unwrap_or(0)
}

/// Returns the vector with components that are rounding errors set to zero.
pub fn tidy(v: [f64; 3]) -> [f64; 3] {
    tidy_beside(v, v.iter().fold(0.0, |max, x| f64::max(max, x.abs())))
}

/// Returns the vector with components that are rounding errors relative to `scale` set to zero.
pub fn tidy_beside(v: [f64; 3], scale: f64) -> [f64; 3] {
    v.map(|x| if x.abs() <= ROUNDING * scale { 0.0 } else { x })
}

/// Returns the vector with components set to zero that are rounding errors relative to `scale`, or
/// smaller than `noise` × `scale`.
pub fn without_noise(v: [f64; 3], scale: f64, noise: f64) -> [f64; 3] {
    v.map(|x| if x.abs() <= noise.max(ROUNDING) * scale { 0.0 } else { x })
}

/// Formats a unit quaternion as `w, x, y, z`. An attitude error, rad, changes its components by at
/// most half of it.
pub fn quaternion(q: [f64; 4], error: f64, digits: usize) -> String {
    q.map(|x| within(x, 0.5 * error.max(2.0 * ROUNDING), digits)).join(", ")
}

/// Returns the matrix with off-diagonal elements that are rounding errors set to zero.
pub fn tidy_matrix(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let largest = m.iter().flatten().fold(0.0, |max, x| f64::max(max, x.abs()));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i != j && m[i][j].abs() <= ROUNDING * largest { 0.0 } else { m[i][j] })
    })
}

/// Returns the decimal exponent of x after rounding to `digits` digits.
fn exponent(x: f64, digits: usize) -> i32 {
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    scientific.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

fn fixed(x: f64, digits: usize, exponent: i32) -> String {
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    let text = format!("{x:.decimals$}");
    // A number that rounds to zero has no sign.
    if text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) { text.replace('-', "") } else { text }
}

fn trimmed(s: &str) -> &str {
    if s.contains('.') { s.trim_end_matches('0').trim_end_matches('.') } else { s }
}

/// Returns a text with typeset numbers: `-4.5e-5` becomes −4.5×10⁻⁵.
pub fn typeset(text: &str) -> String {
    let mut out = String::new();
    let mut before = ' ';
    let mut rest = text.chars().peekable();
    let mut in_power = false;
    while let Some(c) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        let continues = in_power && c.is_ascii_digit();
        in_power = continues;
        match c {
            'e' if before.is_ascii_digit() && (next == '-' || next.is_ascii_digit()) => {
                out.push_str("×10");
                if next == '-' {
                    rest.next();
                    out.push('⁻');
                }
                in_power = true;
            }
            _ if continues => out.push(superscript(c)),
            '-' if next.is_ascii_digit() => out.push('−'),
            c => out.push(c),
        }
        before = c;
    }
    out
}

fn superscript(digit: char) -> char {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    digit.to_digit(10).and_then(|k| digits.get(k as usize)).copied().unwrap_or(digit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(number(0.412_618_3, 7), "0.4126183");
        assert_eq!(number(2700.0, 7), "2700");
        assert_eq!(number(123_456.78, 7), "123456.8");
        assert_eq!(number(-4.580_5e-6, 6), "-4.5805e-6");
        assert_eq!(number(999_999.96, 7), "1e6");
        assert_eq!(number(6.371e6, 6), "6.371e6");
        assert_eq!(number(0.001, 6), "0.001");
        assert_eq!(number(1.0 / 3.0, 4), "0.3333");
        assert_eq!(number(-0.0, 6), "0");
        assert_eq!(number(5e-324, 6), "4.94066e-324");
        assert_eq!(number(f64::NAN, 6), "—");
        assert_eq!(number(f64::NEG_INFINITY, 6), "—");
    }

    #[test]
    fn exact_numbers_read_back() {
        for (x, text) in
            [(39.105_734_197_268_72, "39.10573419726872"), (2.0, "2"), (1e300, "1e300"), (-0.0, "-0")]
        {
            assert_eq!(exact(x), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), x.to_bits());
        }
    }

    #[test]
    fn a_column_shares_its_decimals_or_goes_its_own_way() {
        assert_eq!(alike(&[12.961_562, -17.608_532, 15.0], 8), ["12.961562", "-17.608532", "15.000000"]);
        assert_eq!(alike(&[0.5, 0.0, -0.25], 6), ["0.50", "0", "-0.25"]);
        assert_eq!(alike(&[1.0, 1e-9, 0.0], 6), ["1", "1e-9", "0"]);
        assert_eq!(alike(&[3.3248e-5, -4.5805e-6, 0.0], 5), ["3.3248e-5", "-4.5805e-6", "0"]);
        assert_eq!(alike(&[0.0, 0.0], 5), ["0", "0"]);
    }

    #[test]
    fn counts_and_zeros() {
        assert_eq!(count(2001), "2,001");
        assert_eq!(count(20_480_123), "20,480,123");
        assert_eq!(count(7), "7");
        assert_eq!(tidy([1e-17, -2e-17, 0.3]), [0.0, 0.0, 0.3]);
        assert_eq!(
            tidy_matrix([[1e-20, 1e-16, 0.0], [1e-16, 1.0, 0.5], [0.0, 0.5, 1.0]])[0],
            [1e-20, 0.0, 0.0]
        );
    }

    #[test]
    fn numbers_are_set() {
        for (text, set) in [
            ("-4.5e-5", "−4.5×10⁻⁵"),
            ("(1e12, -0.5, 3)", "(1×10¹², −0.5, 3)"),
            ("axis 3 = (0, -1, 0)", "axis 3 = (0, −1, 0)"),
            ("2 bodies, time-like: 1 each", "2 bodies, time-like: 1 each"),
            ("", ""),
        ] {
            assert_eq!(typeset(text), set);
        }
    }

    #[test]
    fn a_value_has_the_digits_of_its_error() {
        assert_eq!(with_error(1.234_56, 0.001_23), "1.2346 ± 0.0012");
        assert_eq!(with_error(0.5, 0.002_71), "0.5000 ± 0.0027");
        assert_eq!(with_error(-0.003_1, 0.02), "-0.003 ± 0.020");
        assert_eq!(with_error(-0.000_3, 0.02), "-3e-4 ± 0.02");
        assert_eq!(with_error(2.0, 100.0), "2 ± 100");
        assert_eq!(with_error(6.0, 100.0), "6 ± 100");
        assert_eq!(with_error(-1e-15, 0.02), "0.000 ± 0.020");
        assert_eq!(with_error(123.456, 3.2), "123.5 ± 3.2");
        assert_eq!(with_error(12_345.6, 321.0), "12346 ± 321");
        assert_eq!(with_error(1.234e-12, 3.21e-14), "1.234e-12 ± 3.2e-14");
    }
}
