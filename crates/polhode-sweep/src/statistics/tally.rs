//! What one pass finds: counts, moments, extremes.

use std::collections::BTreeMap;

use super::sample::Sampled;
use super::values;
use crate::batch::{Batch, Values};
use crate::error::SweepError;
use crate::rows::MEMBER;

/// Failures that a summary shows.
const SHOWN: usize = 5;

/// Different texts of a column that are counted.
const MOST_TEXTS: usize = 1000;

/// What one pass finds.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Of each column of numbers.
    pub(super) moments: Vec<Moments>,
    /// How often each text stands in a column.
    pub(super) texts: BTreeMap<String, BTreeMap<String, u64>>,
    /// The first members that failed, and why.
    pub(super) failures: Vec<(u64, String)>,
    pub(super) sample: Sampled,
}

/// Of numbers: how many, their mean, Σ (x − mean)², the least and the largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments {
    pub(super) count: u64,
    pub(super) mean: f64,
    squares: f64,
    pub(super) min: f64,
    pub(super) max: f64,
}

impl Tally {
    /// Of the rows of a part.
    pub(super) fn of(batch: &Batch, names: &[&str], members: u64) -> Result<Self, SweepError> {
        let mut tally = Self {
            moments: names.iter().map(|name| Moments::of(|| values(batch, name))).collect(),
            sample: Sampled::of(batch, names, members),
            ..Self::default()
        };
        let Values::Whole(numbers) = &batch.column(MEMBER)?.values else { return Ok(tally) };
        for column in batch.columns() {
            let Values::Text(texts) = &column.values else { continue };
            if column.name == "cause" {
                let causes = numbers.iter().zip(texts);
                let causes = causes.filter_map(|(member, cause)| Some((*member, cause.clone()?)));
                tally.failures = causes.take(SHOWN).collect();
                continue;
            }
            let counts = tally.texts.entry(column.name.clone()).or_default();
            for text in texts.iter().flatten() {
                match counts.get_mut(text) {
                    Some(count) => *count += 1,
                    None => {
                        counts.insert(text.clone(), 1);
                    }
                }
            }
        }
        Ok(tally)
    }

    /// With that of the parts after it.
    pub(super) fn merge(mut self, other: Self) -> Self {
        for (mine, theirs) in self.moments.iter_mut().zip(&other.moments) {
            *mine = mine.merge(theirs);
        }
        for (column, counts) in other.texts {
            let mine = self.texts.entry(column).or_default();
            for (text, count) in counts {
                if mine.len() < MOST_TEXTS || mine.contains_key(&text) {
                    *mine.entry(text).or_default() += count;
                }
            }
        }
        self.failures.extend(other.failures);
        self.failures.truncate(SHOWN);
        self.sample.append(other.sample);
        self
    }
}

impl Moments {
    pub(super) fn of<I: Iterator<Item = f64>>(values: impl Fn() -> I) -> Self {
        let count = values().count() as u64;
        let mean = if count == 0 { 0.0 } else { sum(values()) / count as f64 };
        let squares = sum(values().map(|x| (x - mean) * (x - mean)));
        let min = values().fold(f64::INFINITY, f64::min);
        let max = values().fold(f64::NEG_INFINITY, f64::max);
        Self { count, mean, squares, min, max }
    }

    /// Σ (x − mean)² of both: M = Ma + Mb + δ² na nb / n, δ = mean_b − mean_a (Chan, Golub & LeVeque 1979).
    pub(super) fn merge(&self, other: &Self) -> Self {
        if other.count == 0 || self.count == 0 {
            return if self.count == 0 { *other } else { *self };
        }
        let count = self.count + other.count;
        let (a, b, n) = (self.count as f64, other.count as f64, count as f64);
        let delta = other.mean - self.mean;
        Self {
            count,
            mean: self.mean + delta * (b / n),
            squares: self.squares + other.squares + delta * delta * (a * (b / n)),
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// √(Σ (x − mean)² / (n − 1)); `None` of fewer than two.
    pub(super) fn standard_deviation(&self) -> Option<f64> {
        (self.count > 1).then(|| (self.squares / (self.count - 1) as f64).sqrt())
    }
}

/// A sum with its rounding errors added (Neumaier 1974).
fn sum(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut rest) = (0.0_f64, 0.0);
    for x in values {
        let next = sum + x;
        rest += if sum.abs() >= x.abs() { (sum - next) + x } else { (x - next) + sum };
        sum = next;
    }
    if sum.is_finite() { sum + rest } else { sum }
}
