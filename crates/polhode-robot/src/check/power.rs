//! A slip of the point: the one power of ten in one element that makes an impossible tensor possible.
//!
//! `izz="1676359E-6"` beside moments of some 2e-3 kg·m² is a point forgotten in 1676.359E-6. All elements and all
//! powers from 10⁻¹² to 10¹² are tried. It is a proof if one alone is left: moments that differ are held between
//! |i1 − i2| and i1 + i2, mostly less than a decade. A product can be too large in a decade's choice of ways, so it
//! alone never proves anything. Where there is geometry, its moments must be near, too.

use super::body::{Body, NAMES};
use super::written::{shifted, short};
use crate::finding::Repair;
use crate::moments::{Elements, Moments, trace};

/// A body is not uniform and its geometry may be crude, but its moments are rarely ten times off: that would be the
/// next power.
const CRUDE: f64 = 10.0;

/// The only repair of this kind, if there is one.
pub(super) fn repair(body: &Body) -> Option<Repair> {
    let mut only = None;
    for (k, number) in body.numbers().filter(|(k, _)| body.written[*k] != 0.0) {
        for power in (-12..=12).filter(|p| *p != 0) {
            let mut elements = body.written;
            let Some(text) = shifted(&number.text, power) else { continue };
            let Ok(value) = text.parse::<f64>() else { continue };
            elements[k] = value;
            let moments = Moments::of(&elements);
            if !moments.are_possible(0.0) || !fits(body, &elements) {
                continue;
            }
            if only.is_some() {
                return None;
            }
            let [a, b, c] = moments.values.map(|x| short(x, 4));
            let description = format!(
                "{} {} → {text}: the only power of ten that makes it possible ({a}, {b}, {c} kg·m²)",
                NAMES[k], number.text
            );
            only = Some(Repair { description, edits: vec![(number.span.clone(), text)] });
        }
    }
    only
}

/// True if no geometry contradicts.
fn fits(body: &Body, elements: &Elements) -> bool {
    let mut solids = body.solids().peekable();
    let any = solids.peek().is_none();
    any || solids.any(|solid| {
        let ratio = trace(elements) / trace(&body.implied(solid));
        (1.0 / CRUDE..=CRUDE).contains(&ratio)
    })
}
