//! What counts as an outlier, and what it weighs.

use super::rows::Rows;

/// How measurements far off are treated. With s the root mean square of a measurement's residuals, in standard deviations:
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outliers {
    /// All count alike.
    Kept,
    /// Beyond this s the cost rises in proportion to s: Huber's function.
    Damped(f64),
    /// Beyond this s a measurement is left out.
    LeftOut(f64),
}

impl Outliers {
    /// ½ of what the rows cost, and the weight of each measurement.
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
