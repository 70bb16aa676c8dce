//! Treatment and weight of outliers.

use super::rows::Rows;

/// Treatment of outliers. Let s be the root mean square of one measurement's residuals, in standard
/// deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outliers {
    /// All measurements have full weight.
    Kept,
    /// Huber's function: beyond this s the cost grows linearly in s.
    Damped(f64),
    /// Measurements beyond this s are left out.
    LeftOut(f64),
}

/// Median of √(χ²/3) with three degrees of freedom.
const MEDIAN: f64 = 0.888;

/// Returns the ratio of the residuals to the noise, by the median; at least 1.
///
/// It is the scale for outliers: a slightly wrong model must not cause most measurements to be left
/// out.
pub(crate) fn spread<'a>(all: impl IntoIterator<Item = &'a Rows>) -> f64 {
    let mut sizes: Vec<f64> = all
        .into_iter()
        .flat_map(Rows::measurements)
        .map(|r| (r.iter().map(|x| x * x).sum::<f64>() / r.len() as f64).sqrt())
        .collect();
    let middle = sizes.len() / 2;
    if sizes.is_empty() {
        return 1.0;
    }
    let (_, median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
    (*median / MEDIAN).max(1.0)
}

impl Outliers {
    /// Returns the cost ½χ² of the rows, and the weight of each measurement.
    pub(crate) fn weigh(self, rows: &Rows) -> (f64, Vec<f64>) {
        let mut cost = 0.0;
        let weights = rows.measurements().map(|residuals| {
            let n = residuals.len() as f64;
            let square: f64 = residuals.iter().map(|r| r * r).sum();
            let s = (square / n).sqrt();
            let (weight, part) = match self {
                Self::Damped(limit) if s > limit => (limit / s, n * limit * (s - 0.5 * limit)),
                Self::LeftOut(limit) if s > limit => (0.0, 0.5 * n * limit * limit),
                _ => (1.0, 0.5 * square),
            };
            cost += part;
            weight
        });
        let weights = weights.collect();
        (cost, weights)
    }
}
