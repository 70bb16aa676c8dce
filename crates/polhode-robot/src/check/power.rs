//! Suggests, for an impossible tensor without geometry, the only power of ten in one element that
//! makes it possible.
//!
//! `izz="1676359E-6"` next to moments of about 2e-3 kg·m² has a missing decimal point: 1676.359E-6
//! is right. All elements and all powers from 10⁻¹² to 10¹² are tried. A possible result is not
//! necessarily right: for a rod, any of the three moments may be the wrong one. It is therefore a
//! suggestion and never a fix.

use super::body::{Body, NAMES};
use super::written::{shifted, short};
use crate::moments::Moments;

/// Returns the suggestion for a link without geometry, if it is the only one of this kind.
pub(super) fn suggestion(body: &Body) -> Option<String> {
    if body.solids().next().is_some() {
        return None;
    }
    let mut only = None;
    for (k, number) in body.numbers().filter(|(k, _)| body.written[*k] != 0.0) {
        for power in (-12..=12).filter(|p| *p != 0) {
            let mut elements = body.written;
            let Some(text) = shifted(&number.text, power) else { continue };
            let Ok(value) = text.parse::<f64>() else { continue };
            elements[k] = value;
            let moments = Moments::of(&elements);
            if !moments.are_possible(0.0) {
                continue;
            }
            if only.is_some() {
                return None;
            }
            let [a, b, c] = moments.values.map(|x| short(x, 4));
            only = Some(format!(
                "{} {} → {text} would make the tensor possible ({a}, {b}, {c} kg·m²), but no geometry confirms it",
                NAMES[k], number.text
            ));
        }
    }
    only
}
