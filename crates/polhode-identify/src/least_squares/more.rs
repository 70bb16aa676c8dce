//! Update of the information by further measurements.

use nalgebra::DMatrix;

use super::{Information, columns};
use crate::decomposition::{Svd, qr, svd};
use crate::error::IdentifyError;

/// Threshold below which a component of an unobservable direction is rounding, relative to the
/// largest. Without it, other rows would seem to determine it.
const NO_PART: f64 = 1e-12;
/// Threshold below which the effect of an unobservable direction on rows is rounding, relative to
/// its terms.
const ROUNDING: f64 = 1e-7;

impl Information {
    /// Returns the information after rows R of further derivatives, in standard deviations.
    ///
    /// Before, x = L z + U y, with z of unit variance and y unobservable. Let R U = P S Qᵀ. Then
    /// the rows Pᵀ R determine y along Q and contain no information on z. The other rows reduce the
    /// variance of z to W Wᵀ with W⁻ᵀ W⁻¹ = 1 + Aᵀ (1 − P Pᵀ) A, A = R L. So
    ///
    /// x = (L − U Q S⁻¹ Pᵀ A) W z + U Q S⁻¹ e,
    ///
    /// plus the directions that remain unobservable.
    pub(crate) fn with_rows(&self, rows: &DMatrix<f64>) -> Result<Self, IdentifyError> {
        const DERIVATIVES: &str = "the Jacobian of another experiment";
        let (n, known) = (self.root.nrows(), self.root.ncols());
        let a = rows * &self.root;
        let (mut seen, mut unseen) = (Vec::new(), Vec::new());
        for direction in self.unknown.column_iter() {
            let terms = (rows.abs() * direction.abs()).norm();
            if (rows * direction).norm() > ROUNDING * terms {
                seen.push(direction / terms);
            } else {
                unseen.push(direction.into_owned());
            }
        }
        let (mut root, mut rest, mut found) = (self.root.clone(), a.clone(), Vec::new());
        if !seen.is_empty() {
            let u = DMatrix::from_columns(&seen);
            // At least as many rows as columns, so that the decomposition returns all right
            // vectors.
            let mut of_unknown = DMatrix::zeros(rows.nrows().max(u.ncols()), u.ncols());
            of_unknown.rows_mut(0, rows.nrows()).copy_from(&(rows * &u));
            let Svd { u: p, values, v_t } = svd(DERIVATIVES, of_unknown)?;
            let largest = values.max();
            for (k, &value) in values.iter().enumerate() {
                let direction = &u * v_t.row(k).transpose();
                if value <= ROUNDING * largest {
                    let most = direction.amax();
                    let part = |x: f64| if x.abs() > NO_PART * most { x } else { 0.0 };
                    unseen.push(direction.map(part));
                    continue;
                }
                let p = p.view((0, k), (rows.nrows(), 1));
                let said = p.tr_mul(&a);
                root -= &direction * (&said / value);
                rest -= p * said;
                found.push(direction / value);
            }
        }
        if known > 0 {
            let mut all = DMatrix::identity(known + rest.nrows(), known);
            all.rows_mut(known, rest.nrows()).copy_from(&rest);
            // L W = (W⁻ᵀ Lᵀ)ᵀ; the diagonal of the triangle is at least 1.
            let turned = qr(DERIVATIVES, all)?.r().tr_solve_upper_triangular(&root.transpose());
            root = turned.map_or(root, |turned| turned.transpose());
        }
        Ok(Self::with(n, &[columns(&root), found].concat(), &unseen))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::{Estimate, Number};

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
        let before = Information::of(&first).unwrap();
        assert_eq!(before.unknown.ncols(), 1);
        let (after, at_once) = (estimate(&before).information(), Information::of(&both).unwrap());
        let after = after.and_then(|before| before.with_rows(&second)).unwrap();
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
    fn rows_may_come_one_by_one() {
        // Each row determines a combination of several unobservable directions; the last row is
        // repeated.
        let rows = DMatrix::from_row_slice(
            5,
            4,
            &[
                1.0, 0.3, -0.2, 0.7, 0.4, 2e3, 0.1, -1.1, 0.2, -0.5, 1e-3, 0.9, 3.0, 0.7, 0.6, 0.3, 3.0, 0.7,
                0.6, 0.3,
            ],
        );
        let mut known = Information::of(&rows.rows(0, 1).into_owned()).unwrap();
        for k in 1..5 {
            known = known.with_rows(&rows.rows(k, 1).into_owned()).unwrap();
            assert_eq!(known.unknown.ncols(), 3_usize.saturating_sub(k));
        }
        let at_once = Information::of(&rows).unwrap();
        for i in 0..4 {
            for j in 0..4 {
                let size = (at_once.covariance[(i, i)] * at_once.covariance[(j, j)]).sqrt();
                let off = known.covariance[(i, j)] - at_once.covariance[(i, j)];
                assert!(off.abs() < 1e-9 * size, "{} {}", known.covariance, at_once.covariance);
            }
        }
    }

    #[test]
    fn what_they_do_not_say_stays_unknown() {
        let before = Information::of(&DMatrix::from_row_slice(1, 3, &[1.0, 0.3, -0.2])).unwrap();
        let after = before.with_rows(&DMatrix::from_row_slice(1, 3, &[2.0, 0.6, -0.4])).unwrap();
        assert_eq!(after.unknown.ncols(), 2);
        let g = [1.0, 0.3, -0.2];
        let [sd, then] = [&before, &after].map(|known| known.deviation(&g).unwrap());
        assert!((sd - 1.0).abs() < 1e-12 && (then - 0.2_f64.sqrt()).abs() < 1e-12, "{sd} {then}");
    }
}
