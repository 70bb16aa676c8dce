//! Conversion between Rust and NumPy arrays.
//!
//! Python checks the inputs (`_arrays.py`): arrays have the required shape, and finite, contiguous
//! numbers. Outputs transfer their memory to NumPy without a copy.

use numpy::ndarray::{Array2, Array3};
use numpy::{
    IntoPyArray as _, PyArray1, PyArray2, PyArray3, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2,
};
use polhode::motion::{GlobalError, StateError};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

use crate::error::refused;

/// Checks that memory for `count` elements is available, because a failed allocation ends the
/// process.
///
/// # Errors
/// `MemoryError`, as in NumPy.
pub(crate) fn room<T>(what: &str, count: Option<usize>) -> PyResult<()> {
    match count.map(|count| Vec::<T>::new().try_reserve_exact(count)) {
        Some(Ok(())) => Ok(()),
        _ => Err(PyMemoryError::new_err(format!("not enough memory for {what}: request fewer at once"))),
    }
}

/// Returns a vector or quaternion as a 1-D array.
pub(crate) fn row<'py, const N: usize>(py: Python<'py>, row: [f64; N]) -> Bound<'py, PyArray1<f64>> {
    PyArray1::from_slice(py, &row)
}

/// Returns rows as a 2-D array.
pub(crate) fn matrix<'py, const N: usize>(
    py: Python<'py>,
    rows: &[[f64; N]],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    table(py, rows.as_flattened().to_vec(), N)
}

/// Returns a 3 × 3 matrix, or an error with the message `otherwise` and a hint if an element is not
/// finite.
pub(crate) fn finite_matrix<'py>(
    py: Python<'py>,
    rows: &[[f64; 3]],
    otherwise: &str,
    hint: &str,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    if rows.as_flattened().iter().all(|element| element.is_finite()) {
        matrix(py, rows)
    } else {
        Err(refused(otherwise, Some(hint)))
    }
}

/// Returns numbers as a 2-D array with `columns` columns.
pub(crate) fn table<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    columns: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows = numbers.len() / columns;
    let table =
        Array2::from_shape_vec((rows, columns), numbers).map_err(|error| refused(error.to_string(), None))?;
    Ok(table.into_pyarray(py))
}

/// Returns numbers as a 3-D array of this shape.
pub(crate) fn cube<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    shape: [usize; 3],
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let cube = Array3::from_shape_vec(shape, numbers).map_err(|error| refused(error, None))?;
    Ok(cube.into_pyarray(py))
}

/// Returns the elements of an array without a copy.
pub(crate) fn numbers<'a>(array: &'a PyReadonlyArray1<'_, f64>) -> PyResult<&'a [f64]> {
    array.as_slice().map_err(|error| refused(error.to_string(), None))
}

/// Returns the rows of an array without a copy.
pub(crate) fn rows<'a, const N: usize>(array: &'a PyReadonlyArray2<'_, f64>) -> PyResult<&'a [[f64; N]]> {
    let numbers = array.as_slice().map_err(|error| refused(error.to_string(), None))?;
    match numbers.as_chunks() {
        (rows, []) => Ok(rows),
        _ => Err(refused(format!("expected rows of {N} numbers"), None)),
    }
}

/// Returns the rows of an output array, to be filled in place.
pub(crate) fn rows_mut<'a, const N: usize>(
    array: &'a mut PyReadwriteArray2<'_, f64>,
) -> PyResult<&'a mut [[f64; N]]> {
    let numbers = array.as_slice_mut().map_err(|error| refused(error.to_string(), None))?;
    match numbers.as_chunks_mut() {
        (rows, []) => Ok(rows),
        _ => Err(refused(format!("expected rows of {N} numbers"), None)),
    }
}

/// Chooses between q and −q, which are the same attitude. The first quaternion of a sequence gets w
/// ≥ 0, each other one the sign closest to its predecessor.
///
/// Each quaternion is compared with its predecessor before the sign change. Only one bit therefore
/// depends on the previous step, and the loop runs fast.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Signs {
    before: Option<[f64; 4]>,
    is_turned: bool,
}

impl Signs {
    /// Chooses the signs of the next quaternions.
    pub(crate) fn sign(&mut self, rows: &mut [[f64; 4]]) {
        let mut signs = *self;
        for wxyz in rows {
            *wxyz = signs.signed(*wxyz);
        }
        *self = signs;
    }

    /// Returns the next quaternion or its negative.
    #[inline]
    pub(crate) fn signed(&mut self, wxyz: [f64; 4]) -> [f64; 4] {
        let along: f64 = match self.before {
            // The first nonzero component decides.
            None => wxyz.into_iter().find(|c| *c != 0.0).unwrap_or_default(),
            Some(before) => before.iter().zip(wxyz).map(|(a, b)| a * b).sum(),
        };
        self.is_turned = if self.is_turned { along > 0.0 } else { along < 0.0 };
        self.before = Some(wxyz);
        if self.is_turned { wxyz.map(|c| 0.0 - c) } else { wxyz }
    }
}

/// Angular velocities (n, 3) and attitudes (n, 4).
pub(crate) type States<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>);

/// Error estimates from the computation and from input rounding: attitude error, rad, and relative
/// error of ω.
pub(crate) type ErrorColumns<'py> = [[Bound<'py, PyArray1<f64>>; 2]; 2];

pub(crate) fn error_columns<'py>(py: Python<'py>, estimate: &GlobalError) -> ErrorColumns<'py> {
    [estimate.computation(), estimate.inputs()].map(|errors| {
        let column =
            |value: fn(&StateError) -> f64| PyArray1::from_vec(py, errors.iter().map(value).collect());
        [column(|e| e.attitude), column(|e| e.omega)]
    })
}
