//! Matrix decompositions of finite matrices.
//!
//! nalgebra's singular value decomposition panics on NaN, and its other decompositions return NaN.
//! Every call goes through this module; clippy refuses nalgebra's own methods elsewhere
//! (`disallowed-methods` in `clippy.toml`).
#![allow(clippy::disallowed_methods, reason = "the one place that calls them")]

use nalgebra::allocator::Allocator;
use nalgebra::linalg::{Cholesky, LU, QR, SymmetricEigen};
use nalgebra::{DMatrix, DVector, DefaultAllocator, DimMin, Dyn, OMatrix};

use crate::error::IdentifyError;

/// Singular value decomposition A = U diag(s) Vᵀ.
pub(crate) struct Svd {
    pub(crate) u: DMatrix<f64>,
    pub(crate) values: DVector<f64>,
    pub(crate) v_t: DMatrix<f64>,
}

/// Returns an error if a number is NaN or infinite.
///
/// # Errors
/// [`IdentifyError::NotFinite`], which names the quantity.
pub(crate) fn require_finite<'a>(
    quantity: &'static str,
    numbers: impl IntoIterator<Item = &'a f64>,
) -> Result<(), IdentifyError> {
    let is_finite = numbers.into_iter().all(|x| x.is_finite());
    if is_finite { Ok(()) } else { Err(IdentifyError::NotFinite { quantity }) }
}

/// Returns the singular value decomposition of a finite matrix.
pub(crate) fn svd(quantity: &'static str, matrix: DMatrix<f64>) -> Result<Svd, IdentifyError> {
    require_finite(quantity, &matrix)?;
    let decomposition = matrix.svd(true, true);
    let (Some(u), Some(v_t)) = (decomposition.u, decomposition.v_t) else {
        return Err(IdentifyError::NotFinite { quantity });
    };
    Ok(Svd { u, values: decomposition.singular_values, v_t })
}

/// Returns the decomposition A = Q R of a finite matrix.
pub(crate) fn qr(quantity: &'static str, matrix: DMatrix<f64>) -> Result<QR<f64, Dyn, Dyn>, IdentifyError> {
    require_finite(quantity, &matrix)?;
    Ok(matrix.qr())
}

/// Returns the decomposition A = Pᵀ L U of a finite matrix.
pub(crate) fn lu<D>(
    quantity: &'static str,
    matrix: OMatrix<f64, D, D>,
) -> Result<LU<f64, D, D>, IdentifyError>
where
    D: DimMin<D, Output = D>,
    DefaultAllocator: Allocator<D, D> + Allocator<D>,
{
    require_finite(quantity, &matrix)?;
    Ok(matrix.lu())
}

/// Returns the eigenvalues and eigenvectors of a finite symmetric matrix.
pub(crate) fn symmetric_eigen(
    quantity: &'static str,
    matrix: DMatrix<f64>,
) -> Result<SymmetricEigen<f64, Dyn>, IdentifyError> {
    require_finite(quantity, &matrix)?;
    Ok(matrix.symmetric_eigen())
}

/// Returns the decomposition A = L Lᵀ; `None` for a matrix that is not positive definite.
pub(crate) fn cholesky(
    quantity: &'static str,
    matrix: DMatrix<f64>,
) -> Result<Option<Cholesky<f64, Dyn>>, IdentifyError> {
    require_finite(quantity, &matrix)?;
    Ok(matrix.cholesky())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_that_are_not_finite_are_refused_by_name() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let matrix = DMatrix::from_row_slice(2, 2, &[2.0, 0.3, 0.3, bad]);
            let error = IdentifyError::NotFinite { quantity: "the test matrix" };
            let name = "the test matrix";
            assert_eq!(svd(name, matrix.clone()).err(), Some(error.clone()));
            assert_eq!(qr(name, matrix.clone()).err(), Some(error.clone()));
            assert_eq!(lu(name, matrix.clone()).err(), Some(error.clone()));
            assert_eq!(symmetric_eigen(name, matrix.clone()).err(), Some(error.clone()));
            assert_eq!(cholesky(name, matrix).err(), Some(error.clone()));
            assert_eq!(error.to_string(), "the test matrix is NaN or infinite");
        }
        let finite = DMatrix::from_row_slice(2, 2, &[2.0, 0.3, 0.3, 1.0]);
        let Svd { u, values, v_t } = svd("the test matrix", finite.clone()).unwrap();
        assert!((u * DMatrix::from_diagonal(&values) * v_t - finite).amax() < 1e-15);
    }
}
