//! Computed mass properties in words.

use polhode_document::number::number;

use crate::model::ComputedMass;

/// Returns mass, centre and tensor with six digits.
pub(super) fn in_words(computed: &ComputedMass) -> String {
    let ComputedMass { mass, center: [x, y, z], tensor } = *computed;
    let [xx, yy, zz, xy, xz, yz] = tensor.map(|element| short(element, tensor));
    let (mass, center) = (number(mass, 6), [x, y, z].map(|c| short(c, [x, y, z, 1e-3])).join(", "));
    format!("{mass} kg at ({center}) m, ixx {xx} iyy {yy} izz {zz} ixy {xy} ixz {xz} iyz {yz} kg·m²")
}

/// Formats a number; 0 if it is rounding error compared with the largest.
fn short<const N: usize>(value: f64, all: [f64; N]) -> String {
    let largest = all.iter().fold(0.0_f64, |largest, other| largest.max(other.abs()));
    number(if value.abs() < 1e-14 * largest { 0.0 } else { value }, 6)
}
