//! Uncertainty of a body in dimensionless units.

use nalgebra::{DMatrix, DVector};

use crate::decomposition::{Svd, svd};
use crate::error::IdentifyError;
use crate::estimate::Estimate;
use crate::least_squares::Information;
use crate::principal::PrincipalEstimate;
use crate::six::{PLACES, between};

/// Uncertainty of a body: summary of the covariance of its dimensionless parameters.
///
/// The parameters i1 … i23 are the tensor's elements along the principal axes, divided by the
/// greatest moment. Off-diagonal elements have the factor √2, so that the norm does not depend on
/// the axes. Where the size of the tensor is unobservable, they describe its shape only. A payload
/// has four more parameters: the mass divided by its estimate, and the centre of mass along the
/// principal axes divided by √(i3/m).
#[derive(Clone, Debug, PartialEq)]
pub struct Knowledge {
    /// Number of unobservable directions of these parameters.
    pub unknown: usize,
    /// Square root of the largest eigenvalue of the covariance, orthogonal to the unobservable
    /// directions.
    pub largest_sd: f64,
    /// Geometric mean of the standard deviations along the principal directions of the covariance.
    pub mean_sd: f64,
    /// Unit vector of the direction with the largest standard deviation: components by name,
    /// largest first.
    pub least_known: Vec<(&'static str, f64)>,
    /// Standard deviations of i1, i2, i3 divided by the greatest moment; `None` where unobservable.
    pub moment_sd: [Option<f64>; 3],
}

/// Linear map from errors of an estimate's parameters to errors of a body's dimensionless
/// parameters.
#[derive(Clone, Debug)]
pub(crate) struct BodyUnits {
    names: Vec<&'static str>,
    rows: DMatrix<f64>,
}

const TENSOR: [&str; 6] = ["i1", "i2", "i3", "i12", "i13", "i23"];
const PAYLOAD: [&str; 4] = ["mass", "center 1", "center 2", "center 3"];
/// Threshold below which an unobservable direction's component is rounding, relative to its terms.
const ROUNDING: f64 = 1e-6;
/// Threshold below which a standard deviation belongs to an exact parameter, relative to the
/// largest.
const EXACT: f64 = 1e-10;

impl BodyUnits {
    /// Returns the map for the six tensor elements from index `first`. Without `has_size` it covers
    /// the shape alone. `None` for a point mass, which has no moments.
    pub(crate) fn of_tensor(estimate: &Estimate, first: usize, has_size: bool) -> Option<Self> {
        let p = PrincipalEstimate::of_tensor(estimate, first);
        let greatest = p.axes.map(|axis| between(axis, axis))[2];
        let size: f64 = (0..6).map(|k| greatest[k] * estimate.numbers[first + k].value).sum();
        if !(size > 0.0) {
            return None;
        }
        let mut rows = DMatrix::zeros(6, estimate.numbers.len());
        for (k, (i, j)) in PLACES.into_iter().enumerate() {
            let weight = if i == j { 1.0 } else { 2.0_f64.sqrt() };
            let of_size = if i == j && !has_size { [p.ratios[0], p.ratios[1], 1.0][i] } else { 0.0 };
            let row = between(p.axes[i], p.axes[j]);
            for e in 0..6 {
                rows[(k, first + e)] = weight * (row[e] - of_size * greatest[e]) / size;
            }
        }
        Some(Self { names: TENSOR.to_vec(), rows })
    }

    /// Returns the map for mass, centre and tensor about the centre.
    pub(crate) fn of_payload(estimate: &Estimate) -> Option<Self> {
        let tensor = Self::of_tensor(estimate, PAYLOAD.len(), true)?;
        let p = PrincipalEstimate::of_tensor(estimate, PAYLOAD.len());
        let mass = estimate.numbers[0].value;
        let radius = (p.moments[2] / mass).sqrt();
        let mut rows = tensor.rows.insert_rows(0, PAYLOAD.len(), 0.0);
        rows[(0, 0)] = 1.0 / mass;
        for (k, axis) in p.axes.iter().enumerate() {
            (0..3).for_each(|i| rows[(1 + k, 1 + i)] = axis[i] / radius);
        }
        Some(Self { names: PAYLOAD.into_iter().chain(TENSOR).collect(), rows })
    }

    /// Returns the map for other parameters, given the Jacobian of the estimate's with respect to
    /// them.
    pub(crate) fn after(&self, jacobian: &DMatrix<f64>) -> Self {
        Self { names: self.names.clone(), rows: &self.rows * jacobian }
    }

    /// Returns the uncertainty of the body's parameters.
    pub(crate) fn knowledge(&self, information: &Information) -> Result<Knowledge, IdentifyError> {
        // A column of zeros: an exact estimate has a root without columns.
        let root = &self.rows * &information.root.clone().insert_column(0, 0.0);
        let hidden = self.hidden(&information.unknown)?;
        let across = &root - &hidden * (hidden.transpose() * &root);
        let Svd { u, values: sds, .. } = svd("the covariance of the body", across)?;
        let largest_sd = sds.max();
        let direction = u.column(sds.imax());
        let known: Vec<f64> =
            sds.iter().filter(|sd| **sd > EXACT * largest_sd).map(|sd| libm::log(*sd)).collect();
        let mut least_known: Vec<_> = self.names.iter().copied().zip(direction.iter().copied()).collect();
        least_known.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        if least_known[0].1 < 0.0 {
            least_known.iter_mut().for_each(|(_, part)| *part = -*part);
        }
        let moments = self.names.len() - TENSOR.len();
        Ok(Knowledge {
            unknown: hidden.ncols(),
            largest_sd,
            mean_sd: if known.is_empty() {
                0.0
            } else {
                libm::exp(known.iter().sum::<f64>() / known.len() as f64)
            },
            least_known,
            moment_sd: [0, 1, 2].map(|k| {
                let is_hidden = hidden.row(moments + k).norm() > ROUNDING;
                (!is_hidden).then(|| root.row(moments + k).norm())
            }),
        })
    }

    /// Returns an orthonormal basis of the images of the unobservable directions in the body's
    /// parameters.
    fn hidden(&self, unknown: &DMatrix<f64>) -> Result<DMatrix<f64>, IdentifyError> {
        let m = self.rows.nrows();
        let seen = unknown.column_iter().filter_map(|direction| {
            let moved: DVector<f64> = &self.rows * direction;
            let terms = (self.rows.abs() * direction.abs()).norm();
            (moved.norm() > ROUNDING * terms).then(|| moved.normalize())
        });
        let seen: Vec<DVector<f64>> = seen.collect();
        if seen.is_empty() {
            return Ok(DMatrix::zeros(m, 0));
        }
        let Svd { u, values, .. } =
            svd("an unobservable direction of the body", DMatrix::from_columns(&seen))?;
        let kept: Vec<_> = values
            .iter()
            .zip(u.column_iter())
            .filter(|(value, _)| **value > ROUNDING)
            .map(|(_, column)| column.into_owned())
            .collect();
        Ok(DMatrix::from_columns(&kept))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::Number;

    fn estimate(covariance: [f64; 6], unknown: Vec<Vec<f64>>) -> Estimate {
        let values = [2.0, 3.0, 4.0, 0.0, 0.0, 0.0];
        let numbers = values
            .iter()
            .zip(covariance)
            .map(|(&value, variance)| Number::new(String::new(), "kg·m²", value, Some(variance.sqrt())));
        let covariance = (0..6).map(|i| (0..6).map(|j| if i == j { covariance[i] } else { 0.0 }).collect());
        Estimate { numbers: numbers.collect(), covariance: covariance.collect(), unknown }
    }

    #[test]
    fn what_is_least_known_is_the_longest_axis() {
        let estimate = estimate([0.01, 0.04, 0.0025, 0.0001, 0.0025, 0.09], Vec::new());
        let units = BodyUnits::of_tensor(&estimate, 0, true).unwrap();
        let known = estimate.information().and_then(|all| units.knowledge(&all)).unwrap();
        assert_eq!(known.unknown, 0);
        // Element 23: √2 · 0.3/4.
        assert!((known.largest_sd - 2.0_f64.sqrt() * 0.3 / 4.0).abs() < 1e-12, "{known:?}");
        assert_eq!(known.least_known[0].0, "i23");
        for (got, want) in known.moment_sd.into_iter().zip([0.1, 0.2, 0.05]) {
            assert!((got.unwrap() - want / 4.0).abs() < 1e-12, "{known:?}");
        }
    }

    #[test]
    fn what_is_exact_has_no_error() {
        let estimate = estimate([0.0; 6], vec![vec![1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]);
        let units = BodyUnits::of_tensor(&estimate, 0, true).unwrap();
        let exact = estimate.information().unwrap();
        let known = units.knowledge(&exact).unwrap();
        assert_eq!((known.unknown, known.largest_sd, known.mean_sd), (1, 0.0, 0.0));
        let row = DMatrix::from_row_slice(1, 6, &[2.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        let then = exact.with_rows(&row).and_then(|all| units.knowledge(&all)).unwrap();
        assert!(then.unknown == 0 && (then.largest_sd - 0.5 / 4.0).abs() < 1e-15, "{then:?}");
    }

    #[test]
    fn of_a_shape_the_size_is_no_direction() {
        // Unobservable: the size, along (2, 3, 4), and i1 + i2.
        let (size, other) = (vec![2.0, 3.0, 4.0, 0.0, 0.0, 0.0], vec![1.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        let estimate = estimate([0.01, 0.01, 0.0, 0.0001, 0.0025, 0.0025], vec![size, other]);
        let shape = BodyUnits::of_tensor(&estimate, 0, false).unwrap();
        let all = estimate.information().unwrap();
        let known = shape.knowledge(&all).unwrap();
        assert_eq!(known.unknown, 1);
        assert_eq!(known.moment_sd, [None, None, Some(0.0)]);
        let tensor = BodyUnits::of_tensor(&estimate, 0, true).unwrap();
        assert_eq!(tensor.knowledge(&all).unwrap().unknown, 2);
    }
}
