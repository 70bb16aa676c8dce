//! Principal moments of the body, their axes, and the check that they are physical.

use polhode::body::{InertiaTensor, PrincipalFrame, Symmetry};
use polhode::math::{Body, Direction};
use polhode_document::number::{NO_BREAK, number};

/// Significant digits of a moment.
const DIGITS: usize = 6;

/// Returns true if some distribution of mass has these moments.
pub(crate) fn is_possible(principal: &PrincipalFrame<Body>) -> bool {
    InertiaTensor::<Body>::diagonal(principal.moments()).is_ok()
}

/// Describes the moments, such as `1, 2, 3 kg·m²: physical (1 + 2 = 3: a flat plate)`.
pub(crate) fn in_words(principal: &PrincipalFrame<Body>) -> String {
    let verdict = verdict(principal).replace(' ', &NO_BREAK.to_string());
    format!("{}: {verdict}", moments(principal))
}

/// Describes the moments in ascending order, each with its axis unless that is the body axis of the
/// same number.
fn moments(principal: &PrincipalFrame<Body>) -> String {
    let [i1, i2, i3] = principal.moments().map(|i| number(i, DIGITS));
    match principal.axes().map(name) {
        [Some("x"), Some("y"), Some("z")] => format!("{i1}, {i2}, {i3} kg·m²"),
        [Some(n1), Some(n2), Some(n3)] => {
            format!("axis 1 ({n1}) {i1}, axis 2 ({n2}) {i2}, axis 3 ({n3}) {i3} kg·m²")
        }
        _ => format!("axis 1 {i1}, axis 2 {i2}, axis 3 {i3} kg·m², principal"),
    }
}

/// Returns the name of the body axis along a principal axis.
fn name(axis: Direction<Body>) -> Option<&'static str> {
    let along = axis.to_array().iter().position(|c| c.abs() == 1.0)?;
    ["x", "y", "z"].get(along).copied()
}

fn verdict(principal: &PrincipalFrame<Body>) -> String {
    /// Largest deviation from I₁ + I₂ = I₃, relative to I₃, of a body shown as very nearly a plate.
    const NEARLY: f64 = 1e-6;
    /// Largest deviation that is rounding of a plate's moments.
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let [i1, i2, i3] = principal.moments();
    let [n1, n2, n3] = principal.moments().map(|i| number(i, DIGITS));
    let spare = ((i1 + i2) - i3) / i3;
    match principal.symmetry() {
        Symmetry::Rod => "physical (a rod)".to_owned(),
        _ if !is_possible(principal) => {
            let sum = number(i1 + i2, DIGITS);
            format!("unphysical ({n1} + {n2} = {sum} < {n3}: violates the triangle inequality)")
        }
        _ if spare.abs() <= ROUNDING => format!("physical ({n1} + {n2} = {n3}: a flat plate)"),
        _ if spare < NEARLY => "physical (very nearly a flat plate)".to_owned(),
        _ => format!("physical ({n1} + {n2} > {n3})"),
    }
}
