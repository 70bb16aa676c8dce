//! Units by name, and quantities given as text.

use polhode_source::unit::{Dimension, UnitError, factor, parse, unit_of};
use pyo3::prelude::*;

use crate::error::refused;

/// Returns the value of a named unit: of length in m, or of mass in kg.
///
/// # Errors
/// `PolhodeError` for an unknown unit.
#[pyfunction]
pub(crate) fn unit(name: &str, of_mass: bool) -> PyResult<f64> {
    let dimension = if of_mass { Dimension::MASS } else { Dimension::LENGTH };
    if !name.starts_with(char::is_alphabetic) {
        return Err(refused(format!("{name:?} is not a unit"), Some("write a name, such as \"mm\"")));
    }
    factor(name, dimension).map_err(|error| raised(&error))
}

/// Returns the value in SI units of a text that is a number with a unit, such as `"12 mm"`; `None`
/// for other texts. `powers` are the exponents of kg, m, s and rad.
///
/// # Errors
/// `PolhodeError` for an unknown unit, or one of another dimension.
#[pyfunction]
pub(crate) fn quantity(text: &str, powers: [i8; 4]) -> PyResult<Option<f64>> {
    let [mass, length, time, angle] = powers;
    if unit_of(text).is_empty() {
        return Ok(None);
    }
    let value = parse(text, Dimension::new(mass, length, time, angle));
    value.map(Some).map_err(|error| raised(&error))
}

fn raised(error: &UnitError) -> PyErr {
    refused(error, error.hint().as_deref())
}
