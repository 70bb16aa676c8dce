//! Ticks of an axis: steps of 1, 2 or 5 times a power of ten, and their labels.

/// Ticks of an axis with values of order 1; other values are divided by a power of ten first.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// Values at the ticks.
    pub values: Vec<f64>,
    /// Label of each tick.
    pub labels: Vec<String>,
}

/// Returns the power of ten, a multiple of three, to divide out of numbers up to `largest`: 0 from
/// 0.01 to 10 000.
pub fn exponent(largest: f64) -> i32 {
    let largest = largest.abs();
    if !(largest > 0.0 && largest.is_finite()) || (0.01..10_000.0).contains(&largest) {
        return 0;
    }
    let power = largest.log10().floor() as i32;
    power.div_euclid(3) * 3
}

/// Returns x / 10^exponent, without overflow for any exponent of an f64.
pub fn reduced(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x / 10_f64.powi(half) / 10_f64.powi(exponent - half)
}

impl Ticks {
    /// Creates about `count` ticks from `least` to `greatest`.
    pub fn linear(least: f64, greatest: f64, count: f64) -> Self {
        let step = step((greatest - least) / count.max(1.0));
        let decimals = (-step.log10().floor()).clamp(0.0, 17.0) as usize;
        let (first, last) = ((least / step - 1e-9).ceil(), (greatest / step + 1e-9).floor());
        // Guards against a very large count; a plot has about ten ticks.
        let count = if (last - first) < 1000.0 { (last - first) as u32 } else { 0 };
        let values: Vec<f64> = (0..=count).map(|k| (first + f64::from(k)) * step).collect();
        let labels = values.iter().map(|&x| label(x, decimals)).collect();
        Self { values, labels }
    }

    /// Creates at most `most` ticks at powers of ten from 10^least to 10^greatest; the values are
    /// the exponents.
    pub fn powers(least: i32, greatest: i32, most: i32) -> Self {
        let step = ((greatest - least) / most.max(1) + 1).max(1);
        let powers: Vec<i32> = (least..=greatest).filter(|power| power.rem_euclid(step) == 0).collect();
        Self {
            values: powers.iter().map(|&power| f64::from(power)).collect(),
            labels: powers.iter().map(|&power| power_of_ten(power)).collect(),
        }
    }
}

/// Returns the number 1, 2 or 5 times a power of ten that is closest to x as a ratio.
fn step(x: f64) -> f64 {
    let power = 10_f64.powi(x.log10().floor().clamp(-300.0, 300.0) as i32);
    // The boundary between two candidates is their geometric mean.
    let step = match x / power {
        part if part < 2.0_f64.sqrt() => 1.0,
        part if part < 10.0_f64.sqrt() => 2.0,
        part if part < 50.0_f64.sqrt() => 5.0,
        _ => 10.0,
    };
    step * power
}

/// Formats a number with `decimals` decimals and a typographic minus sign.
fn label(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    let is_zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    if is_zero { "0".to_owned() } else { text.replace('-', "−") }
}

/// Formats a power of ten as `10⁻¹⁵`; 1 for the power 0.
pub fn power_of_ten(power: i32) -> String {
    const HIGH: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if power == 0 {
        return "1".to_owned();
    }
    let digits = power.unsigned_abs().to_string();
    let high = digits.bytes().filter_map(|digit| HIGH.get(usize::from(digit - b'0')));
    ["10", if power < 0 { "⁻" } else { "" }].into_iter().flat_map(str::chars).chain(high.copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_one_two_or_five() {
        let ticks = |a, b, n| Ticks::linear(a, b, n).labels.join(" ");
        assert_eq!(ticks(-0.37, 1.21, 4.0), "0 0.5 1.0");
        assert_eq!(ticks(-6.3, 6.1, 6.0), "−6 −4 −2 0 2 4 6");
        assert_eq!(ticks(0.0, 20.0, 10.0), "0 2 4 6 8 10 12 14 16 18 20");
        assert_eq!(ticks(99.991, 99.994, 3.0), "99.991 99.992 99.993 99.994");
        assert_eq!(ticks(-0.000_3, 0.000_3, 4.0), "−0.0002 0 0.0002");
        let one = Ticks::linear(1e9, 1e9 + 7.3, 4.0);
        assert_eq!(one.labels, ["1000000000", "1000000002", "1000000004", "1000000006"]);
    }

    #[test]
    fn marks_stay_inside_and_are_what_they_say() {
        for k in 0..200 {
            let least = -3.7 + 0.317 * f64::from(k);
            let greatest = least + 10_f64.powf(-4.0 + 0.04 * f64::from(k));
            let ticks = Ticks::linear(least, greatest, 6.0);
            assert!((3..=13).contains(&ticks.values.len()), "{least} {greatest}: {ticks:?}");
            for (value, label) in ticks.values.iter().zip(&ticks.labels) {
                let slack = 1e-8 * (greatest - least);
                assert!((least - slack..=greatest + slack).contains(value));
                let read: f64 = label.replace('−', "-").parse().unwrap();
                assert!((read - value).abs() <= slack, "{label} {value}");
            }
        }
    }

    #[test]
    fn large_and_small_numbers_lose_a_power_of_ten() {
        assert_eq!(
            [0.0, 0.5, 9999.0, 12_345.0, 3e-3, 4.4e-5, 2e-300].map(exponent),
            [0, 0, 0, 3, -3, -6, -300]
        );
        assert!((reduced(4.4e-5, -6) - 44.0).abs() < 1e-13);
        assert!((reduced(3e-322, -324) / 300.0 - 1.0).abs() < 0.02);
        assert_eq!([0, -15, 6].map(power_of_ten), ["1", "10⁻¹⁵", "10⁶"]);
        assert_eq!(Ticks::powers(-18, -11, 4).labels, ["10⁻¹⁸", "10⁻¹⁶", "10⁻¹⁴", "10⁻¹²"]);
    }
}
