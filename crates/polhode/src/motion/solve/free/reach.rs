//! How far from its start a free motion is right.

use crate::math::double::Double;
use crate::math::number::PI;
use crate::math::triple::Triple;
use crate::motion::solve::reach::Drift;

use super::elements::Elements;
use super::labelled::Labelled;

/// The laws (31) and (32) of `book/free-motion.md`, section 8: how fast the phases of a motion drift from the true ones.
///
/// Rates of the elements are in units of `rad_s`. `given`: the moments and ω along their axes are the numbers given.
pub(super) fn of(elements: &Elements, labelled: &Labelled, given: bool, rad_s: f64) -> f64 {
    let lambda = elements.lambda.value().abs();
    let turns = 2.0 * elements.half_precession.value().abs() + lambda / (2.0 * PI);
    // Where nothing circles, all three words of the precession are good.
    let word = if elements.lambda.is_zero() { THREE_WORDS } else { TWO_WORDS };
    let quarter = elements.quarter.value();
    let of_period = 2.0 * uncertainty_of_excess(labelled, given, elements.lambda) * lambda / (4.0 * quarter);
    let law = Drift(word * turns + of_period).reach();
    // Before half a period has passed, the length of the period does not matter.
    let half_period = if lambda > 0.0 { quarter.min(FAR_DOWN) / lambda } else { 0.0 };
    (law.max(half_period) / rad_s).min(f64::MAX)
}

/// Of a turn, by rates of two words: (31).
const TWO_WORDS: f64 = 1e-31;

/// And of three, the moments among them.
const THREE_WORDS: f64 = 1e-45;

/// e^−50 is far below the last digit: the middle axis is reached.
const FAR_DOWN: f64 = 50.0;

/// Of L² − 2T i2, relative, formed in three words from terms that cancel near the separatrix: (32).
fn uncertainty_of_excess(labelled: &Labelled, given: bool, lambda: Double) -> f64 {
    let [i1, i2, i3] = labelled.moments.map(Triple::value);
    let [w1, _, w3] = labelled.omega.map(|w| w.value() / labelled.excess_unit);
    let (s1, s3) = (i1 * (i1 - i2).abs() * w1.abs(), i3 * (i3 - i2).abs() * w3.abs());
    // What is found of axes is good to a part of |ω|, not of each component.
    let found = if given { 0.0 } else { (s1 + s3) / labelled.excess_unit };
    let excess = labelled.excess.value().abs();
    if lambda.is_zero() || (excess == 0.0 && given) {
        return 0.0;
    }
    LAST_OF_THREE * (s1 * w1.abs() + s3 * w3.abs() + found) / excess
}

/// Less than 2⁻¹⁵⁸.
const LAST_OF_THREE: f64 = 2e-48;
