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

/// The median of √(χ²/3) with three degrees of freedom.
const MEDIAN: f64 = 0.888;

/// By how much what is left is larger than the noise, by the median: 1 at least. What outliers are is measured by it, as a model that is not quite right is no
/// reason to leave everything out.
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
