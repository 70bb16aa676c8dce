//! Correlated random numbers with given means and covariance.

use crate::infer::covariance::{NotCovariance, factor};
use crate::infer::possible::possible;
use crate::infer::random::{Random, log_normal};

/// Random numbers with given means and covariance, as functions of independent standard normal
/// numbers.
///
/// Let the columns l belong to the Cholesky factor L of the covariance, L Lᵀ = C. The numbers are
/// x = μ + Σ l w, where each w is a standard normal number z. If the first number is a mass m, its
/// w is (m − μ)/σ with a log-normal m, as for the parts of a parts list. Every w has mean 0 and
/// variance 1, and they are independent, so x has exactly the given means and covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlated {
    mean: Vec<f64>,
    columns: Vec<(usize, Vec<f64>)>,
    is_mass_first: bool,
    is_possible: bool,
}

impl Correlated {
    /// Returns normal numbers; the covariance must have one row and one column per mean.
    ///
    /// # Errors
    /// [`NotCovariance`] if the matrix is not a covariance of this many numbers.
    pub fn normal(mean: Vec<f64>, covariance: &[Vec<f64>]) -> Result<Self, NotCovariance> {
        if mean.len() != covariance.len() {
            return Err(NotCovariance { element: [mean.len(), covariance.len()] });
        }
        Ok(Self { mean, columns: factor(covariance)?, is_mass_first: false, is_possible: false })
    }

    /// Returns the same numbers, except that the first is a mass with a log-normal distribution,
    /// which is always positive. Its mean must be positive.
    ///
    /// # Errors
    /// The errors of [`Correlated::normal`].
    pub fn mass_first(mean: Vec<f64>, covariance: &[Vec<f64>]) -> Result<Self, NotCovariance> {
        Ok(Self { is_mass_first: true, ..Self::normal(mean, covariance)? })
    }

    /// Makes every draw physical: the last six numbers, the elements xx, yy, zz, xy, xz, yz of a
    /// tensor about the centre of mass, always form a possible inertia tensor.
    ///
    /// An impossible tensor is replaced by the nearest possible one. The means and the covariance
    /// then differ slightly from the given ones.
    #[must_use]
    pub fn possible(self) -> Self {
        Self { is_possible: true, ..self }
    }

    /// Returns the number of draws, out of `draws`, whose tensor is impossible.
    pub fn impossible(&self, seed: u64, draws: usize) -> usize {
        let is_none = |draw: &usize| {
            let mut random = Random::new(seed, *draw, 0);
            let drawn = self.linear(core::iter::repeat_with(|| random.normal()));
            drawn.last_chunk().is_some_and(|tensor| possible(*tensor).1)
        };
        (0..draws).filter(is_none).count()
    }

    /// Returns the number of independent normal numbers; it is smaller than the number of results
    /// if some combination has no error.
    pub const fn variables(&self) -> usize {
        self.columns.len()
    }

    /// Returns the numbers for the given standard normal numbers; missing ones count as zero.
    pub fn draw(&self, normal: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let mut values = self.linear(normal);
        if let Some(tensor) = values.last_chunk_mut().filter(|_| self.is_possible) {
            *tensor = possible(*tensor).0;
        }
        values
    }

    fn linear(&self, normal: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let mut values = self.mean.clone();
        let mut mass = None;
        for ((number, column), z) in self.columns.iter().zip(normal) {
            let w = match (self.is_mass_first && *number == 0, self.mean.first(), column.first()) {
                (true, Some(mean), Some(sd)) => {
                    let drawn = log_normal(*mean, *sd, z);
                    mass = Some(drawn);
                    (drawn - mean) / sd
                }
                _ => z,
            };
            values.iter_mut().zip(column).for_each(|(value, l)| *value += w * l);
        }
        // The mass itself, without the rounding of the sum, which may be as large as the mass.
        if let (Some(first), Some(mass)) = (values.first_mut(), mass) {
            *first = mass;
        }
        values
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use super::*;
    use crate::infer::random::Random;

    /// Mass, and two numbers; the second is proportional to the mass except for an independent
    /// error.
    fn covariance() -> Vec<Vec<f64>> {
        vec![vec![0.09, 0.012, 0.15], vec![0.012, 0.0025, 0.02], vec![0.15, 0.02, 0.26]]
    }

    #[test]
    fn mean_and_covariance_are_those_that_are_given_also_with_a_mass() {
        const DRAWS: usize = 200_000;
        let mean = vec![1.1, -0.3, 2.0];
        let c = covariance();
        for law in [Correlated::normal(mean.clone(), &c), Correlated::mass_first(mean.clone(), &c)] {
            let law = law.unwrap();
            assert_eq!(law.variables(), 3);
            let mut sums = [[0.0; 4]; 3];
            let mut least = f64::INFINITY;
            for k in 0..DRAWS {
                let mut random = Random::new(5, k, 0);
                let x = law.draw(std::iter::repeat_with(|| random.normal()));
                least = least.min(x[0]);
                for i in 0..3 {
                    sums[i][3] += x[i] - mean[i];
                    (0..3).for_each(|j| sums[i][j] += (x[i] - mean[i]) * (x[j] - mean[j]));
                }
            }
            let n = DRAWS as f64;
            for i in 0..3 {
                assert!((sums[i][3] / n).abs() < 4.0 * (c[i][i] / n).sqrt(), "{i}");
                for j in 0..3 {
                    // Valid for normal numbers; the fourth moments of a log-normal number with 27 %
                    // error are slightly larger.
                    let sd = ((c[i][i] * c[j][j] + c[i][j] * c[i][j]) / n).sqrt();
                    let off = (sums[i][j] / n - c[i][j]).abs() / sd;
                    assert!(off < 6.0, "{i} {j}: {off} standard deviations");
                }
            }
            assert_eq!(least > 0.0, law.is_mass_first);
        }
    }

    #[test]
    fn what_goes_with_a_mass_goes_with_it_exactly() {
        let law = Correlated::mass_first(vec![2.0, 6.0], &[vec![1.0, 3.0], vec![3.0, 9.0]]).unwrap();
        assert_eq!(law.variables(), 1);
        for z in [-30.0, -1.0, 0.0, 2.5] {
            let drawn = law.draw([z]);
            assert!(
                drawn[0] > 0.0 && (drawn[1] - 3.0 * drawn[0]).abs() <= 1e-14 * drawn[1].max(1.0),
                "{drawn:?}"
            );
        }
    }

    /// A lamina perpendicular to z: errors of xz and yz, which tilt it, require a second-order
    /// change of zz.
    #[test]
    fn what_is_no_tensor_becomes_the_nearest() {
        let mean = vec![2.0, 0.1, 0.2, 0.3, 0.03, 0.05, 0.08, 0.004, 0.0, 0.0];
        let mut c = vec![vec![0.0; 10]; 10];
        (c[8][8], c[9][9]) = (4e-10, 9e-10);
        let law = Correlated::mass_first(mean, &c).unwrap();
        assert_eq!((law.variables(), law.impossible(3, 200)), (2, 200));
        let z = [0.7, -1.3];
        let (raw, moved) = (law.draw(z), law.clone().possible().draw(z));
        assert_eq!(raw[..4], moved[..4]);
        for (k, (a, b)) in raw.iter().zip(&moved).enumerate().skip(4) {
            // Changes of the moments are (δxz)²/i.
            assert!((a - b).abs() < 1e-7, "{k}: {a} {b}");
        }
        let [xx, yy, zz, xy, xz, yz] = *moved.last_chunk().unwrap();
        let half = 0.5 * (xx + yy + zz);
        let (values, _) = crate::math::symmetric_eigen([half - xx, half - yy, half - zz, -xy, -xz, -yz]);
        assert!(values[0].abs() < 1e-17 && raw != moved, "{values:?}");
        // A possible tensor is not changed.
        let mean = vec![2.0, 0.1, 0.2, 0.3, 0.05, 0.06, 0.08, 0.004, 0.0, 0.0];
        let law = Correlated::mass_first(mean, &c).unwrap();
        assert_eq!((law.impossible(3, 200), law.draw(z)), (0, law.clone().possible().draw(z)));
    }

    #[test]
    fn a_matrix_that_is_none_is_refused() {
        let wrong = |c: &[Vec<f64>]| Correlated::normal(vec![0.0; 2], c).unwrap_err().element;
        assert_eq!(wrong(&[vec![1.0, 1.1], vec![1.1, 1.0]]), [2, 1]);
        assert_eq!(wrong(&[vec![1.0]]), [2, 1]);
        assert_eq!(wrong(&[vec![1.0, 0.0], vec![0.0]]), [2, 2]);
    }
}
