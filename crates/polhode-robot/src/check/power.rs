//! A suggestion for an impossible tensor without geometry: the one power of ten in one element that would make it possible.
//!
//! `izz="1676359E-6"` next to moments of some 2e-3 kg·m² is a point forgotten in 1676.359E-6. All
//! elements and all powers from 10⁻¹² to 10¹² are tried. One that is possible is not therefore
//! right: of a rod, any of the three moments may be the wrong one. So this is a suggestion, and
//! never a fix.

use super::body::{Body, NAMES};
use super::written::{shifted, short};
use crate::moments::Moments;

/// The only suggestion of this kind, if there is one and no geometry to ask.
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
                "{} {} → {text} would make it possible ({a}, {b}, {c} kg·m²); no geometry confirms it",
                NAMES[k], number.text
            ));
        }
    }
    only
}
