//! Units of a layer, and conversion of numbers to SI.

use polhode_source::{ContentError, ContentErrorKind};

use super::layer::Layer;
use super::value::Value;
use crate::model::{Note, Number};

/// Units of a layer in SI.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    /// Length unit, m.
    pub(super) metres: f64,
    /// Mass unit, kg.
    pub(super) kilograms: f64,
}

impl Units {
    /// Returns the units in a layer's metadata. If no length is stated, the USD default of a
    /// centimetre applies. This is rarely intended, so it is reported as a note.
    ///
    /// # Errors
    /// [`ContentError`] if a stated unit is not a positive finite number.
    pub(super) fn of(layer: &Layer, notes: &mut Vec<Note>) -> Result<Self, ContentError> {
        let stated = |key: &str| layer.metadata.get(key).map(|value| positive(key, value)).transpose();
        let metres = stated("metersPerUnit")?;
        if metres.is_none() && !layer.prims.is_empty() {
            let message = "metersPerUnit is missing: the USD default is 0.01 m".to_owned();
            notes.push(Note::new("read.unit", "", 0..0, message));
        }
        let kilograms = stated("kilogramsPerUnit")?.unwrap_or(1.0);
        Ok(Self { metres: metres.unwrap_or(0.01), kilograms })
    }

    /// Returns true if the numbers of the layer are in SI units.
    pub(super) fn are_si(self) -> bool {
        [self.metres, self.kilograms].iter().all(|unit| unit.to_bits() == 1.0_f64.to_bits())
    }
}

/// Returns the positive number of a metadata key.
fn positive(key: &str, value: &Value) -> Result<f64, ContentError> {
    if let ([number], []) = (value.numbers.as_slice(), value.words.as_slice())
        && let Some(unit) = number.value.filter(|unit| *unit > 0.0 && unit.is_finite())
    {
        return Ok(unit);
    }
    let kind = ContentErrorKind::value(key, value.text(), "a positive finite number");
    let hint = format!("write {key} = 1 for SI, or delete it for the USD default");
    Err(kind.at(value.span.clone()).hint(hint))
}

/// Returns a number multiplied by a unit. If the unit is a power of ten, the digits are kept.
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
