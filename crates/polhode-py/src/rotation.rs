//! Rotations given as matrices, or as in files.

use std::path::Path;

use numpy::{PyArray2, PyReadonlyArray2};
use polhode::math::Attitude;
use polhode_source::FormatError;
use polhode_source::files::Memory;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::toml::{document, rotation};
use pyo3::prelude::*;

use crate::arrays::{rows, table};
use crate::error::{Raise, refused};

/// Returns the quaternion w, x, y, z of a rotation in a form of files. The text is one line,
/// `rotation = { axis = [0, 0, 1], angle = "90 deg" }`; errors have `name` as their path.
///
/// # Errors
/// `PolhodeError` if the text is not a rotation.
#[pyfunction]
pub(crate) fn quaternion_of_text(name: &str, text: &str) -> PyResult<[f64; 4]> {
    let files = Memory::default();
    let source = Source::new(&files, Path::new(name), text);
    let read = || -> Result<Attitude, FormatError> {
        let entries = document(source)?;
        rotation(&Table::root(source, &entries).require("rotation", "rotation = { … }")?)
    };
    read().map(Attitude::quaternion).map_err(Raise::raise)
}

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
