//! Constant curves: they are not drawn, but stated with their value and variation.

use polhode_document::figure::prefix;
use polhode_document::number::{error, typeset};

/// Largest variation of a constant curve, relative to its own size.
const SPREAD: f64 = 1e-6;

/// Rounding threshold: values below this part of the size of the quantity are zero.
const ZERO: f64 = 1e-12;

/// Number of significant digits of the value.
const DIGITS: usize = 6;

/// Constant value of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Constant {
    /// Zero; with the largest deviation.
    Zero(f64),
    /// Nonzero value; with its relative variation, greatest minus least.
    Value(f64, f64),
    /// Value of a curve with a single sample, which may or may not be constant.
    Single(f64),
}

impl Constant {
    /// Returns the constant value of a curve; `None` if it varies, or has a value that is not
    /// finite.
    ///
    /// `scale` is the size of the quantity, which determines rounding errors.
    pub(crate) fn of(values: impl Iterator<Item = f64>, scale: f64) -> Option<Self> {
        let [mut least, mut greatest] = [f64::INFINITY, f64::NEG_INFINITY];
        let mut count = 0_usize;
        for x in values {
            count += 1;
            if !x.is_finite() {
                return None;
            }
            (least, greatest) = (least.min(x), greatest.max(x));
        }
        let size = least.abs().max(greatest.abs());
        if !size.is_finite() {
            return None;
        }
        if size <= ZERO * scale {
            return Some(Self::Zero(size));
        }
        if count == 1 {
            return Some(Self::Single(least));
        }
        let spread = (greatest - least) / size;
        (spread < SPREAD).then_some(Self::Value(0.5 * (least + greatest), spread))
    }

    /// Returns a statement such as `T = 3.73784 J, constant to 6.8×10⁻¹⁷`. If the samples may miss
    /// an oscillation, it refers to the samples only.
    pub(crate) fn said(self, name: &str, unit: &str, is_sampled: bool) -> String {
        let samples = if is_sampled { " at all samples" } else { "" };
        match self {
            Self::Zero(0.0) => format!("{name} = 0{samples}"),
            Self::Zero(size) => format!("{name} = 0, to {}{samples}", prefix::value(size, 2, unit)),
            Self::Single(value) => format!("{name} = {}", prefix::value(value, DIGITS, unit)),
            Self::Value(value, spread) => {
                let value = prefix::value(value, DIGITS, unit);
                let drift =
                    if spread > 0.0 { format!(" to {}", typeset(&error(spread))) } else { String::new() };
                let stays = if is_sampled { "the same" } else { "constant" };
                format!("{name} = {value}, {stays}{samples}{drift}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode_document::layout::plain_spaces;

    #[test]
    fn what_varies_by_less_than_a_millionth_is_constant() {
        let wave =
            |part: f64| (0..137).map(move |k| 240.85 * (1.0 + 0.5 * part * (0.37 * f64::from(k)).sin()));
        let Some(Constant::Value(value, spread)) = Constant::of(wave(0.97e-6), 300.0) else { panic!() };
        assert!((value / 240.85 - 1.0).abs() < 1e-8 && (0.9e-6..1e-6).contains(&spread), "{value} {spread}");
        assert_eq!(Constant::of(wave(1.03e-6), 300.0), None);
        // The variation is relative to the curve's own size, not to that of a larger curve.
        assert_eq!(Constant::of([1e-4, 1.001e-4].into_iter(), 1e3), None);
        assert_eq!(Constant::of([3.1, f64::INFINITY].into_iter(), 4.0), None);
        assert_eq!(Constant::of([3.1, f64::NAN].into_iter(), 4.0), None);
        assert_eq!(Constant::of(std::iter::empty(), 4.0), None);
    }

    #[test]
    fn what_is_rounding_beside_its_quantity_is_zero() {
        let noise = || [3e-13, -7e-13, 0.0].into_iter();
        assert_eq!(Constant::of(noise(), 0.8), Some(Constant::Zero(7e-13)));
        assert_eq!(Constant::of(noise(), 0.6), None);
    }

    #[test]
    fn a_constant_is_said_with_its_drift() {
        let said = |constant: Constant, unit| plain_spaces(&constant.said("T + U", unit, false));
        assert_eq!(
            said(Constant::Value(3.737_841_2, 6.83e-17), "J"),
            "T + U = 3.73784 J, constant to 6.8×10⁻¹⁷"
        );
        assert_eq!(said(Constant::Value(-0.3, 0.0), "N·m"), "T + U = −0.3 N·m, constant");
        assert_eq!(said(Constant::Zero(0.0), "J"), "T + U = 0");
        assert_eq!(said(Constant::Zero(2.31e-17), "kg·m²/s"), "T + U = 0, to 2.3×10⁻¹⁷ kg·m²/s");
    }

    #[test]
    fn samples_far_apart_say_only_what_they_are() {
        let said = |constant: Constant| plain_spaces(&constant.said("ω₁", "rad/s", true));
        assert_eq!(
            said(Constant::Value(0.3, 2.3e-16)),
            "ω₁ = 0.3 rad/s, the same at all samples to 2.3×10⁻¹⁶"
        );
        assert_eq!(said(Constant::Zero(0.0)), "ω₁ = 0 at all samples");
        assert_eq!(said(Constant::Zero(1.7e-17)), "ω₁ = 0, to 1.7×10⁻¹⁷ rad/s at all samples");
    }

    #[test]
    fn a_single_value_is_not_said_to_be_constant() {
        let single = Constant::of(std::iter::once(-0.37), 4.0).unwrap();
        assert_eq!(plain_spaces(&single.said("ω₂", "rad/s", false)), "ω₂ = −0.37 rad/s");
        assert_eq!(plain_spaces(&single.said("ω₂", "rad/s", true)), "ω₂ = −0.37 rad/s");
    }
}
