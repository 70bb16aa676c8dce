//! What is left of a change of the residuals.

use nalgebra::{DMatrix, DVector};

use super::{Information, Rows};
use crate::error::IdentifyError;

/// What becomes of a change of residuals, in standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Response {
    /// ‖(1 − H) d‖: what is left of the change d once all numbers have followed it.
    pub(crate) left: f64,
    /// By how much the shared numbers follow: √(δpᵀ C⁻¹ δp), δp = C Jᵀ d.
    pub(crate) followed: f64,
}

/// What becomes of a change of some groups' residuals.
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
    // ‖d‖² − dᵀ J (JᵀJ)⁻¹ Jᵀ d
    let followed = found.root.tr_mul(&gradient).norm_squared();
    let is_rounding = square - followed < ROUNDING * square;
    let left = if is_rounding { 0.0 } else { (square - followed).sqrt() };
    Ok(Response { left, followed: followed.sqrt() })
}

/// Differences of squares below this of them are none.
const ROUNDING: f64 = 1e-10;

impl Rows {
    /// Derivatives by the shared numbers, and a change of the residuals, once the group's own numbers have followed.
    fn without_own_of(&self, change: &[f64]) -> Result<(DMatrix<f64>, DVector<f64>), IdentifyError> {
        let triangle = self.with_residuals(change).triangle(&[])?;
        let (local, shared) = self.sizes();
        let rows = triangle.nrows().saturating_sub(local);
        let first = triangle.nrows() - rows;
        let rest = triangle.view((first, local), (rows, shared + 1));
        Ok((rest.columns(0, shared).into_owned(), rest.column(shared).into_owned()))
    }
}
