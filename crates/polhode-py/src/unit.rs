//! Units by name.

use polhode_source::unit::{Dimension, factor};
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
    factor(name, dimension).map_err(|error| refused(&error, error.hint().as_deref()))
}
