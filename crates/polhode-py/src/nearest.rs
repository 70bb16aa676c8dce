//! Possible tensors nearest to an impossible one.

use polhode::body::nearest_possible;
use pyo3::prelude::*;

use crate::error::Raise;

/// Tensor and its distance.
type Near = ([[f64; 3]; 3], f64);

/// Returns the nearest possible tensors in the Frobenius norm and in the affine-invariant metric,
/// with their distances.
#[pyfunction]
pub(crate) fn nearest_tensors(tensor: [[f64; 3]; 3]) -> PyResult<(Near, Option<Near>)> {
    let nearest = nearest_possible(tensor).map_err(Raise::raise)?;
    let near = |nearest: polhode::body::Nearest| (nearest.tensor.matrix(), nearest.distance);
    Ok((near(nearest.frobenius), nearest.affine_invariant.map(near)))
}
