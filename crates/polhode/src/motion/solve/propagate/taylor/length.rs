//! Length and order of a Taylor step.
//!
//! Source: À. Jorba, M. Zou, Exp. Math. 14 (2005) 99. Their order, 1 − ½ ln ε, is optimal if the
//! time per step grows with the square of the order. Here it grows more slowly, so higher orders
//! with longer steps are faster. Orders 17 to 23 differ by at most 5 % at 1e-6 (AMD Zen 5).

use super::Expansion;
use super::row::{INVERSES, Row, TERMS, larger, smaller};
use crate::math::number::Number;

/// Number of last coefficients that the step length does not use.
const EARLY: usize = 2;

impl<N: Number> Expansion<N> {
    /// Returns the longest step for which the truncation error is below the tolerance. `scale` is
    /// the scale of ω. It is zero if nothing rotates and no torque acts; then only the rotation
    /// determines the step.
    ///
    /// Let ρ = min (1/|xₙ|^(1/n), 1/|xₙ₋₁|^(1/(n−1))). The truncation error is about
    /// (h/ρ)^(p+1) / (1 − h/ρ). n is less than the order p by [`EARLY`], so that ρ is known before the
    /// last coefficients are.
    #[inline(always)]
    pub(super) fn step(&self, scale: N) -> N {
        let n = self.order - EARLY;
        let unit = scale.map(|scale| if scale > 0.0 { 1.0 / scale } else { 0.0 });
        let (last, before) = (self.log_radius(n, unit), self.log_radius(n - 1, unit));
        let mut radius = smaller(last, before);
        let not_finite = last + before;
        for lane in (0..N::LANES).filter(|lane| not_finite.lane(*lane).is_nan()) {
            // If coefficients overflow, use the last two that are finite.
            let pair = |n: usize| [n, n - 1].map(|n| self.log_radius(n, unit).lane(lane));
            let sound = (2..=n).rev().map(pair).find(|[a, b]| a.is_finite() && b.is_finite());
            radius.put(lane, sound.map_or(radius.lane(lane), |[a, b]| a.min(b)));
        }
        radius.map(|radius| rough_exp2(radius + self.reach))
    }

    /// Returns log₂ of 1/|xₙ|^(1/n), to three digits. Returns NaN if a component of xₙ is not
    /// finite.
    #[inline(always)]
    fn log_radius(&self, n: usize, unit: N) -> N {
        let (omega, turn) = (self.omega_at(n), self.motion[n].x.first());
        let size = larger(omega.largest() * unit, turn.largest());
        let none = Row::splat(self.zero());
        let ([inverse, _], [x, y, z, w]) = (INVERSES[n], (omega * none + turn * none).0);
        size.map(|size| rough_log2(size) * -inverse) + ((x + y) + (z + w))
    }
}

/// Returns the order for a tolerance.
pub(in crate::motion) fn order(tolerance: f64) -> usize {
    ((14.0 - 0.3 * tolerance.ln()).ceil() as usize).min(TERMS - 1)
}

/// Returns the allowed truncation error of a step for a tolerance. The errors of all steps add up;
/// long steps are fewer and may have more.
pub(in crate::motion) fn remainder(tolerance: f64) -> f64 {
    let loosely = rough_exp2(0.35 * rough_log2(tolerance / 1e-9)).max(1.0);
    (4e-4 * tolerance * loosely).max(SMALLEST_REMAINDER)
}

/// Lower bound on the truncation error, below the rounding error.
const SMALLEST_REMAINDER: f64 = 5e-18;

/// Returns log₂ x for the solution of x^(p+1)/(1 − x) = `remainder`.
pub(in crate::motion) fn reach(order: usize, remainder: f64) -> f64 {
    let (power, remainder) = (1.0 / (order + 1) as f64, rough_log2(remainder));
    // Fixed-point iteration from x = 0. Each round reduces the error to a hundredth, because the
    // right-hand side hardly changes.
    let log = |x: f64| (remainder + rough_log2(1.0 - x)) * power;
    (0..3).fold(log(0.0), |x, _| log(rough_exp2(x)))
}

/// Returns log₂ of a non-negative number with an error below 0.043. The relative effect on a step
/// length is at most 1/600.
///
/// The bits of an f64, read as a fixed-point number, are its logarithm with the curve replaced by
/// chords. The function has no branches and uses only integer shifts, so it vectorises to eight
/// numbers.
#[inline(always)]
pub(in crate::motion) fn rough_log2(x: f64) -> f64 {
    // An integer n < 2⁵² is the mantissa of 2⁵² + n.
    let bits = f64::from_bits(TWO_52.to_bits() | x.to_bits() >> 20) - TWO_52;
    let log = bits * TWO_32.recip() - (1023.0 - 0.043);
    if x >= f64::MIN_POSITIVE { log } else { f64::NEG_INFINITY }
}

/// Returns 2ˣ with a relative error below 2e-3; infinity and zero outside the range of f64.
#[inline(always)]
pub(in crate::motion) fn rough_exp2(x: f64) -> f64 {
    // n is the nearest integer. n + 1023, the exponent field, is in the last bits of the mantissa.
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
