//! The noise of the wrench, from what the model leaves.

use super::outliers::median;
use super::small::Vector6;

/// Median of |x|, in standard deviations of x.
const MEDIAN: f64 = 0.6745;
/// How far a difference is an outlier, in standard deviations.
const FAR: f64 = 5.0;

/// What is left of the variance at least, where the motion seems to bring all of it.
const LEAST: f64 = 0.02;

/// Standard deviation of three channels from first on, from second differences of rows that count: (x₀ − 2 x₁ + x₂)/√6 has that of white x, and nothing of
/// what is smooth. Less the variance that the measured motion brings. `found` is how much of the sum of their squares
/// went with the numbers that were found, in variances: of a smooth motion next to nothing.
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

/// Of the variance that second differences of so many rows show: of the differences, 1 + 2 (4² + 1²)/6² are one, as they share readings.
pub(super) fn degrees_of_freedom(rows: usize) -> f64 {
    3.0 * (rows.saturating_sub(2) as f64) / (1.0 + 34.0 / 36.0)
}
