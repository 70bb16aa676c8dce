//! Some moments, or one product, wrong by a common factor with everything else right:
//! `inertia.geometry`.
//!
//! `izz="1676359E-6"` next to moments of about 2e-3 kg·m² has a missing decimal point: 1676.359E-6
//! is right. Two moments may be ten times too small, or one may lack the mass. Only the factors
//! listed here count as errors.

use super::explanation::{Candidates, Change, LOOSE, Slip, TIGHT, named as elements, times_too};
use super::placeholder::is_round;

/// Relative difference below which two second moments are equal, as for a round or square section.
pub(super) const ROUND_SECTION: f64 = 0.01;

pub(super) const RULE: &str = "a tensor follows from the mass and the shape of its own link";

/// Returns correction factors with the description of the error, without powers of ten.
///
/// The moment of a tube with a round or square section is twice that of a solid one. A factor of 2
/// therefore proves nothing there.
pub(super) fn named(candidates: &Candidates) -> impl Iterator<Item = (f64, &'static str)> + use<> {
    let mass = candidates.mass;
    let [a, b, c] = candidates.second_moments();
    let equal = |x: f64, y: f64| (x - y).abs() <= ROUND_SECTION * x.max(y);
    let may_be_a_tube = equal(a, b) || equal(b, c) || equal(a, c);
    [
        (mass, "the factor m (mass) is missing"),
        (1.0 / mass, "multiplied by the mass twice"),
        (0.25, "4 times too large: full lengths instead of half lengths, or a diameter instead of a radius"),
        (4.0, "4 times too small: half lengths instead of full lengths, or a radius instead of a diameter"),
        (0.5, "2 times too large: H²/2 instead of (H/2)²"),
    ]
    .into_iter()
    .filter(move |(factor, _)| *factor != 0.5 || !may_be_a_tube)
    // For a mass of about 1 kg the tensor is right with or without the factor.
    .filter(|(factor, _)| (factor - 1.0).abs() > LOOSE)
}

pub(super) fn explain(candidates: &mut Candidates) {
    let body = candidates.body;
    if is_round(body) {
        return; // a placeholder
    }
    let loose = candidates.loose();
    for k in (0..6).filter(|k| body.written[*k] != 0.0) {
        let ratio = candidates.target[k] / body.written[k];
        let power = ratio.abs().log10().round();
        if ratio > 0.0 && power != 0.0 && power.abs() <= 12.0 {
            let power = power as i32;
            offer(candidates, k, 10_f64.powi(power), Change::Shift(power), loose, &times_too(power));
        }
        if ratio < 0.0 && k < 3 {
            offer(candidates, k, -1.0, Change::Negate, loose, "negative");
        }
    }
    for k in 0..3 {
        for (factor, why) in named(candidates) {
            offer(candidates, k, factor, Change::Scale(factor), TIGHT, why);
        }
    }
}

/// Offers one change of all moments that a factor corrects, element k being the first; for a
/// product, of that element alone.
fn offer(candidates: &mut Candidates, k: usize, factor: f64, change: Change, tolerance: f64, why: &str) {
    let body = candidates.body;
    let is_wrong = |j: usize| {
        let [right, size] = [body.written[j] * factor, candidates.target[j].abs()];
        !candidates.agrees(j, tolerance) && (right - candidates.target[j]).abs() <= (tolerance + 0.01) * size
    };
    let wrong: Vec<usize> = if k < 3 { (0..3).filter(|j| is_wrong(*j)).collect() } else { vec![k] };
    if wrong.first() != Some(&k) {
        return;
    }
    let changes = std::array::from_fn(|j| if wrong.contains(&j) { change } else { Change::Keep });
    candidates.offer(changes, tolerance, || Slip {
        code: "inertia.geometry",
        mistake: format!("{}: {why}", elements(&wrong)),
        rule: RULE,
        span: body.place(k),
        is_sure: true,
    });
}
