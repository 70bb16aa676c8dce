//! Outliers among wrenches: down-weighted until the parameters converge, then left out.

use super::small::{Vector6, dot};

/// Wrench that was left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// Index of the row, from 0.
    pub row: usize,
    /// Root mean square of its six residuals, in standard deviations.
    pub size: f64,
}

/// Weighting of rows over the passes.
pub(super) struct Outliers {
    phase: Phase,
    /// True if the last pass changed the set of used rows.
    pub(super) changed: bool,
    /// Number of outliers, if it was too large and none was left out.
    pub(super) too_many: Option<usize>,
}

enum Phase {
    Kept,
    Damped(usize),
    Cut(usize),
    Settled,
}

/// Outlier threshold on the root mean square of six residuals; by chance exceeded by one row in
/// three million.
const LIMIT: f64 = 2.7;
/// Threshold of full weight while outliers are down-weighted.
const DAMPED: f64 = 1.5;
/// Median of √(χ²/6) with 6 degrees of freedom.
const MEDIAN: f64 = 0.944;
/// Number of passes with down-weighting, and of passes in which the set of used rows may change.
const DAMPED_PASSES: usize = 8;
const CUT_PASSES: usize = 6;

impl Outliers {
    pub(super) const fn new() -> Self {
        Self { phase: Phase::Kept, changed: false, too_many: None }
    }

    /// Sets the weights of rows from their residuals.
    pub(super) fn weigh(&mut self, residuals: &[Vector6], weights: &mut [f64]) {
        let sizes: Vec<f64> = residuals.iter().map(size).collect();
        // If most rows have large residuals, the noise is larger than stated or the model is wrong.
        let scale = (median(&sizes) / MEDIAN).max(1.0);
        let far = sizes.iter().filter(|&&s| s > LIMIT * scale).count();
        self.changed = false;
        match self.phase {
            Phase::Kept if far > 0 => self.phase = Phase::Damped(0),
            Phase::Damped(DAMPED_PASSES) => self.phase = Phase::Cut(0),
            Phase::Damped(n) => self.phase = Phase::Damped(n + 1),
            Phase::Cut(CUT_PASSES) => self.phase = Phase::Settled,
            Phase::Cut(n) => self.phase = Phase::Cut(n + 1),
            _ => {}
        }
        match self.phase {
            Phase::Damped(_) => {
                self.changed = true;
                for (weight, s) in weights.iter_mut().zip(sizes) {
                    *weight = (DAMPED * scale / s).min(1.0);
                }
            }
            Phase::Cut(_) if 10 * far > sizes.len() => {
                self.too_many = Some(far);
                self.changed = true;
                weights.fill(1.0);
                self.phase = Phase::Settled;
            }
            Phase::Cut(_) => {
                for (weight, s) in weights.iter_mut().zip(sizes) {
                    let now = if s > LIMIT * scale { 0.0 } else { 1.0 };
                    self.changed |= *weight != now;
                    *weight = now;
                }
            }
            _ => {}
        }
    }
}

/// Returns the root mean square of the six residuals.
pub(super) fn size(residual: &Vector6) -> f64 {
    (dot(residual, residual) / 6.0).sqrt()
}

pub(super) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}
