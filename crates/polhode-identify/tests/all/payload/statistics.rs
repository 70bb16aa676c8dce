//! Errors of many draws, compared with stated errors and with the Cramér–Rao bound.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use polhode_identify::Estimate;
use polhode_identify::payload::PayloadRow;

use crate::draws::{is_about_one, tolerance};

/// Statistics of ten or sixteen parameters.
pub(super) struct Statistics {
    count: f64,
    sum: Vec<f64>,
    squares: Vec<f64>,
    said: Vec<f64>,
    normalised: f64,
}

impl Statistics {
    pub(super) fn new(numbers: usize) -> Self {
        Self {
            count: 0.0,
            sum: vec![0.0; numbers],
            squares: vec![0.0; numbers],
            said: vec![0.0; numbers],
            normalised: 0.0,
        }
    }

    pub(super) fn add(&mut self, estimate: &Estimate, truth: &[f64]) {
        let n = truth.len();
        let error = DVector::from_fn(n, |k, _| estimate.numbers[k].value - truth[k]);
        self.count += 1.0;
        for k in 0..n {
            self.sum[k] += error[k];
            self.squares[k] += error[k] * error[k];
            self.said[k] += estimate.numbers[k].sd.unwrap().powi(2);
        }
        let sd: Vec<f64> = (0..n).map(|k| estimate.numbers[k].sd.unwrap()).collect();
        let covariance = DMatrix::from_fn(n, n, |i, j| estimate.covariance[i][j]);
        self.normalise(&error, &sd, &covariance);
    }

    /// Adds the error of one draw.
    pub(super) fn add_error(&mut self, error: &DVector<f64>, sd: &[f64], covariance: &DMatrix<f64>) {
        self.count += 1.0;
        for k in 0..sd.len() {
            self.sum[k] += error[k];
            self.squares[k] += error[k] * error[k];
            self.said[k] += sd[k] * sd[k];
        }
        self.normalise(error, sd, covariance);
    }

    /// Adds the normalized squared error divided by the rank of the covariance, which is less than
    /// n along a boundary.
    fn normalise(&mut self, error: &DVector<f64>, sd: &[f64], covariance: &DMatrix<f64>) {
        let n = sd.len();
        let scaled = DMatrix::from_fn(n, n, |i, j| covariance[(i, j)] / (sd[i] * sd[j]));
        let eigen = scaled.symmetric_eigen();
        let scaled_error = DVector::from_fn(n, |k, _| error[k] / sd[k]);
        let mut rank = 0.0;
        let mut square = 0.0;
        for (k, &value) in eigen.eigenvalues.iter().enumerate() {
            if value > 1e-9 {
                rank += 1.0;
                square += eigen.eigenvectors.column(k).dot(&scaled_error).powi(2) / value;
            }
        }
        self.normalised += square / rank;
    }

    /// Returns the mean normalized squared error per parameter.
    pub(super) fn normalised(&self) -> f64 {
        self.normalised / self.count
    }

    /// Returns the largest |bias| of a parameter, in standard deviations of the draws.
    pub(super) fn bias(&self) -> f64 {
        (0..self.sum.len()).map(|k| (self.sum[k] / self.count).abs() / self.deviation(k)).fold(0.0, f64::max)
    }

    fn deviation(&self, k: usize) -> f64 {
        let mean = self.sum[k] / self.count;
        (self.squares[k] / self.count - mean * mean).sqrt()
    }

    /// Checks bias below 0.15 deviations, deviations within 10 % of the bound, and normalized
    /// squares within 10 % of one. A quarter of the draws doubles these tolerances, except for
    /// stated deviations.
    pub(super) fn hold(&self, bound: &[f64]) {
        let ([least, most], [least_said, most_said]) = (self.of_draws(bound), self.of_said(bound));
        assert!(self.bias() < tolerance(0.15), "{self}");
        assert!([least, most].iter().all(|ratio| is_about_one(*ratio, 0.1)), "{least} {most}");
        assert!(0.9 < least_said && most_said < 1.1, "{least_said} {most_said}");
        assert!(is_about_one(self.normalised(), 0.1), "{self}");
    }

    /// Returns the smallest and largest ratio of the deviation of the draws to a bound.
    pub(super) fn of_draws(&self, bound: &[f64]) -> [f64; 2] {
        range((0..bound.len()).map(|k| self.deviation(k) / bound[k]))
    }

    /// Returns the root mean square of the stated standard deviations.
    pub(super) fn mean_said(&self) -> Vec<f64> {
        self.said.iter().map(|said| (said / self.count).sqrt()).collect()
    }

    /// Returns the smallest and largest ratio of the stated deviation to a bound.
    pub(super) fn of_said(&self, bound: &[f64]) -> [f64; 2] {
        range((0..bound.len()).map(|k| (self.said[k] / self.count).sqrt() / bound[k]))
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "bias {:.3}, normalised square {:.3} of {} draws",
            self.bias(),
            self.normalised(),
            self.count
        )
    }
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[a, b], x| [a.min(x), b.max(x)])
}

/// Returns the Cramér–Rao bound (Σ Xᵀ X/σ²)⁻¹ on the standard deviations, for parameters about the
/// centre of mass. Derivatives of the wrench are finite differences.
pub(super) fn bound(
    rows: &[PayloadRow],
    force: f64,
    torque: f64,
    has_bias: bool,
    center: &[f64; 10],
) -> Vec<f64> {
    let covariance = covariance_bound(rows, force, torque, has_bias, center);
    (0..covariance.nrows()).map(|k| covariance[(k, k)].sqrt()).collect()
}

pub(super) fn covariance_bound(
    rows: &[PayloadRow],
    force: f64,
    torque: f64,
    has_bias: bool,
    center: &[f64; 10],
) -> DMatrix<f64> {
    let n = if has_bias { 16 } else { 10 };
    let mut information = DMatrix::<f64>::zeros(n, n);
    for row in rows {
        let slope: Vec<[f64; 6]> = (0..n)
            .map(|k| {
                if k >= 10 {
                    return std::array::from_fn(|i| if i + 10 == k { 1.0 } else { 0.0 });
                }
                let step = 1e-4 * center[k].abs().max(0.1);
                let moved = |by: f64| {
                    let mut there = *center;
                    there[k] += by;
                    wrench(row, &there)
                };
                let (a, b) = (moved(step), moved(-step));
                std::array::from_fn(|i| (a[i] - b[i]) / (2.0 * step))
            })
            .collect();
        for i in 0..n {
            for j in 0..n {
                information[(i, j)] += (0..6)
                    .map(|c| {
                        let sd = if c < 3 { force } else { torque };
                        slope[i][c] * slope[j][c] / (sd * sd)
                    })
                    .sum::<f64>();
            }
        }
    }
    information.try_inverse().unwrap()
}

/// Returns the wrench from Newton's and Euler's equations about the centre of mass:
///
/// f = m a_c,  τ = I α + ω × I ω + c × f
fn wrench(row: &PayloadRow, center: &[f64; 10]) -> [f64; 6] {
    use nalgebra::{Matrix3, Vector3};
    let v = Vector3::from;
    let (w, a) = (v(row.omega.to_array()), v(row.alpha.to_array()));
    let s = v((row.acceleration - row.gravity).to_array());
    let c = Vector3::new(center[1], center[2], center[3]);
    let [xx, yy, zz, xy, xz, yz] = [4, 5, 6, 7, 8, 9].map(|k| center[k]);
    let i = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let f = (s + a.cross(&c) + w.cross(&w.cross(&c))) * center[0];
    let t = i * a + w.cross(&(i * w)) + c.cross(&f);
    [f.x, f.y, f.z, t.x, t.y, t.z]
}
