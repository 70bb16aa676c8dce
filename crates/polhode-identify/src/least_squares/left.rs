//! Effect of a change of the measurements on the fit.

use nalgebra::{DMatrix, DVector};

use super::{Information, Rows};
use crate::error::IdentifyError;

/// Effect of a change d of the measurements on the fit, in standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Response {
    /// Remainder ‖(1 − H) d‖ after all parameters have been refitted.
    pub(crate) left: f64,
    /// Shift of the shared parameters, √(δpᵀ C⁻¹ δp) with δp = C Jᵀ d.
    pub(crate) followed: f64,
}

/// Computes the effect of changes of some groups' residuals.
pub(crate) fn response(
    groups: &[Rows],
    found: &Information,
    changes: &[(usize, Vec<f64>)],
) -> Result<Response, IdentifyError> {
    let mut square = 0.0;
    let mut gradient = DVector::zeros(found.covariance.nrows());
    for (group, change) in changes {
        let (by_shared, rest) = groups[*group].without_own_of(change)?;
        square += rest.norm_squared();
        gradient += by_shared.tr_mul(&rest);
    }
    // The remainder is ‖d‖² − dᵀ J (JᵀJ)⁻¹ Jᵀ d.
    let followed = found.root.tr_mul(&gradient).norm_squared();
    let is_rounding = square - followed < ROUNDING * square;
    let left = if is_rounding { 0.0 } else { (square - followed).sqrt() };
    Ok(Response { left, followed: followed.sqrt() })
}

/// Threshold below which a difference of squares is rounding, relative to them.
const ROUNDING: f64 = 1e-10;

impl Rows {
    /// Returns the derivatives by the shared parameters, and the change of the residuals, with the
    /// group's own parameters eliminated.
    fn without_own_of(&self, change: &[f64]) -> Result<(DMatrix<f64>, DVector<f64>), IdentifyError> {
        let triangle = self.with_residuals(change).triangle(&[])?;
        let (local, shared) = self.sizes();
        let rows = triangle.nrows().saturating_sub(local);
        let first = triangle.nrows() - rows;
        let rest = triangle.view((first, local), (rows, shared + 1));
        Ok((rest.columns(0, shared).into_owned(), rest.column(shared).into_owned()))
    }
}
