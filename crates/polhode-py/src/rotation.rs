//! Rotations given as matrices.

use numpy::{PyArray2, PyReadonlyArray2};
use polhode::math::Attitude;
use pyo3::prelude::*;

use crate::arrays::{rows, table};
use crate::error::refused;

/// Converts direction-cosine matrices, nine numbers by row, to quaternions w, x, y, z. An error
/// names the first invalid matrix.
#[pyfunction]
pub(crate) fn quaternions_of_matrices<'py>(
    py: Python<'py>,
    name: &str,
    matrices: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let matrices = rows::<9>(&matrices)?;
    let quaternions = py.detach(|| {
        let mut quaternions = Vec::with_capacity(4 * matrices.len());
        for (k, &[xx, xy, xz, yx, yy, yz, zx, zy, zz]) in matrices.iter().enumerate() {
            let turn = Attitude::from_matrix([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]);
            let turn = turn.map_err(|error| {
                let place = if matrices.len() > 1 { format!("{name}[{k}]") } else { name.to_owned() };
                refused(format!("{place}: {error}"), None)
            })?;
            quaternions.extend(turn.quaternion());
        }
        Ok::<_, PyErr>(quaternions)
    })?;
    table(py, quaternions, 4)
}
