//! Noise of the wrench, estimated from the residuals.

use super::outliers::median;
use super::small::Vector6;

/// Median of |x| for normal x, in standard deviations.
const MEDIAN: f64 = 0.6745;
/// Outlier threshold of differences, standard deviations.
const FAR: f64 = 5.0;

/// Lower bound on the variance after subtraction of the motion's part, relative to the total.
const LEAST: f64 = 0.02;

/// Estimates the standard deviation of the three channels from `first` on.
///
/// It uses second differences (x₀ − 2 x₁ + x₂)/√6 of rows with positive weight. They have the
/// variance of white x and suppress smooth signals. `propagated` is the variance caused by the
/// measured motion, which is subtracted. `found` is the effective number of parameters fitted to
/// the differences, nearly 0 for a smooth motion.
pub(super) fn from_differences(
    left: &[Vector6],
    weights: &[f64],
    first: usize,
    propagated: f64,
    found: f64,
) -> f64 {
    let counted: Vec<&Vector6> =
        left.iter().zip(weights).filter(|(_, w)| **w > 0.0).map(|(x, _)| x).collect();
    let differences: Vec<f64> = (first..first + 3)
        .flat_map(|i| counted.windows(3).map(move |x| (x[0][i] - 2.0 * x[1][i] + x[2][i]) / 6.0_f64.sqrt()))
        .collect();
    let sizes: Vec<f64> = differences.iter().map(|d| d.abs()).collect();
    let limit = FAR * median(&sizes) / MEDIAN;
    let near = || differences.iter().filter(|d| d.abs() <= limit);
    let variance = near().map(|d| d * d).sum::<f64>() / near().count().max(1) as f64;
    let count = differences.len() as f64;
    let variance = variance * count / (count - found).max(1.0);
    (variance - propagated).max(LEAST * variance).sqrt()
}

/// Returns the degrees of freedom of the variance from second differences of this many rows.
/// Differences share readings, so 1 + 2 (4² + 1²)/6² of them count as one.
pub(super) fn degrees_of_freedom(rows: usize) -> f64 {
    3.0 * (rows.saturating_sub(2) as f64) / (1.0 + 34.0 / 36.0)
}
