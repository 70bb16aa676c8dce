//! What is known when more has been measured.

use nalgebra::DMatrix;

use super::Information;
use crate::estimate::Estimate;

/// An eigenvalue of correlations below this is rounding.
const NONE: f64 = 1e-14;
/// What rows say of an unknown direction, relative to their terms, is rounding below this.
const ROUNDING: f64 = 1e-7;

impl Information {
    /// What an estimate says.
    pub(crate) fn of_estimate(estimate: &Estimate) -> Self {
        let n = estimate.numbers.len();
        let c = &estimate.covariance;
        let unit = |k: usize| if c[k][k] > 0.0 { c[k][k].sqrt() } else { 1.0 };
        let eigen = DMatrix::from_fn(n, n, |i, j| c[i][j] / (unit(i) * unit(j))).symmetric_eigen();
        let known: Vec<_> = eigen
            .eigenvalues
            .iter()
            .zip(eigen.eigenvectors.column_iter())
            .filter(|(value, _)| **value > NONE)
            .map(|(value, column)| DMatrix::from_fn(n, 1, |i, _| column[i] * value.sqrt() * unit(i)))
            .collect();
        let unknown: Vec<_> =
            estimate.unknown.iter().map(|direction| DMatrix::from_column_slice(n, 1, direction)).collect();
        Self::with(n, &known, &unknown)
    }

    /// With rows of derivatives besides, in standard deviations: x = root z + unknown u, with z of variance 1 before.
    pub(crate) fn with_rows(&self, rows: &DMatrix<f64>) -> Self {
        let (n, known, unknown) = (self.root.nrows(), self.root.ncols(), self.unknown.ncols());
        let mut basis = DMatrix::zeros(n, known + unknown);
        basis.columns_mut(0, known).copy_from(&self.root);
        basis.columns_mut(known, unknown).copy_from(&self.unknown);
        let mut all = DMatrix::zeros(known + rows.nrows(), known + unknown);
        all.view_mut((0, 0), (known, known)).fill_with_identity();
        all.rows_mut(known, rows.nrows()).copy_from(&(rows * &basis));
        for k in known..known + unknown {
            let terms = (rows.abs() * basis.column(k).abs()).norm();
            if all.column(k).norm() <= ROUNDING * terms {
                all.column_mut(k).fill(0.0);
            }
        }
        Self::of(&all).of_other(&basis)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::Number;

    fn estimate(information: &Information) -> Estimate {
        let names = ["a", "b", "c"].map(|name| (name.to_owned(), "1"));
        let found = Estimate::new(names, &[1.0, 2.0, 3.0], information);
        assert!(found.numbers.iter().all(|number: &Number| number.unit == "1"));
        found
    }

    #[test]
    fn rows_that_come_later_say_the_same() {
        let first = DMatrix::from_row_slice(2, 3, &[1.0, 0.3, -0.2, 0.4, 2e3, 0.1]);
        let second = DMatrix::from_row_slice(2, 3, &[0.2, -0.5, 1e-3, 3.0, 0.7, 0.6]);
        let both = DMatrix::from_fn(4, 3, |i, j| if i < 2 { first[(i, j)] } else { second[(i - 2, j)] });
        let before = Information::of(&first);
        assert_eq!(before.unknown.ncols(), 1);
        let (after, at_once) =
            (Information::of_estimate(&estimate(&before)).with_rows(&second), Information::of(&both));
        assert_eq!(after.unknown.ncols(), 0);
        for i in 0..3 {
            for j in 0..3 {
                let size = (at_once.covariance[(i, i)] * at_once.covariance[(j, j)]).sqrt();
                let off = after.covariance[(i, j)] - at_once.covariance[(i, j)];
                assert!(off.abs() < 1e-9 * size, "{} {}", after.covariance, at_once.covariance);
            }
        }
    }

    #[test]
    fn what_they_do_not_say_stays_unknown() {
        let before = Information::of(&DMatrix::from_row_slice(1, 3, &[1.0, 0.3, -0.2]));
        let after = before.with_rows(&DMatrix::from_row_slice(1, 3, &[2.0, 0.6, -0.4]));
        assert_eq!(after.unknown.ncols(), 2);
        let g = [1.0, 0.3, -0.2];
        let [sd, then] = [&before, &after].map(|known| known.deviation(&g).unwrap());
        assert!((sd - 1.0).abs() < 1e-12 && (then - 0.2_f64.sqrt()).abs() < 1e-12, "{sd} {then}");
    }
}
