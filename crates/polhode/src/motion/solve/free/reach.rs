//! Time from the start for which a free motion is accurate.

use crate::math::double::Double;
use crate::math::number::PI;
use crate::math::triple::Triple;
use crate::motion::solve::reach::Drift;

use super::elements::Elements;
use super::labelled::Labelled;

/// Returns the reach, s, by the laws (31) and (32) of `book/free-motion-accuracy.md`. They bound the
/// drift of the computed phases from the true phases.
///
/// `rad_s`: unit of the elements' rates. `given`: true if the moments and ω along their axes are
/// exact inputs.
pub(super) fn of(elements: &Elements, labelled: &Labelled, given: bool, rad_s: f64) -> f64 {
    let lambda = elements.lambda.value().abs();
    let turns = 2.0 * elements.half_precession.value().abs() + lambda / (2.0 * PI);
    // If λ = 0, all three words of the precession rate are accurate.
    let word = if elements.lambda.is_zero() { THREE_WORDS } else { TWO_WORDS };
    let quarter = elements.quarter.value();
    let of_period = 2.0 * uncertainty_of_excess(labelled, given, elements.lambda) * lambda / (4.0 * quarter);
    let law = Drift(word * turns + of_period).reach();
    // Before half a period has passed, the length of the period does not matter.
    let half_period = if lambda > 0.0 { quarter.min(FAR_DOWN) / lambda } else { 0.0 };
    (law.max(half_period) / rad_s).min(f64::MAX)
}

/// Relative uncertainty of a turn, for rates of two accurate words: (31).
const TWO_WORDS: f64 = 1e-31;

/// Relative uncertainty of a turn, for rates and moments of three accurate words.
const THREE_WORDS: f64 = 1e-45;

/// Time in units of 1/λ after which the intermediate axis is reached: e^−50 is far below f64
/// rounding.
const FAR_DOWN: f64 = 50.0;

/// Relative uncertainty of L² − 2T i2, formed in three words from terms that cancel near the
/// separatrix: (32).
fn uncertainty_of_excess(labelled: &Labelled, given: bool, lambda: Double) -> f64 {
    let [i1, i2, i3] = labelled.moments.map(Triple::value);
    let [w1, _, w3] = labelled.omega.map(|w| w.value() / labelled.excess_unit);
    let (s1, s3) = (i1 * (i1 - i2).abs() * w1.abs(), i3 * (i3 - i2).abs() * w3.abs());
    // The error of computed axes is relative to |ω|, not to each component of ω.
    let found = if given { 0.0 } else { (s1 + s3) / labelled.excess_unit };
    let excess = labelled.excess.value().abs();
    if lambda.is_zero() || (excess == 0.0 && given) {
        return 0.0;
    }
    LAST_OF_THREE * (s1 * w1.abs() + s3 * w3.abs() + found) / excess
}

/// Relative rounding error in three words: less than 2⁻¹⁵⁸.
const LAST_OF_THREE: f64 = 2e-48;
