//! Least-squares solution and its uncertainty.

use nalgebra::{DMatrix, DVector};

use super::Place;
use super::rows::stacked;
use crate::coordinates::Coordinates;
use crate::decomposition::{Svd, svd};
use crate::error::IdentifyError;

/// Minimum of the sum of squares.
#[derive(Clone, Debug)]
pub(crate) struct Solution {
    /// Shared parameters, in physical units.
    pub(crate) shared: Vec<f64>,
    pub(crate) place: Place,
    /// Upper triangle of each group, by the physical parameters.
    triangles: Vec<DMatrix<f64>>,
}

/// Information on some parameters: covariance and unobservable directions.
#[derive(Clone, Debug)]
pub(crate) struct Information {
    /// Covariance, without the unobservable directions.
    pub(crate) covariance: DMatrix<f64>,
    /// Factor of the covariance, C = L Lᵀ. Columns are independent directions of one standard
    /// deviation.
    pub(crate) root: DMatrix<f64>,
    /// Unobservable directions, as unit columns.
    pub(crate) unknown: DMatrix<f64>,
}

/// Threshold below which a singular value is zero, relative to the largest, with columns scaled to
/// norm 1.
const ZERO: f64 = 1e-9;
/// Threshold below which a component of an unobservable direction is rounding. Without it,
/// determined parameters would seem to change along the direction.
const NO_PART: f64 = 1e-7;
/// Threshold below which a component of an observable direction is rounding.
const ROUNDING: f64 = 1e-13;

impl Solution {
    pub(super) fn new(place: Place, coordinates: &Coordinates, triangles: Vec<DMatrix<f64>>) -> Self {
        Self { shared: coordinates.physical(&place.shared), place, triangles }
    }

    /// Returns the information on the shared parameters, with the local ones unknown.
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

    /// Returns the effective number of parameters estimated from a group's rows: its local ones,
    /// and its share of the shared ones.
    pub(crate) fn found_by(&self, group: usize, information: &Information) -> f64 {
        let (triangle, n) = (&self.triangles[group], self.place.local[group].len());
        if triangle.nrows() <= n {
            return triangle.nrows() as f64;
        }
        let rest = triangle.view((n, n), (triangle.nrows() - n, self.shared.len()));
        n as f64 + (rest * &information.covariance * rest.transpose()).trace()
    }

    /// Returns the covariance of a group's local parameters, including the effect of the shared
    /// ones.
    pub(crate) fn local_covariance(&self, group: usize, information: &Information) -> Option<DMatrix<f64>> {
        let (triangle, n) = (&self.triangles[group], self.place.local[group].len());
        if triangle.nrows() < n {
            return None;
        }
        // Error propagation: R_l δl = e − R_s δs.
        let r = triangle.view((0, 0), (n, n)).into_owned();
        let by_shared = triangle.view((0, n), (n, self.shared.len()));
        let middle = DMatrix::identity(n, n) + by_shared * &information.covariance * by_shared.transpose();
        let half = r.solve_upper_triangular(&middle)?;
        r.solve_upper_triangular(&half.transpose())
    }
}

impl Information {
    /// Computes the information of rows of derivatives, in standard deviations.
    pub(crate) fn of(rows: &DMatrix<f64>) -> Result<Self, IdentifyError> {
        let n = rows.ncols();
        let norms: Vec<f64> = rows.column_iter().map(|column| column.norm()).collect();
        let unit = |k: usize| if norms[k] > 0.0 { norms[k] } else { 1.0 };
        let mut scaled = DMatrix::zeros(rows.nrows().max(n), n);
        for k in 0..n {
            scaled.view_mut((0, k), (rows.nrows(), 1)).copy_from(&(rows.column(k) / unit(k)));
        }
        let Svd { values, v_t: vectors, .. } = svd("the Jacobian of the predictions", scaled)?;
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

    /// Composes the information from independent directions of one standard deviation and from
    /// unobservable directions.
    pub(crate) fn with(n: usize, known: &[DVector<f64>], unknown: &[DVector<f64>]) -> Self {
        let columns = |all: &[DVector<f64>]| DMatrix::from_fn(n, all.len(), |i, k| all[k][i]);
        let (root, mut unknown) = (columns(known), columns(unknown));
        unknown.column_iter_mut().for_each(|mut direction| direction /= direction.norm());
        Self { covariance: &root * root.transpose(), root, unknown }
    }

    /// Transforms the information to other parameters, by their Jacobian with respect to these.
    pub(crate) fn of_other(&self, jacobian: &DMatrix<f64>) -> Self {
        let directions = |of: &DMatrix<f64>| columns(&(jacobian * of));
        Self::with(jacobian.nrows(), &directions(&self.root), &directions(&self.unknown))
    }

    /// Returns the standard deviation of gᵀp; `None` if it changes along an unobservable direction.
    pub(crate) fn deviation(&self, gradient: &[f64]) -> Option<f64> {
        if self.unknown.column_iter().any(|unknown| changes_along(gradient, unknown.as_slice())) {
            return None;
        }
        let g = DVector::from_column_slice(gradient);
        Some((g.transpose() * &self.covariance * g)[(0, 0)].max(0.0).sqrt())
    }
}

/// Returns the columns of a matrix.
pub(crate) fn columns(matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    matrix.column_iter().map(nalgebra::Matrix::into_owned).collect()
}

/// Threshold below which a change along an unobservable direction is rounding, relative to its
/// terms.
pub(crate) const KNOWN: f64 = 1e-6;

/// Returns true if a gradient has a component along a direction.
pub(crate) fn changes_along(gradient: &[f64], direction: &[f64]) -> bool {
    let (sum, size) = gradient
        .iter()
        .zip(direction)
        .fold((0.0, 0.0), |(sum, size), (a, b)| (sum + a * b, size + f64::abs(a * b)));
    f64::abs(sum) > KNOWN * size
}
