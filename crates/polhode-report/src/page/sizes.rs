//! Numbers of the page in units of a size that people say: milliradians per second, microjoules, picoseconds, days.

use polhode_document::number::{number, typeset, vector};
use polhode_document::si_prefix::fitting;
use polhode_document::unit;
use polhode_document::unit::DIGITS;

/// A number, and its unit.
pub(super) type Sized = (String, String);

/// `1.945 152`, `µJ`
pub(super) fn energy(joule: f64) -> Sized {
    prefixed(joule, "J")
}

/// `1.109 695`, `mrad/s`; large rates stay in rad/s.
pub(super) fn rate(rad_per_s: f64) -> Sized {
    prefixed(rad_per_s, "rad/s")
}

/// Three rates in one unit.
pub(super) fn rates(rad_per_s: [f64; 3]) -> Sized {
    let (prefix, size) = fitting(largest(rad_per_s), "rad/s").unwrap_or(("", 1.0));
    (vector(rad_per_s.map(|x| x / size), DIGITS), format!("{prefix}rad/s"))
}

/// From one rate to another, in one unit: `10.2665 … 10.5486`, `µrad/s`.
pub(super) fn rate_range([least, most]: [f64; 2]) -> Sized {
    let (prefix, size) = fitting(most, "rad/s").unwrap_or(("", 1.0));
    let [least, most] = [least, most].map(|rate| number(rate / size, 6));
    let value = if least == most { least } else { format!("{least} … {most}") };
    (value, format!("{prefix}rad/s"))
}

/// `5.634 747`, `ps`; what is long in days or hours too: `463 841 s`, `(5.368 53 d)`.
pub(super) fn duration(seconds: f64) -> Sized {
    match unit::longer(seconds) {
        Some(_) => (unit::duration(seconds, DIGITS), String::new()),
        None => prefixed(seconds, "s"),
    }
}

/// Three numbers with one power of ten before the unit, where they are small or large: `(4.3, 4.3, 1.2)`, `×10⁻⁴ kg·m²`.
pub(super) fn three(values: [f64; 3], unit: &str) -> Sized {
    let size = largest(values);
    let exponent = if size > 0.0 && size.is_finite() { size.log10().floor() } else { 0.0 };
    if (-2.0..=4.0).contains(&exponent) {
        return (vector(values, DIGITS), unit.to_owned());
    }
    let power = 10_f64.powf(exponent);
    if !power.is_normal() {
        return (vector(values, DIGITS), unit.to_owned());
    }
    let factor = typeset(&format!("1e{exponent}"));
    (vector(values.map(|x| x / power), DIGITS), format!("{} {unit}", factor.trim_start_matches('1')))
}

fn prefixed(value: f64, unit: &str) -> Sized {
    match fitting(value.abs(), unit) {
        Some((prefix, size)) => (number(value / size, DIGITS), format!("{prefix}{unit}")),
        None => (number(value, DIGITS), unit.to_owned()),
    }
}

fn largest(values: [f64; 3]) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode_document::layout::plain_spaces;

    fn text((value, unit): Sized) -> String {
        plain_spaces(&format!("{value} {unit}")).trim_end().to_owned()
    }

    #[test]
    fn units_are_of_a_size_that_people_say() {
        assert_eq!(text(energy(1.945_152e-7)), "0.194 515 2 µJ");
        assert_eq!(text(energy(0.002_337_246)), "2.337 246 mJ");
        assert_eq!(text(energy(159.89)), "159.89 J");
        assert_eq!(text(energy(6.214_474e-22)), "6.214 474e-22 J");
        assert_eq!(text(energy(0.0)), "0 J");
        assert_eq!(text(rate(1.109_695e-3)), "1.109 695 mrad/s");
        assert_eq!(text(rate(8.000_312e12)), "8.000 312e12 rad/s");
        assert_eq!(text(rates([3.14e-5, -0.001_103, 0.0])), "(0.0314, -1.103, 0) mrad/s");
        assert_eq!(text(rate_range([1.026_65e-5, 1.054_86e-5])), "10.2665 … 10.5486 µrad/s");
        assert_eq!(text(rate_range([0.4, 0.4])), "0.4 rad/s");
        assert_eq!(text(duration(5.634_747e-12)), "5.634 747 ps");
        assert_eq!(text(duration(463_841.0)), "463 841 s (5.368 53 d)");
        assert_eq!(text(duration(9_000.0)), "9000 s");
        assert_eq!(text(three([4.5e-4, 0.0, -1.26e-5], "kg·m²")), "(4.5, 0, -0.126) ×10⁻⁴ kg·m²");
        assert_eq!(text(three([0.34, 0.31, 0.026], "kg·m²")), "(0.34, 0.31, 0.026) kg·m²");
        assert_eq!(text(three([0.0; 3], "kg·m²")), "(0, 0, 0) kg·m²");
    }
}
