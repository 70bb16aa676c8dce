//! Covariance matrices of a few numbers.

use core::fmt;

/// Error: a matrix is not a covariance. It is not symmetric, or some combination of the numbers
/// would have a negative variance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotCovariance {
    /// Row and column, from 1, of the invalid element.
    pub element: [usize; 2],
}

impl fmt::Display for NotCovariance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [i, j] = self.element;
        write!(f, "the matrix is not a covariance matrix: see element {i}, {j}")
    }
}

impl std::error::Error for NotCovariance {}

/// Threshold below which a remaining variance counts as zero, relative to the variance: rounding,
/// also of ten printed digits.
const ROUNDING: f64 = 1e-9;

/// Returns the nonzero columns of L in L Lᵀ = C, each with its index. A combination of the numbers
/// may have no error.
pub fn columns<const N: usize>(c: &[[f64; N]; N]) -> Result<Vec<(usize, [f64; N])>, NotCovariance> {
    let array = |(k, column): (usize, Vec<f64>)| (k, core::array::from_fn(|i| column[i]));
    Ok(factor(c)?.into_iter().map(array).collect())
}

/// Returns the same columns for a square matrix of any size.
pub fn factor(c: &[impl AsRef<[f64]>]) -> Result<Vec<(usize, Vec<f64>)>, NotCovariance> {
    let n = c.len();
    let c: Vec<&[f64]> = c.iter().map(AsRef::as_ref).collect();
    let wrong = |i: usize, j: usize| NotCovariance { element: [i + 1, j + 1] };
    if let Some(i) = c.iter().position(|row| row.len() != n) {
        return Err(wrong(i, n.min(c[i].len())));
    }
    for i in 0..n {
        if !(c[i][i] >= 0.0 && c[i][i].is_finite()) {
            return Err(wrong(i, i));
        }
        for j in 0..i {
            let size = (c[i][i] * c[j][j]).sqrt();
            if !((c[i][j] - c[j][i]).abs() <= ROUNDING * size && c[i][j].abs() <= size * (1.0 + ROUNDING)) {
                return Err(wrong(i, j));
            }
        }
    }
    let mut all: Vec<(usize, Vec<f64>)> = Vec::new();
    for j in 0..n {
        let left = |i: usize| c[i][j] - all.iter().map(|(_, l)| l[i] * l[j]).sum::<f64>();
        let variance = left(j);
        if variance < -ROUNDING * c[j][j] {
            return Err(wrong(j, j));
        }
        if variance <= ROUNDING * c[j][j] {
            // A number without remaining variance has no remaining covariance: |left| ≤ √(left_ii
            // left_jj).
            if let Some(i) = (j + 1..n).find(|&i| left(i).abs() > 2.0 * (ROUNDING * c[i][i] * c[j][j]).sqrt())
            {
                return Err(wrong(i, j));
            }
            continue;
        }
        let root = variance.sqrt();
        let column = (0..n).map(|i| if i < j { 0.0 } else { left(i) / root }).collect();
        all.push((j, column));
    }
    Ok(all)
}

/// Returns gᵀ C h.
pub fn form<const N: usize>(g: &[f64; N], c: &[[f64; N]; N], h: &[f64; N]) -> f64 {
    g.iter().zip(c).map(|(g, row)| g * dot(row, h)).sum()
}

/// Returns the scalar product of two vectors of N elements.
pub fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds v vᵀ to the lower triangle of C.
pub fn add_square<const N: usize>(c: &mut [[f64; N]; N], v: &[f64; N]) {
    for (i, row) in c.iter_mut().enumerate() {
        for (element, other) in row[..=i].iter_mut().zip(v) {
            *element += v[i] * other;
        }
    }
}

/// Returns the full symmetric matrix from its lower triangle.
pub fn mirrored<const N: usize>(c: &[[f64; N]; N]) -> [[f64; N]; N] {
    core::array::from_fn(|i| core::array::from_fn(|j| if j <= i { c[i][j] } else { c[j][i] }))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use super::*;

    #[test]
    fn the_columns_make_the_matrix_again() {
        // Rank 2 of 3: the third number is 2 a − b.
        let (a, b) = ([0.3, -0.7, 0.0], [1.1, 0.2, 0.0]);
        let rows = [a, b, core::array::from_fn(|k| 2.0 * a[k] - b[k])];
        let c: [[f64; 3]; 3] = core::array::from_fn(|i| core::array::from_fn(|j| dot(&rows[i], &rows[j])));
        let factors = columns(&c).unwrap();
        assert_eq!(factors.len(), 2);
        for i in 0..3 {
            for j in 0..3 {
                let again: f64 = factors.iter().map(|(_, l)| l[i] * l[j]).sum();
                assert!((again - c[i][j]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn what_is_no_covariance_is_found() {
        let at = |c: [[f64; 3]; 3]| columns(&c).unwrap_err().element;
        assert_eq!(at([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]), [2, 2]);
        assert_eq!(at([[1.0, 0.2, 0.0], [0.3, 1.0, 0.0], [0.0, 0.0, 1.0]]), [2, 1]);
        assert_eq!(at([[1.0, 0.0, 3.0], [0.0, 1.0, 0.0], [3.0, 0.0, 4.0]]), [3, 1]);
        // Each pair is possible, but not all three.
        assert_eq!(at([[1.0, 0.9, -0.9], [0.9, 1.0, 0.9], [-0.9, 0.9, 1.0]]), [3, 3]);
        // The second number equals the first, but the third is correlated with only one of them.
        assert_eq!(at([[1.0, 1.0, 0.0], [1.0, 1.0, 0.5], [0.0, 0.5, 1.0]]), [3, 2]);
    }
}
