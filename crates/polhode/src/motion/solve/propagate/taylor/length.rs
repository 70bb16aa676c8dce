//! How long a step may be, and of which order.
//!
//! Source: À. Jorba, M. Zou, Exp. Math. 14 (2005) 99. Their order, 1 − ½ ln ε, is best where the time of a step grows with its square. Here
//! it grows less, so that higher orders and longer steps are faster; between 17 and 23 it hardly matters at 1e-6 (5 % at most, AMD Zen 5).

use super::Expansion;
use super::row::{INVERSES, Row, TERMS, larger, smaller};
use crate::math::number::Number;

/// How many of the last coefficients the length of a step does not wait for.
const EARLY: usize = 2;

impl<N: Number> Expansion<N> {
    /// The longest step at which the terms that are left out are as small as they should be; `scale` is what ω is measured with, zero where
    /// nothing turns and no torque acts yet: then the turn alone says how long a step may be.
    ///
    /// With a radius ρ = min (1/|xₙ|^(1/n), 1/|xₙ₋₁|^(1/(n−1))) they are about (h/ρ)^(p+1) / (1 − h/ρ). n is less than p by [`EARLY`], so that ρ is found
    /// while the last coefficients are.
    #[inline(always)]
    pub(super) fn step(&self, scale: N) -> N {
        let n = self.order - EARLY;
        let unit = scale.map(|scale| if scale > 0.0 { 1.0 / scale } else { 0.0 });
        let (last, before) = (self.log_radius(n, unit), self.log_radius(n - 1, unit));
        let mut radius = smaller(last, before);
        let not_finite = last + before;
        for lane in (0..N::LANES).filter(|lane| not_finite.lane(*lane).is_nan()) {
            // Coefficients that are beyond all numbers: the last two that are not.
            let pair = |n: usize| [n, n - 1].map(|n| self.log_radius(n, unit).lane(lane));
            let sound = (2..=n).rev().map(pair).find(|[a, b]| a.is_finite() && b.is_finite());
            radius.put(lane, sound.map_or(radius.lane(lane), |[a, b]| a.min(b)));
        }
        radius.map(|radius| rough_exp2(radius + self.reach))
    }

    /// log₂ of 1/|xₙ|^(1/n): digits beyond the third do not matter. No number, if xₙ has one that is not finite.
    #[inline(always)]
    fn log_radius(&self, n: usize, unit: N) -> N {
        let (omega, turn) = (self.omega_at(n), self.motion[n].x.first());
        let size = larger(omega.largest() * unit, turn.largest());
        let none = Row::splat(self.zero());
        let ([inverse, _], [x, y, z, w]) = (INVERSES[n], (omega * none + turn * none).0);
        size.map(|size| rough_log2(size) * -inverse) + ((x + y) + (z + w))
    }
}

/// The order of a tolerance.
pub(in crate::motion) fn order(tolerance: f64) -> usize {
    ((14.0 - 0.3 * tolerance.ln()).ceil() as usize).min(TERMS - 1)
}

/// The terms that are left out at a tolerance: the errors of all steps add up, and less where steps are long.
pub(in crate::motion) fn remainder(tolerance: f64) -> f64 {
    let loosely = rough_exp2(0.35 * rough_log2(tolerance / 1e-9)).max(1.0);
    (4e-4 * tolerance * loosely).max(SMALLEST_REMAINDER)
}

/// Less is lost in rounding.
const SMALLEST_REMAINDER: f64 = 5e-18;

/// log₂ x of x^(p+1)/(1 − x) = the remainder.
pub(in crate::motion) fn reach(order: usize, remainder: f64) -> f64 {
    let (power, remainder) = (1.0 / (order + 1) as f64, rough_log2(remainder));
    // From x = 0, a few rounds are enough: each leaves a hundredth of the error, as the right-hand side hardly changes.
    let log = |x: f64| (remainder + rough_log2(1.0 - x)) * power;
    (0..3).fold(log(0.0), |x, _| log(rough_exp2(x)))
}

/// log₂ of a number that is not negative, to 0.043: a part in 600 of a step.
///
/// The bits of a number, read as one of fixed point, are its logarithm but for the chord in place of the curve. No branch, and no
/// more than shifts for the integers: eight at once are vectors.
#[inline(always)]
pub(in crate::motion) fn rough_log2(x: f64) -> f64 {
    // The integer n < 2⁵² is the mantissa of 2⁵² + n.
    let bits = f64::from_bits(TWO_52.to_bits() | x.to_bits() >> 20) - TWO_52;
    let log = bits * TWO_32.recip() - (1023.0 - 0.043);
    if x >= f64::MIN_POSITIVE { log } else { f64::NEG_INFINITY }
}

/// 2ˣ, to 2e-3; infinite and zero where f64 ends.
#[inline(always)]
pub(in crate::motion) fn rough_exp2(x: f64) -> f64 {
    // The nearest integer n: n + 1023, an exponent, is the end of the mantissa.
    let shifted = x + (TWO_52 + 1023.0);
    let m = x - (shifted - (TWO_52 + 1023.0));
    let power = f64::from_bits(shifted.to_bits() << 52);
    let exp = power * ((1.000443 + m * 0.703448) + (m * m) * 0.238428);
    let end = if x > 0.0 { f64::INFINITY } else { x.abs() * 0.0 };
    if x.abs() < 1022.0 { exp } else { end }
}

const TWO_52: f64 = 4_503_599_627_370_496.0;
const TWO_32: f64 = 4_294_967_296.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rough_logarithms_and_powers_are_as_good_as_they_say() {
        let sizes = (0..20_000).map(|k| libm::exp2(f64::from(k) * 0.1022 - 1021.5));
        for size in sizes.chain([f64::MIN_POSITIVE, 1.0, f64::MAX]) {
            assert!((rough_log2(size) - libm::log2(size)).abs() < 0.044, "{size:e}");
        }
        for power in (0..20_000).map(|k| f64::from(k) * 0.1021 - 1020.9) {
            assert!((rough_exp2(power) / libm::exp2(power) - 1.0).abs() < 2e-3, "{power}");
        }
        let ends = [rough_exp2(1022.5), rough_exp2(-1022.5), rough_exp2(f64::INFINITY), rough_log2(0.0)];
        assert_eq!(ends, [f64::INFINITY, 0.0, f64::INFINITY, f64::NEG_INFINITY]);
        assert!(rough_exp2(f64::NAN).is_nan());
    }

    #[test]
    fn what_a_step_leaves_out_is_the_remainder() {
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-15] {
            let (p, wanted) = (order(tolerance), remainder(tolerance));
            let x = libm::exp2(reach(p, wanted));
            let left = libm::pow(x, (p + 1) as f64) / (1.0 - x);
            assert!((left / wanted).ln().abs() < 0.15, "{tolerance:e}: {left:e} {wanted:e}");
        }
    }
}
