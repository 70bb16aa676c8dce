//! The units of a layer, and numbers in SI.

use polhode_source::{ContentError, ContentErrorKind};

use super::layer::{Layer, Value};
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
    ///
    /// # Errors
    /// [`ContentError`] if one is stated and is not a positive finite number.
    pub(super) fn of(layer: &Layer, notes: &mut Vec<Note>) -> Result<Self, ContentError> {
        let stated = |key: &str| layer.metadata.get(key).map(|value| positive(key, value)).transpose();
        let metres = stated("metersPerUnit")?;
        if metres.is_none() && !layer.prims.is_empty() {
            let message = "metersPerUnit is not given: by USD's rule a unit is 0.01 m".to_owned();
            notes.push(Note::new("read.unit", "", 0..0, message));
        }
        let kilograms = stated("kilogramsPerUnit")?.unwrap_or(1.0);
        Ok(Self { metres: metres.unwrap_or(0.01), kilograms })
    }

    /// Whether the numbers of the layer are those in SI.
    pub(super) fn are_si(self) -> bool {
        [self.metres, self.kilograms].iter().all(|unit| unit.to_bits() == 1.0_f64.to_bits())
    }
}

/// The number that a key of metadata states.
fn positive(key: &str, value: &Value) -> Result<f64, ContentError> {
    if let ([number], []) = (value.numbers.as_slice(), value.words.as_slice())
        && let Some(unit) = number.value.filter(|unit| *unit > 0.0 && unit.is_finite())
    {
        return Ok(unit);
    }
    let kind = ContentErrorKind::value(key, value.text(), "a positive finite number");
    let hint = format!("write {key} = 1 for SI, or leave it out for USD's default");
    Err(kind.at(value.span.clone()).hint(hint))
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
