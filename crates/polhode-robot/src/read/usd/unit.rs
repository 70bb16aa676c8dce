//! The units of a layer, and numbers in SI.

use super::layer::Layer;
use crate::model::{Note, Number};

/// What one unit is in SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    /// m
    pub(super) metres: f64,
    /// kg
    pub(super) kilograms: f64,
}

impl Units {
    /// Those of a layer's metadata. USD's own length is a centimetre where the layer says none, which few mean: a note.
    pub(super) fn of(layer: &Layer, notes: &mut Vec<Note>) -> Self {
        let said = |key: &str| {
            let value = layer.metadata.get(key)?.numbers.first()?.value?;
            Some(value).filter(|value| *value > 0.0 && value.is_finite())
        };
        let metres = said("metersPerUnit");
        if metres.is_none() && !layer.prims.is_empty() {
            let message = "metersPerUnit is not given: by USD's rule a unit is 0.01 m".to_owned();
            notes.push(Note::new("read.unit", "", 0..0, message));
        }
        Self { metres: metres.unwrap_or(0.01), kilograms: said("kilogramsPerUnit").unwrap_or(1.0) }
    }

    /// Whether the numbers of the layer are those in SI.
    pub(super) fn are_si(self) -> bool {
        [self.metres, self.kilograms].iter().all(|unit| unit.to_bits() == 1.0_f64.to_bits())
    }
}

/// A number times a unit, with as many digits as it is written with where the unit is a power of ten.
pub(super) fn in_si(number: &Number, unit: f64) -> Number {
    let Some(value) = number.value.filter(|_| unit.to_bits() != 1.0_f64.to_bits()) else {
        return number.clone();
    };
    let exponent = libm::log10(unit).round();
    let is_power = format!("1e{exponent}").parse().is_ok_and(|power: f64| (power / unit - 1.0).abs() < 1e-12);
    let text = if is_power {
        let (mantissa, own) = number.text.split_once(['e', 'E']).unwrap_or((&number.text, "0"));
        let own: f64 = own.parse().unwrap_or(0.0);
        format!("{mantissa}e{}", own + exponent)
    } else {
        (value * unit).to_string()
    };
    let value = if is_power { text.parse().ok() } else { Some(value * unit) };
    Number { text, value, ..number.clone() }
}
