//! Tensor in exact fractions, for files without symbols.

use polhode_algebra::{Fence, RationalFunction, RemainingRoots};
use polhode_document::Section;

use super::principal::principal;
use super::{tensor_letter, write};
use crate::symbolic::Symbolic;

/// Largest denominator that is easier to read than a decimal.
const LARGEST: f64 = 1000.0;

/// Writes the tensor and its principal moments as fractions, if all are short and one of them is no
/// decimal.
pub(crate) fn fractions(of: &Symbolic, moments: [f64; 3], s: &mut Section) {
    let tensor = &of.tensor;
    let roots = tensor.eigenvalues();
    let values = tensor.0.iter().flatten().chain(roots.rational.iter().map(|(root, _)| root));
    let denominators: Option<Vec<f64>> = values.map(denominator).collect();
    let Some(denominators) = denominators else { return };
    let is_short = denominators.iter().all(|d| *d <= LARGEST);
    // A fraction is a decimal if its denominator divides a power of ten.
    let is_decimal = |d: &f64| (d * (1e9 / d).trunc() - 1e9).abs() == 0.0;
    if !is_short || denominators.iter().all(is_decimal) || roots.rest != RemainingRoots::None {
        return;
    }
    s.say("Exactly, in kg·m², since all lengths and masses are short decimals:");
    write(s, &tensor_letter().equals(tensor.to_formula(Fence::Braces, &of.symbols)));
    principal(of, tensor, moments, s);
}

/// Returns the denominator of a number.
fn denominator(value: &RationalFunction) -> Option<f64> {
    let number = value.as_constant()?;
    polhode_algebra::Rational::new(number.denominator().clone(), 1).map(|d| d.to_f64())
}
