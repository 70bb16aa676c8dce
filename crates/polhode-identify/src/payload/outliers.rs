//! Wrenches that are far off: damped until the numbers have settled, then left out.

use super::small::{Vector6, dot};

/// A wrench that was left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// Its row, from 0.
    pub row: usize,
    /// Root mean square of its six residuals, in standard deviations.
    pub size: f64,
}

/// Which rows count, as passes go by.
pub(super) struct Outliers {
    phase: Phase,
    /// Whether the last pass changed which rows count.
    pub(super) changed: bool,
    /// So many were far off that none was left out.
    pub(super) too_many: Option<usize>,
}

enum Phase {
    Kept,
    Damped(usize),
    Cut(usize),
    Settled,
}

/// Root mean square of six residuals: beyond this one row of three million.
const LIMIT: f64 = 2.7;
/// Where damping begins.
const DAMPED: f64 = 1.5;
/// √(median of χ² of 6 degrees of freedom, by 6).
const MEDIAN: f64 = 0.944;
/// Passes in which rows are damped, and in which the choice may change.
const DAMPED_PASSES: usize = 8;
const CUT_PASSES: usize = 6;

impl Outliers {
    pub(super) const fn new() -> Self {
        Self { phase: Phase::Kept, changed: false, too_many: None }
    }

    /// Weights of rows by their residuals at numbers that fit.
    pub(super) fn weigh(&mut self, residuals: &[Vector6], weights: &mut [f64]) {
        let sizes: Vec<f64> = residuals.iter().map(size).collect();
        // where most rows are far off the noise is larger than it is said to be, or the model is wrong
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

/// Root mean square.
pub(super) fn size(residual: &Vector6) -> f64 {
    (dot(residual, residual) / 6.0).sqrt()
}

pub(super) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}
