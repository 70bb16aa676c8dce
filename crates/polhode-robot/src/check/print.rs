//! Rounding error of printed numbers.
//!
//! The error is half a unit of the last written digit: `"0.001234"` may be anything from 0.0012335
//! to 0.0012345. But a short number may have been typed: `"1"` is not 1 ± 0.5. The tolerance from a
//! tensor's own digits is therefore limited where it is used ([`super::possible`]).
//!
//! The limit does not apply if numbers were printed with a fixed number of decimals, as with
//! `%.6f`. Then `"0.000001"` is anything from 0.5e-6 to 1.5e-6. This is detected in two ways. In a
//! tensor, all six numbers end at the same decimal, the fourth or later. In a file, no tensor has a
//! digit beyond some decimal, half of the numbers reach it, and a quarter of them have three digits
//! there.

use super::written::{decimals, last_place, significant};
use crate::model::{Number, RobotModel, Slot, Tensor};
use crate::moments::Elements;

/// Number format in which a file's tensors were printed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Print {
    /// Power of ten of the last decimal, if all numbers were cut there.
    place: Option<i32>,
}

impl Print {
    pub(super) fn of(model: &RobotModel) -> Self {
        let mut places = Vec::new();
        let mut tensors = 0;
        for link in &model.links {
            let Some(slots) = link.inertial.as_ref().and_then(|i| i.tensor.slots()) else { continue };
            tensors += 1;
            for number in slots.filter_map(nonzero) {
                places.extend(last_place(&number.text).map(|place| (place, significant(&number.text))));
            }
        }
        let Some(finest) = places.iter().map(|(place, _)| *place).min() else { return Self { place: None } };
        let there: Vec<usize> =
            places.iter().filter(|(place, _)| *place == finest).map(|(_, n)| *n).collect();
        let long = there.iter().filter(|n| **n >= 3).count();
        let cut = tensors >= 3 && 2 * there.len() >= places.len() && 4 * long >= there.len();
        Self { place: cut.then_some(finest) }
    }

    /// Returns half a unit of the last digit of each element, and true if the numbers were cut at a
    /// fixed decimal.
    pub(super) fn rounding(self, tensor: &Tensor, values: &Elements) -> (Elements, bool) {
        let mut halves = [0.0; 6];
        let mut fixed = Some(None);
        for (half, slot) in halves.iter_mut().zip(tensor.slots().into_iter().flatten()) {
            let Slot::Given(number) = slot else { continue };
            let place = last_place(&number.text).map(|p| self.place.map_or(p, |cut| p.max(cut)));
            *half = place.map_or(0.0, |p| 0.5 * 10f64.powi(p));
            let ends_at = decimals(&number.text).filter(|d| *d >= 4);
            fixed = match (fixed, ends_at) {
                (Some(None), Some(d)) => Some(Some(d)),
                (Some(Some(before)), Some(d)) if before == d => fixed,
                _ => None,
            };
        }
        // "0" does not show its unit; it is at most that of the coarsest other number.
        let coarsest =
            halves.iter().zip(values).filter(|(_, x)| **x != 0.0).map(|(h, _)| *h).fold(0.0, f64::max);
        for (half, value) in halves.iter_mut().zip(values) {
            if *value == 0.0 {
                *half = half.min(coarsest);
            }
        }
        (halves, self.place.is_some() || fixed.flatten().is_some())
    }
}

fn nonzero(slot: &Slot) -> Option<&Number> {
    match slot {
        Slot::Given(number) => Some(number).filter(|n| n.value.is_some_and(|x| x.is_finite() && x != 0.0)),
        Slot::Missing { .. } => None,
    }
}
