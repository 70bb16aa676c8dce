//! The place of least squares, and how well it is known.

use nalgebra::{DMatrix, DVector};

use super::Place;
use super::rows::stacked;
use crate::coordinates::Coordinates;
use crate::decomposition::{Svd, svd};
use crate::error::IdentifyError;

/// Where the sum of squares is least.
#[derive(Clone, Debug)]
pub(crate) struct Solution {
    /// The shared numbers.
    pub(crate) shared: Vec<f64>,
    pub(crate) place: Place,
    /// Of each group, in the physical numbers.
    triangles: Vec<DMatrix<f64>>,
}

/// What of some numbers is known: an information matrix, by its singular values.
#[derive(Clone, Debug)]
pub(crate) struct Information {
    /// Covariance of what is known.
    pub(crate) covariance: DMatrix<f64>,
    /// A root of it: columns are independent directions, each of one standard deviation.
    pub(crate) root: DMatrix<f64>,
    /// Directions in which nothing is known: columns.
    pub(crate) unknown: DMatrix<f64>,
}

/// A singular value below this, relative to the largest, is zero: columns have norm 1 then.
const ZERO: f64 = 1e-9;
/// A component of an unknown direction below this is rounding: a number that is known would seem to change along what is not.
const NO_PART: f64 = 1e-7;
/// The same of a known direction.
const ROUNDING: f64 = 1e-13;

impl Solution {
    pub(super) fn new(place: Place, coordinates: &Coordinates, triangles: Vec<DMatrix<f64>>) -> Self {
        Self { shared: coordinates.physical(&place.shared), place, triangles }
    }

    /// Of the shared numbers, with each group's own unknown.
    pub(crate) fn information(&self) -> Result<Information, IdentifyError> {
        let shared = self.shared.len();
        let mut all = DMatrix::zeros(0, shared);
        for (triangle, own) in self.triangles.iter().zip(&self.place.local) {
            let n = own.len();
            if triangle.nrows() > n {
                let rest = triangle.view((n, n), (triangle.nrows() - n, shared)).into_owned();
                all = stacked(&all, &rest)?;
            }
        }
        Information::of(&all)
    }

    /// How many numbers were found from a group's rows: its own, and its share of the shared ones.
    pub(crate) fn found_by(&self, group: usize, information: &Information) -> f64 {
        let (triangle, n) = (&self.triangles[group], self.place.local[group].len());
        if triangle.nrows() <= n {
            return triangle.nrows() as f64;
        }
        let rest = triangle.view((n, n), (triangle.nrows() - n, self.shared.len()));
        n as f64 + (rest * &information.covariance * rest.transpose()).trace()
    }

    /// Covariance of a group's own numbers, with that of the shared ones.
    pub(crate) fn local_covariance(&self, group: usize, information: &Information) -> Option<DMatrix<f64>> {
        let (triangle, n) = (&self.triangles[group], self.place.local[group].len());
        if triangle.nrows() < n {
            return None;
        }
        // R_l δl = e − R_s δs
        let r = triangle.view((0, 0), (n, n)).into_owned();
        let by_shared = triangle.view((0, n), (n, self.shared.len()));
        let middle = DMatrix::identity(n, n) + by_shared * &information.covariance * by_shared.transpose();
        let half = r.solve_upper_triangular(&middle)?;
        r.solve_upper_triangular(&half.transpose())
    }
}

impl Information {
    /// Of rows of derivatives, in standard deviations.
    pub(crate) fn of(rows: &DMatrix<f64>) -> Result<Self, IdentifyError> {
        let n = rows.ncols();
        let norms: Vec<f64> = rows.column_iter().map(|column| column.norm()).collect();
        let unit = |k: usize| if norms[k] > 0.0 { norms[k] } else { 1.0 };
        let mut scaled = DMatrix::zeros(rows.nrows().max(n), n);
        for k in 0..n {
            scaled.view_mut((0, k), (rows.nrows(), 1)).copy_from(&(rows.column(k) / unit(k)));
        }
        let Svd { values, v_t: vectors, .. } = svd("a derivative of the predictions", scaled)?;
        let largest = values.max();
        let (mut known, mut unknown) = (Vec::new(), Vec::new());
        for (k, &value) in values.iter().enumerate() {
            let part =
                |i: usize, least: f64| if vectors[(k, i)].abs() > least { vectors[(k, i)] } else { 0.0 };
            if value > ZERO * largest {
                known.push(DVector::from_fn(n, |i, _| part(i, ROUNDING) / unit(i) / value));
            } else {
                unknown.push(DVector::from_fn(n, |i, _| part(i, NO_PART) / unit(i)));
            }
        }
        Ok(Self::with(n, &known, &unknown))
    }

    /// Of independent directions, each of one standard deviation, and of those in which nothing is known.
    pub(crate) fn with(n: usize, known: &[DVector<f64>], unknown: &[DVector<f64>]) -> Self {
        let columns = |all: &[DVector<f64>]| DMatrix::from_fn(n, all.len(), |i, k| all[k][i]);
        let (root, mut unknown) = (columns(known), columns(unknown));
        unknown.column_iter_mut().for_each(|mut direction| direction /= direction.norm());
        Self { covariance: &root * root.transpose(), root, unknown }
    }

    /// Of other numbers, with their derivative by these.
    pub(crate) fn of_other(&self, jacobian: &DMatrix<f64>) -> Self {
        let directions = |of: &DMatrix<f64>| columns(&(jacobian * of));
        Self::with(jacobian.nrows(), &directions(&self.root), &directions(&self.unknown))
    }

    /// Standard deviation of gᵀp: `None` if it changes along what is not known.
    pub(crate) fn deviation(&self, gradient: &[f64]) -> Option<f64> {
        if self.unknown.column_iter().any(|unknown| changes_along(gradient, unknown.as_slice())) {
            return None;
        }
        let g = DVector::from_column_slice(gradient);
        Some((g.transpose() * &self.covariance * g)[(0, 0)].max(0.0).sqrt())
    }
}

/// The columns of a matrix.
pub(crate) fn columns(matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    matrix.column_iter().map(nalgebra::Matrix::into_owned).collect()
}

/// Threshold below which a change along an unknown direction is rounding, relative to its terms.
pub(crate) const KNOWN: f64 = 1e-6;

/// Returns true if a gradient has a component along a direction.
pub(crate) fn changes_along(gradient: &[f64], direction: &[f64]) -> bool {
    let (sum, size) = gradient
        .iter()
        .zip(direction)
        .fold((0.0, 0.0), |(sum, size), (a, b)| (sum + a * b, size + f64::abs(a * b)));
    f64::abs(sum) > KNOWN * size
}
